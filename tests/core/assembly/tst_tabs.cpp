// Sections that end on others' faces.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/assembly_plan.h"
#include "core/assembly/found_joint.h"
#include "core/assembly/joint_state.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/line_oracle.h"
#include "tests/core/assembly/plan_replay.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Lying, x to the right, y to the back.
Frame lying(double height)
{
    return {{0, height, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
}

Document wanting(Document document, JointKind kind)
{
    JointOverride wanted;
    wanted.a.drawn = document.sections[0]->id;
    wanted.b.drawn = document.sections[1]->id;
    wanted.kind = kind;
    return *setJointOverride(std::move(document), wanted);
}

/// A wall 100 high and 80 deep, and a shelf from `from` to 60 mm beside it.
Document shelf(double from, const std::vector<Polygon> &holes = {})
{
    const Document wall =
        withSection(newDocument(), polygonShape(rectangle(-40, 0, 40, 100), holes), side());
    return wanting(withSection(wall, polygonShape(rectangle(from, -30, 60, 30)), lying(50)),
                   JointKind::Tabs);
}

int countOf(const std::vector<Slit> &slits, SlitRole role)
{
    return static_cast<int>(std::count_if(slits.begin(), slits.end(),
                                          [role](const Slit &s) { return s.role == role; }));
}

QString oracle(const Analysis &analysis)
{
    const ModelPlan plan = planOf(analysis);
    const std::vector<CutPlate> plates = platesOf(analysis.bodies);
    for (std::size_t i = 0; i < plates.size(); ++i)
        for (std::size_t k = i + 1; k < plates.size(); ++k)
            if (areInEachOther(plates[i], plates[k]))
                return QStringLiteral("%1 and %2 are in each other").arg(i).arg(k);
    if (plan.plan.verdict != AssemblyPlan::Verdict::Possible)
        return QStringLiteral("no plan");
    return fault(analysis, plan);
}

} // namespace

class TestTabs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itIsTheSameWhereverItEnds_data();
    void itIsTheSameWhereverItEnds();
    void tabsFit_data();
    void tabsFit();
    void numberFollowsFromTheLength_data();
    void numberFollowsFromTheLength();
    void someCannotHaveTabs_data();
    void someCannotHaveTabs();
    void anEditTellsTheSameAsFromScratch();
    void theyAreOnlyHadWhereTheyAreWanted();
};

void TestTabs::itIsTheSameWhereverItEnds_data()
{
    QTest::addColumn<double>("from");
    QTest::newRow("before the face") << 1.9;
    QTest::newRow("on the face") << 1.5;
    QTest::newRow("in the slab") << 0.7;
    QTest::newRow("on the mid-plane") << 0.0;
    QTest::newRow("beyond the mid-plane") << -0.8;
    QTest::newRow("on the other face") << -1.5;
    QTest::newRow("behind the other face") << -1.9;
}

// Wrong: how exactly somebody drew an end decides how the joint looks, or whether there is one.
void TestTabs::itIsTheSameWhereverItEnds()
{
    QFETCH(double, from);
    const Analysis analysis = analysed(shelf(from));
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(1));
    const Joint &joint = analysis.assembly.joints.front();
    QCOMPARE(joint.kind, JointKind::Tabs);
    QCOMPARE(joint.crossing->overlaps.size(), std::size_t(1));
    QCOMPARE(countOf(analysis.assembly.slits[0], SlitRole::Slit), 3); // 60 mm of 3 mm
    QCOMPARE(countOf(analysis.assembly.slits[1], SlitRole::Tab), 3);
    // What of the shelf is beside the wall, and three tabs of 10 × 3 in it, over the gap if any.
    const double gap = std::max(0.0, from - 1.5);
    QVERIFY(std::abs(analysis.cuts[1]->area() - (60 * (58.5 - gap) + 3 * 10 * (3 + gap))) < 1e-3);
    QVERIFY(std::abs(analysis.cuts[0]->area() - (80 * 100 - 3 * 10 * 3)) < 1e-3);
    QCOMPARE(analysis.cuts[1]->parts().size(), std::size_t(1));
    for (const CurvedRegion &part : analysis.cuts[1]->parts()) {
        const Box2 box = bounds(part.region.outer);
        QVERIFY(std::abs(box.min.x() + 1.5) < 1e-5); // flush
    }
    QCOMPARE(oracle(analysis), QString());
}

void TestTabs::tabsFit_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("roll");
    QTest::newRow("square") << 90.0 << 0.0;
    QTest::newRow("leaning") << 70.0 << 0.0;
    QTest::newRow("leaning far") << 40.0 << 0.0;
    QTest::newRow("at the least angle") << 30.1 << 0.0;
    QTest::newRow("turned in its plane") << 90.0 << 20.0;
    QTest::newRow("leaning and turned") << 55.0 << -15.0;
    QTest::newRow("from the other side") << 120.0 << 0.0;
}

// Wrong: what is cut does not go together. Contours are made up, with holes in the wall.
void TestTabs::tabsFit()
{
    QFETCH(double, angle);
    QFETCH(double, roll);
    std::mt19937 random(20141005);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    int joined = 0;
    for (int k = 0; k < 12; ++k) {
        std::vector<Polygon> holes;
        for (int h = 0; h < 3; ++h) {
            const double x = -30 + 22 * h, y = 40 + 40 * (uniform(random) - 0.5);
            holes.push_back(rectangle(x, y, x + 6, y + 8 * uniform(random) + 2));
        }
        Document document =
            withSection(newDocument(), polygonShape(rectangle(-40, 0, 40, 100), holes), side());
        // A trapezium, a notch in its end: it ends on the wall in two places.
        const double end = 3.0 * (uniform(random) - 0.5), wide = 20 + 15 * uniform(random);
        const double notch = 10 * uniform(random), foot = 6 * (uniform(random) - 0.5);
        const Polygon plate{
            {end, -wide},      {60, -wide - foot},     {60, wide},       {end, wide}, {end, notch},
            {end + 15, notch}, {end + 15, -notch / 2}, {end, -notch / 2}};
        const double lean = (angle - 90.0) * std::numbers::pi / 180.0;
        const double turn = roll * std::numbers::pi / 180.0;
        Frame frame;
        frame.origin = Vec3(0, 50, 0);
        frame.x = Vec3(std::cos(lean), std::sin(lean), 0);
        frame.y = -Vec3::UnitZ();
        // Turned about the normal of the wall, it still ends on it.
        const Eigen::AngleAxisd about(turn, Vec3::UnitX());
        frame.x = about * frame.x;
        frame.y = about * frame.y;
        document = withSection(std::move(document), polygonShape(plate), frame);
        const Analysis analysis = analysed(wanting(std::move(document), JointKind::Tabs));
        if (analysis.assembly.joints.empty() ||
            analysis.assembly.joints.front().kind != JointKind::Tabs)
            continue;
        ++joined;
        const QString fault = oracle(analysis);
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(k).arg(fault)));
    }
    QVERIFY2(joined >= 6, qPrintable(QString::number(joined)));
}

void TestTabs::numberFollowsFromTheLength_data()
{
    QTest::addColumn<double>("length");
    QTest::addColumn<int>("count");
    QTest::newRow("as long as two thicknesses") << 6.1 << 1;
    QTest::newRow("one share") << 24.0 << 1;
    QTest::newRow("nearly two") << 40.0 << 2;
    QTest::newRow("long") << 76.0 << 3;
}

// Wrong: a long edge hangs on one tab, or a short one is cut to crumbs.
void TestTabs::numberFollowsFromTheLength()
{
    QFETCH(double, length);
    QFETCH(int, count);
    Document wall = withSection(newDocument(), polygonShape(rectangle(-60, 0, 60, 100)), side());
    const double half = 0.5 * length;
    const Analysis analysis = analysed(
        wanting(withSection(wall, polygonShape(rectangle(1.5, -half, 60, half)), lying(50)),
                JointKind::Tabs));
    const std::vector<Slit> &slits = analysis.assembly.slits[1];
    QCOMPARE(countOf(slits, SlitRole::Tab), count);
    for (const Slit &slit : slits) {
        if (slit.role != SlitRole::Tab)
            continue;
        QVERIFY(slit.width >= 3.0 && slit.width <= 18.0);
        QVERIFY(std::abs(slit.width - 0.5 * length / count) < 1e-9);
    }
}

void TestTabs::someCannotHaveTabs_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<JointObstacle>("obstacle");
    const auto with = [](const Polygon &shelf, const Frame &frame) {
        Document wall =
            withSection(newDocument(), polygonShape(rectangle(-40, 0, 40, 100)), side());
        return withSection(std::move(wall), polygonShape(shelf), frame);
    };
    QTest::newRow("both go through")
        << with(rectangle(-60, -30, 60, 30), lying(50)) << JointObstacle::EndsNowhere;
    QTest::newRow("one goes through at one place")
        << with({{0, -30}, {60, -30}, {60, 30}, {-20, 30}, {-20, 10}, {0, 10}}, lying(50))
        << JointObstacle::EndsNowhere;
    QTest::newRow("too short") << with(rectangle(-1, -2, 60, 2), lying(50))
                               << JointObstacle::NoRoom;
    QTest::newRow("just below the wall's upper edge")
        << with(rectangle(-1, -30, 60, 30), lying(97.5)) << JointObstacle::NoRoom;
    QTest::newRow("both at a corner, too short for fingers")
        << with(rectangle(-1, -4, 60, 4), lying(98.5)) << JointObstacle::NoRoom;
    const double lean = 65 * std::numbers::pi / 180;
    QTest::newRow("nearly along the wall")
        << with(rectangle(-1, -30, 60, 30),
                {{0, 50, 0}, Vec3(std::cos(lean), std::sin(lean), 0), -Vec3::UnitZ()})
        << JointObstacle::TooOblique;
}

// Wrong: tabs are promised that cannot be made, or it is not said why.
void TestTabs::someCannotHaveTabs()
{
    QFETCH(Document, document);
    QFETCH(JointObstacle, obstacle);
    const Model model = evaluate(document);
    const std::optional<JointState> state = jointState(model, JointRef(model.ref(0), model.ref(1)));
    QVERIFY(state.has_value());
    QCOMPARE(state->obstacleTo(JointKind::Tabs), obstacle);
    // Wanted all the same, it is as if it were not.
    const Analysis analysis = analysed(document);
    const Analysis wanted = analysed(wanting(document, JointKind::Tabs));
    QCOMPARE(wanted.assembly.joints.front().kind, analysis.assembly.joints.front().kind);
    QVERIFY(wanted.assembly.slits[0] == analysis.assembly.slits[0]);
}

// Wrong: after an edit, joints of sections that only touch are lost, or those that went stay.
void TestTabs::anEditTellsTheSameAsFromScratch()
{
    AnalysisCaches caches;
    Document document = shelf(1.5);
    const std::vector<double> heights{50, 51, 120, 50, -40, 20};
    const SectionId moved = document.sections[1]->id;
    for (const double height : heights) {
        document = *moveSection(document, moved, lying(height));
        const Analysis next = analyse(evaluate(document), caches);
        const Analysis fresh = analysed(document);
        QCOMPARE(next.assembly.joints.size(), fresh.assembly.joints.size());
        for (std::size_t i = 0; i < 2; ++i)
            QVERIFY(next.assembly.slits[i] == fresh.assembly.slits[i]);
        QCOMPARE(next.assembly.joints.size(),
                 std::size_t(height > 0 && height < 100 ? 1 : 0)); // beside the wall or not
    }
    JointOverride none;
    none.a.drawn = document.sections[0]->id;
    none.b.drawn = document.sections[1]->id;
    document = *setJointOverride(document, none);
    QVERIFY(analyse(evaluate(document), caches).assembly.joints.empty());
}

// Wrong: models that were made before have joints of a kind that nobody asked for.
void TestTabs::theyAreOnlyHadWhereTheyAreWanted()
{
    Document touching = shelf(1.5), crossing = shelf(-0.5);
    for (Document *document : {&touching, &crossing}) {
        JointOverride none;
        none.a.drawn = document->sections[0]->id;
        none.b.drawn = document->sections[1]->id;
        *document = *setJointOverride(*document, none);
    }
    QVERIFY(analysed(touching).assembly.joints.empty());
    const Model model = evaluate(touching);
    QVERIFY(tabsOf(model, 0, 1).has_value());
    QVERIFY(analysed(crossing).assembly.joints.front().kind != JointKind::Tabs);
    // And back: what geometry makes of it, and none where it only touches.
    const Model tabbed = evaluate(shelf(-0.5));
    const std::optional<JointState> state =
        jointState(tabbed, JointRef(tabbed.ref(0), tabbed.ref(1)));
    QVERIFY(state.has_value());
    QCOMPARE(state->kind, JointKind::Tabs);
    QCOMPARE(state->obstacleTo(JointKind::ExtendedCrossLap), JointObstacle::None);
    const JointOverride lap = withKind(tabbed, *state, JointKind::ExtendedCrossLap);
    QVERIFY(!lap.kind);
    const Model edge = evaluate(shelf(1.5));
    QCOMPARE(jointState(edge, JointRef(edge.ref(0), edge.ref(1)))->obstacleTo(JointKind::CrossLap),
             JointObstacle::DoNotCross);
}

FFF_TEST(TestTabs)
#include "tst_tabs.moc"
