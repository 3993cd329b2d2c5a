// Crossings of two sections that FlatFab gets wrong: it compares two numbers of each section, in
// right-angled crossings of single stretches. If one of these fails, so does ours.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/found_joint.h"
#include "core/base/units.h"
#include "tests/core/assembly/plan_replay.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// Open to the top (+y): two posts and a floor.
const Polygon kU{{-30, -30}, {30, -30},  {30, 30},  {10, 30},
                 {10, -10},  {-10, -10}, {-10, 30}, {-30, 30}};
/// A back and four teeth to the right.
const Polygon kComb{{-30, -35}, {30, -35}, {30, -25}, {-10, -25}, {-10, -15}, {30, -15},
                    {30, -5},   {-10, -5}, {-10, 5},  {30, 5},    {30, 15},   {-10, 15},
                    {-10, 25},  {30, 25},  {30, 35},  {-30, 35}};

Polygon moved(Polygon polygon, const Vec2 &by)
{
    for (Vec2 &p : polygon)
        p += by;
    return polygon;
}

/// x and y changed over: seen from the front, it lies on its side.
Polygon lying(const Polygon &polygon)
{
    Polygon result;
    for (const Vec2 &p : polygon)
        result.push_back({p.y(), p.x()});
    return result;
}

struct Pair
{
    ShapePointer a, b; // a from the front
    Frame frame;       // of b
    JointKind kind = JointKind::CrossLap;
    int slits = 2; // of both
    bool goesTogether = true;
};

} // namespace

class TestHardCrossings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fit_data();
    void fit();
    void whatCannotSlideSaysWhy_data();
    void whatCannotSlideSaysWhy();
};

void TestHardCrossings::fit_data()
{
    QTest::addColumn<Pair>("pair");
    const auto add = [](const char *name, const Pair &pair) { QTest::newRow(name) << pair; };
    const ShapePointer plate = polygonShape(rectangle(-40, -40, 40, 40));
    const ShapePointer small = polygonShape(rectangle(-20, -20, 20, 20));
    const ShapePointer strip = polygonShape(rectangle(-40, -5, 40, 5));

    add("one wholly inside of the other along the axis",
        {plate, small, side(), JointKind::ExtendedCrossLap, 2});
    add("and at the other's very edge",
        {plate, polygonShape(rectangle(-20, -40, 20, -10)), side(), JointKind::CrossLap, 2});
    add("a bar that a tall plate reaches beyond at both ends",
        {polygonShape(rectangle(-40, -4, 40, 4)), plate, side(), JointKind::ExtendedCrossLap, 2});
    add("an overlap that begins where both begin",
        {plate, polygonShape(rectangle(-30, -40, 30, 10)), side(), JointKind::CrossLap, 2});
    add("an overlap that ends where both end",
        {plate, polygonShape(rectangle(-30, -10, 30, 40)), side(), JointKind::CrossLap, 2});
    add("both equally high", {plate, plate, side(), JointKind::CrossLap, 2});
    add("both end at one corner",
        {plate, polygonShape({{-30, 0}, {0, -40}, {30, 0}}), side(), JointKind::CrossLap, 2});

    add("a U that stands astride a plate",
        {polygonShape(rectangle(-40, -60, 40, 0)), polygonShape(kU),
         Frame{{0, 0, 0}, -Vec3::UnitZ(), -Vec3::UnitY()}, JointKind::CrossLap, 0});
    add("a U through whose both posts a plate goes",
        {polygonShape(rectangle(-40, -20, 40, 60)), polygonShape(lying(kU)), side(),
         JointKind::ExtendedCrossLap, 4});
    add("a comb across a plate",
        {polygonShape(rectangle(-40, -50, 40, 50)), polygonShape(moved(kComb, {-5, 0})), side(),
         JointKind::ExtendedCrossLap, 8});
    add("two combs", {polygonShape(moved(kComb, {-5, 0})), polygonShape(moved(kComb, {-5, 5})),
                      side(), JointKind::CrossLap, 8});

    const ShapePointer frame =
        polygonShape(rectangle(-40, -40, 40, 40), {rectangle(-25, -25, 25, 25)});
    add("all of it inside of a hole", {frame, small, side(), JointKind::CrossLap, 0});
    add("from a hole through the edge",
        {frame, polygonShape(rectangle(-20, -20, 20, 60)), side(), JointKind::ExtendedCrossLap, 2});
    add("right across a hole",
        {frame, polygonShape(rectangle(-20, -60, 20, 60)), side(), JointKind::ExtendedCrossLap, 3});

    for (const double degrees : {20.0, 30.0, 45.0, 70.0})
        QTest::addRow("at %g degrees", degrees)
            << Pair{plate, polygonShape(rectangle(-60, -40, 60, 10)), turned(radians(degrees)),
                    JointKind::CrossLap, 2};
    add("leaning over, with oblique ends",
        {polygonShape({{-40, -30}, {40, -10}, {40, 30}, {-40, 10}}),
         polygonShape({{-60, -5}, {60, 15}, {60, 50}, {-60, 60}}), turned(radians(40.0)),
         JointKind::CrossLap, 2});
    // Its second tooth ends 1 mm beside the axis, in the slab of the other one.
    add("a tooth that ends beside the axis", {plate,
                                              polygonShape({{-40, -60},
                                                            {40, -60},
                                                            {40, -20},
                                                            {-10, -20},
                                                            {-10, 0},
                                                            {-1, 0},
                                                            {-1, 20},
                                                            {-40, 20}}),
                                              side(), JointKind::CrossLap, 3});
    // A foot stands on the other's face, beside what crosses it.
    const ShapePointer wall = polygonShape(rectangle(-30, 0, 30, 60));
    for (const double edge : {1.5, 1.5000004, 1.4999996, 1.52})
        QTest::addRow("a foot whose edge is %.7f mm beside the axis", edge)
            << Pair{polygonShape({{-20, 0},
                                  {30, 0},
                                  {30, 60},
                                  {edge, 60},
                                  {edge, 40},
                                  {20, 40},
                                  {20, 10},
                                  {-20, 10}}),
                    wall, side(), JointKind::CrossLap, 2};
    // Shoulders on the other's face between two tongues that go through it.
    add("shoulders on the face between tongues",
        {polygonShape({{1.5, -40},
                       {40, -40},
                       {40, 40},
                       {1.5, 40},
                       {1.5, 30},
                       {-20, 30},
                       {-20, 10},
                       {1.5, 10},
                       {1.5, -10},
                       {-20, -10},
                       {-20, -30},
                       {1.5, -30}}),
         polygonShape(rectangle(-30, -60, 30, 60)), side(), JointKind::ExtendedCrossLap, 4});
}

/// What would be wrong: slits that are not there, on the wrong side or too short, so that parts are
/// in each other, or cannot be brought together.
void TestHardCrossings::fit()
{
    QFETCH(Pair, pair);
    AnalysisCaches caches;
    const Analysis analysis = analyse(twoSections(pair.a, front(), pair.b, pair.frame), caches);
    QCOMPARE(
        static_cast<int>(analysis.assembly.slits[0].size() + analysis.assembly.slits[1].size()),
        pair.slits);
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(pair.slits > 0));
    if (pair.slits > 0)
        QCOMPARE(static_cast<int>(analysis.assembly.joints.front().kind),
                 static_cast<int>(pair.kind));
    const ModelPlan plan = planOf(analysis);
    const std::vector<CutPlate> plates = platesOf(analysis.bodies);
    QCOMPARE(plates.size(), std::size_t(2));
    QVERIFY(!areInEachOther(plates[0], plates[1]));
    QCOMPARE(plan.plan.verdict == AssemblyPlan::Verdict::Possible, pair.goesTogether);
    QCOMPARE(fault(analysis, plan), QString());
    if (pair.slits == 0)
        return;
    // Any deeper, and they are: nothing is cut that need not be.
    const Slide slide = slidesOf(analysis).front();
    if (analysis.assembly.joints.front().crossing->angle > radians(89.0))
        QVERIFY(areInEachOther(plates[0], plates[1], -2e-3 * slide.direction, 0.4e-3));
}

void TestHardCrossings::whatCannotSlideSaysWhy_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<int>("why");
    const auto add = [](const char *name, const ShapePointer &a, const ShapePointer &b, NoSlit why,
                        double clearance = 0.0) {
        Document document = withSection(withSection(newDocument(), a, front()), b, side());
        Stock thin = birchPlywood();
        thin.thickness = 0.5;
        document = *addStock(std::move(document), thin);
        document = *setSectionStock(document, document.sections[1]->id, document.stocks[1]->id);
        Stock stock = *document.stocks.front();
        stock.clearance = clearance;
        QTest::newRow(name) << *setStock(std::move(document), stock) << static_cast<int>(why);
    };
    const ShapePointer plate = polygonShape(rectangle(-40, -40, 40, 40));
    add("a clearance that presses by more than the other's thickness", plate, plate,
        NoSlit::NoWidth, -0.75);
    add("a bar between windows that would go up here and down there",
        polygonShape(rectangle(-40, -40, 40, 40), {rectangle(-20, -20, 20, 20)}),
        polygonShape(rectangle(-40, -60, 40, 60),
                     {rectangle(-20, -45, 20, -30), rectangle(-20, 30, 20, 45)}),
        NoSlit::OppositeWays);
    add("frames whose bars cross",
        polygonShape(rectangle(-40, 0, 40, 110), {rectangle(-20, 20, 20, 90)}),
        polygonShape(rectangle(-40, 10, 40, 100), {rectangle(-20, 30, 20, 80)}),
        NoSlit::NothingHolds);
    add("bars between windows of both",
        polygonShape(rectangle(-40, -40, 40, 60),
                     {rectangle(-20, -20, 20, 0), rectangle(-20, 10, 20, 30)}),
        polygonShape(rectangle(-15, -8, 15, 28),
                     {rectangle(-10, -5, 10, 5), rectangle(-10, 15, 10, 25)}),
        NoSlit::Enclosed);
}

/// What would be wrong: "no slit" without a word of what to do about it, or with the wrong one.
void TestHardCrossings::whatCannotSlideSaysWhy()
{
    QFETCH(Document, document);
    QFETCH(int, why);
    const Model model = evaluate(document);
    const Assembly assembly = assemble(model);
    QCOMPARE(assembly.joints.size(), std::size_t(1));
    QCOMPARE(static_cast<int>(assembly.joints.front().kind), static_cast<int>(JointKind::None));
    QCOMPARE(static_cast<int>(whyNoSlit(model, assembly.joints.front())), why);
    // Unless it is wanted to be so.
    JointOverride wanted;
    wanted.a = model.ref(0);
    wanted.b = model.ref(1);
    wanted.kind = JointKind::None;
    const Model apart = evaluate(*setJointOverride(document, wanted));
    QCOMPARE(static_cast<int>(whyNoSlit(apart, assemble(apart).joints.front())),
             static_cast<int>(NoSlit::Wanted));
}

FFF_TEST(TestHardCrossings)
#include "tst_hard_crossings.moc"
