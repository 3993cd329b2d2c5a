#include "core/assembly/crossing.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

Model ribs(FishBones &bones, std::map<std::string, ParameterValue> values)
{
    add(bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                                  std::move(values)));
    return evaluate(bones.document);
}

/// A section that ends nowhere near, in this plane.
Section plane(const Frame &frame)
{
    Section section;
    section.shape = shapeOf(polygonContour(rectangleAt(-50, -500, 100, 1000)));
    section.frame = frame;
    return section;
}

/// Of the longest overlap.
double depth(const Section &a, const Section &b)
{
    double longest = 0.0;
    for (const Overlap &o : findCrossing(*a.shape, a.frame, *b.shape, b.frame).overlaps)
        longest = std::max(longest, o.to - o.from);
    return longest;
}

} // namespace

class TestLinear : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void insideLengthsAreEqual_data();
    void insideLengthsAreEqual();
    void replicasKeepTheNormalAndShareTheShape();
    void sidesAndKeys();
    void scaleFollowsTheGirth_data();
    void scaleFollowsTheGirth();
    void withoutEqualDepthTheHeightStays();
    void wholeBranchGoesAlong();
    void hiddenHeadTakesItsBranch();
    void parallelInputsMakeNothing();
    void replicasBeyondTheRootAreLeftOut();
    void rangeBeyondTheSource();
};

void TestLinear::insideLengthsAreEqual_data()
{
    QTest::addColumn<QString>("scale");
    QTest::addColumn<QString>("direction");
    QTest::newRow("as they are") << "no"
                                 << "section";
    QTest::newRow("scaled") << "thickness"
                            << "section";
    QTest::newRow("stretched along the slit") << "thickness"
                                              << "slit";
}

// Wrong: ribs would sit loose here and stick out of the spine's back there.
void TestLinear::insideLengthsAreEqual()
{
    QFETCH(QString, scale);
    QFETCH(QString, direction);
    FishBones bones;
    const Model model = ribs(bones, {{"count", 12.0},
                                     {"side", std::string("both")},
                                     {"scale", scale.toStdString()},
                                     {"direction", direction.toStdString()},
                                     {"to", 0.9}});
    QCOMPARE(model.sectionCount(), 2U + 11U);
    const Section &spine = *model.section(0);
    const double own = depth(spine, *model.section(1));
    const double width = model.section(1)->shape->bounds().size().x();
    const double girth = depth(spine, plane(model.section(1)->frame));
    QVERIFY(own > 15.0 && own < girth - 5.0);
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        const double got = depth(spine, *model.section(i));
        const double room = depth(spine, plane(model.section(i)->frame));
        // In proportion to the size; where the spine is thinner than that, all of it is inside.
        const double wanted =
            scale == QLatin1String("no") ? own : own * std::max(0.1, room / girth);
        QVERIFY2(std::abs(got - std::min(wanted, room)) < 1e-6,
                 qPrintable(QStringLiteral("%1: %2 instead of %3")
                                .arg(i)
                                .arg(got, 0, 'g', 12)
                                .arg(std::min(wanted, room), 0, 'g', 12)));
        const bool isWhole = scale != QLatin1String("no") && direction == QLatin1String("section");
        const double ratio = isWhole ? std::max(0.1, room / girth) : 1.0;
        QVERIFY(std::abs(model.section(i)->shape->bounds().size().x() - ratio * width) < 0.02);
    }
}

// Wrong: a hundred ribs would cost a hundred times the work of one when one moves.
void TestLinear::replicasKeepTheNormalAndShareTheShape()
{
    FishBones bones;
    const Model model = ribs(bones, {});
    QCOMPARE(model.sectionCount(), 2U + 7U);
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        const Section &rib = *model.section(i);
        QCOMPARE(rib.shape, model.section(1)->shape);
        QVERIFY(rib.frame.normal() == model.section(1)->frame.normal());
        QVERIFY(!rib.id.isValid());
        QCOMPARE(model.indexOf(rib.ref()), static_cast<int>(i));
        QVERIFY(rib.parent && rib.parent->section == SectionRef(bones.spine));
    }
    QCOMPARE(model.section(2)->name, std::string("Rib 2"));
    QCOMPARE(model.section(8)->name, std::string("Rib 8"));
}

// Wrong: an exception would hit another rib after the side was changed.
void TestLinear::sidesAndKeys()
{
    const auto keysOf = [](const char *side) {
        FishBones bones;
        const Model model = ribs(
            bones,
            {{"repeatBy", std::string("spacing")}, {"spacing", 20.0}, {"side", std::string(side)}});
        std::map<std::string, double> keys;
        for (std::size_t i = 2; i < model.sectionCount(); ++i)
            keys.emplace(model.section(i)->made.key, model.section(i)->frame.origin.x());
        return keys;
    };
    const auto forward = keysOf("forward"), back = keysOf("back"), both = keysOf("both");
    // The rib's normal points along −X: x × y = Z × Y.
    QCOMPARE(forward.size(), 2U); // 40 and 20; at 0 the spine has come to its end
    QCOMPARE(forward.at("1"), 40.0);
    QCOMPARE(back.at("-1"), 80.0);
    QCOMPARE(both.size(), forward.size() + back.size());
    for (const auto &[key, x] : both)
        QCOMPARE(x, (key.front() == '-' ? back : forward).at(key));
}

void TestLinear::scaleFollowsTheGirth_data()
{
    QTest::addColumn<double>("strength");
    QTest::newRow("fully") << 1.0;
    QTest::newRow("half") << 0.5;
    QTest::newRow("not at all") << 0.0;
    QTest::newRow("twice") << 2.0;
}

// Wrong: ribs would not become smaller towards the tail.
void TestLinear::scaleFollowsTheGirth()
{
    QFETCH(double, strength);
    FishBones bones;
    const Model model = ribs(bones, {{"scale", std::string("thickness")},
                                     {"strength", strength},
                                     {"side", std::string("back")},
                                     {"to", 0.9}});
    const Section &spine = *model.section(0), &rib = *model.section(1);
    const auto girth = [&](const Section &at) { return depth(spine, plane(at.frame)); };
    const double width = rib.shape->bounds().size().x();
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        const double ratio = girth(*model.section(i)) / girth(rib);
        const double wanted = std::max(0.1, 1.0 + strength * (ratio - 1.0));
        // Of chords, which differ a little with the size.
        const double got = model.section(i)->shape->bounds().size().x() / width;
        QVERIFY2(std::abs(got - wanted) < 1e-3,
                 qPrintable(QStringLiteral("%1 instead of %2").arg(got).arg(wanted)));
    }
    if (strength == 0.0)
        QCOMPARE(model.section(2)->shape, rib.shape);
}

// Wrong: who asks for a plain row gets a wavy one.
void TestLinear::withoutEqualDepthTheHeightStays()
{
    FishBones bones;
    const Model model = ribs(bones, {{"equalDepth", false}, {"side", std::string("both")}});
    for (std::size_t i = 2; i < model.sectionCount(); ++i)
        QCOMPARE(model.section(i)->frame.origin.y(), 0.0);
}

// Wrong: legs would be repeated without their feet.
void TestLinear::wholeBranchGoesAlong()
{
    FishBones bones;
    const SectionId foot =
        add(bones.document, "Foot", shapeOf(polygonContour(rectangleAt(50, -10, 20, 20))),
            {{0, 20, 0}, Vec3::UnitX(), -Vec3::UnitZ()},
            Parent{SectionRef(bones.rib), {-10, 20}, {10, 20}});
    const SectionId toe =
        add(bones.document, "Toe", shapeOf(polygonContour(rectangleAt(55, 10, 10, 20))),
            frontFrame({0, 0, 5}), Parent{SectionRef(foot), {0, 0}, {1, 0}});
    const Model model = ribs(bones, {{"wholeBranch", true},
                                     {"count", 3.0},
                                     {"side", std::string("back")},
                                     {"scale", std::string("thickness")}});
    QCOMPARE(model.sectionCount(), 4U + 2U * 3U);
    const OperationId id = bones.document.operations[0]->id;
    for (const char *number : {"-1", "-2"}) {
        const std::string head = number;
        const std::string footKey = head + "/" + std::to_string(foot.value);
        const std::string toeKey = head + "/" + std::to_string(toe.value);
        const Section *rib = model.find({id, head}), *sole = model.find({id, footKey}),
                      *tip = model.find({id, toeKey});
        QVERIFY(rib && sole && tip);
        QCOMPARE(sole->parent->section, rib->ref());
        QCOMPARE(tip->parent->section, sole->ref());
        // What met before meets now.
        const double scale =
            rib->shape->bounds().size().x() / model.section(1)->shape->bounds().size().x();
        QVERIFY(std::abs(depth(*rib, *sole) - 20.0 * scale) < 0.1);
        QVERIFY(std::abs(depth(*sole, *tip) - 10.0 * scale) < 0.1);
        QVERIFY(std::abs(sole->shape->bounds().size().x() - 20.0 * scale) < 1e-2);
    }
}

// Wrong: feet would hang in the air where their leg was hidden.
void TestLinear::hiddenHeadTakesItsBranch()
{
    FishBones bones;
    add(bones.document, "Foot", shapeOf(polygonContour(rectangleAt(50, -10, 20, 20))),
        {{0, 20, 0}, Vec3::UnitX(), -Vec3::UnitZ()},
        Parent{SectionRef(bones.rib), {-10, 20}, {10, 20}});
    Operation rows = operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                               {{"wholeBranch", true}, {"count", 4.0}});
    rows.exceptions["2"].state = Exception::State::Hidden;
    add(bones.document, rows);
    const Model model = evaluate(bones.document);
    QCOMPARE(model.sectionCount(), 3U + 2U * 2U);
    QCOMPARE(model.indexOf({model.document.operations[0]->id, "2"}), -1);
}

// Wrong: a division by nothing, or a silent nothing.
void TestLinear::parallelInputsMakeNothing()
{
    FishBones bones;
    const SectionId other =
        add(bones.document, "Other", shapeOf(circle({0, 0}, 20)), frontFrame({0, 0, 30}));
    add(bones.document, operation("linear", {{"section", {other}}, {"along", {bones.spine}}}));
    add(bones.document, operation("linear", {{"section", {other}}, {"along", {other}}}));
    add(bones.document, operation("linear", {{"section", {}}, {"along", {other}}}));
    const Model model = evaluate(bones.document);
    QCOMPARE(model.sectionCount(), 3U);
    using Kind = OperationNotice::Kind;
    QCOMPARE(model.evaluation.results[0]->notices.front().kind, Kind::InputsApart);
    QCOMPARE(model.evaluation.results[1]->notices.front().kind, Kind::InputsApart);
    QCOMPARE(model.evaluation.results[2]->notices.front().kind, Kind::InputMissing);
    QCOMPARE(model.evaluation.results[2]->notices.front().role, std::string("section"));
}

// Wrong: ribs in the gap of a root would float.
void TestLinear::replicasBeyondTheRootAreLeftOut()
{
    Document document = newDocument();
    // A letter U: between its arms there is nothing at that height.
    const SectionId root =
        add(document, "U",
            shapeOf(polygonContour(
                {{0, 0}, {100, 0}, {100, 60}, {70, 60}, {70, 20}, {30, 20}, {30, 60}, {0, 60}})),
            frontFrame());
    const SectionId plate =
        add(document, "Plate", shapeOf(polygonContour(rectangleAt(-15, 40, 30, 60))),
            sideFrame({10, 0, 0}));
    add(document, operation("linear", {{"section", {plate}}, {"along", {root}}},
                            {{"repeatBy", std::string("spacing")},
                             {"spacing", 10.0},
                             {"side", std::string("back")}}));
    const Model model = evaluate(document);
    // They follow the arms' top; between them the foot's, 40 mm lower.
    for (std::size_t i = 2; i < model.sectionCount(); ++i) {
        const Section &replica = *model.section(i);
        const double x = replica.frame.origin.x();
        QVERIFY(std::abs(depth(*model.section(0), replica) - 20.0) < 1e-6);
        QVERIFY(std::abs(replica.frame.origin.y() - (x >= 30 && x <= 70 ? -40.0 : 0.0)) < 1e-6);
    }
    QVERIFY(model.sectionCount() >= 9);
}

// Wrong: a range that begins beyond the source would be filled from the source on.
void TestLinear::rangeBeyondTheSource()
{
    FishBones bones;
    // Forward is −X: the first half of the range is x = 200 … 100, the rib stands at 60.
    const Model model = ribs(bones, {{"count", 5.0}, {"side", std::string("both")}, {"to", 0.5}});
    QCOMPARE(model.sectionCount(), 2U + 4U);
    for (int k = 1; k <= 4; ++k) {
        const Section *rib = model.find({bones.document.operations[0]->id, std::to_string(-k)});
        QVERIFY(rib);
        QVERIFY(std::abs(rib->frame.origin.x() - (87.5 + 25.0 * k)) < 1e-9);
    }
}

FFF_TEST(TestLinear)
#include "tst_linear.moc"
