// Sections that both end at a corner: fingers of each between those of the other.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/assembly_plan.h"
#include "core/assembly/fingers.h"
#include "core/assembly/found_joint.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/line_oracle.h"
#include "tests/core/assembly/plan_replay.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

/// Two plates that leave the z axis, 80 mm long on it: one along x, the other turned towards y.
struct Corner
{
    double angle = 90.0;                   // degrees between them
    double one = 3.0, other = 3.0;         // thicknesses, mm
    double fromOne = 0.0, fromOther = 0.0; // where they begin, mm from the axis
    double clearance = 0.0;                // mm
    double length = 80.0;                  // mm

    Vec3 away() const
    {
        const double turn = angle * std::numbers::pi / 180.0;
        return {std::cos(turn), std::sin(turn), 0.0};
    }
    /// Of the other plate, on the side away from the first one.
    Vec3 outwards() const { return {-away().y(), away().x(), 0.0}; }

    Document document() const
    {
        Document document = newDocument();
        Stock stock = *document.stocks.front();
        stock.thickness = one;
        stock.clearance = clearance;
        document = *setStock(std::move(document), stock);
        stock.thickness = other;
        stock.name = "Other";
        document = *addStock(std::move(document), stock);
        const double half = 0.5 * length;
        const auto add = [&](double from, const Vec3 &x, StockId of) {
            NewSection section;
            section.shape = polygonShape(rectangle(from, -half, 60, half));
            section.frame = {Vec3(0, 50, 0), x, -Vec3::UnitZ()};
            section.stock = of;
            document = *addSection(std::move(document), section);
        };
        add(fromOne, Vec3::UnitX(), document.stocks[0]->id);
        add(fromOther, away(), document.stocks[1]->id);
        JointOverride wanted;
        wanted.a.drawn = document.sections[0]->id;
        wanted.b.drawn = document.sections[1]->id;
        wanted.kind = JointKind::Tabs;
        return *setJointOverride(std::move(document), wanted);
    }
};

int tabsIn(const std::vector<Slit> &slits)
{
    return static_cast<int>(std::count_if(
        slits.begin(), slits.end(), [](const Slit &slit) { return slit.role == SlitRole::Tab; }));
}

} // namespace

class TestFingers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyFit_data();
    void theyFit();
    void itIsTheSameWhereverTheyEnd();
    void aRightAngleIsFilled();
    void playIsLeftBetweenThem();
    void theirNumberFollowsFromTheLength_data();
    void theirNumberFollowsFromTheLength();
    void someHaveNone_data();
    void someHaveNone();
    void theyCarryForces();
};

void TestFingers::theyFit_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("one");
    QTest::addColumn<double>("other");
    for (const double angle : {30.5, 45.0, 60.0, 70.53, 90.0, 109.47, 120.0, 138.19, 149.5})
        for (const double other : {3.0, 1.5, 9.0})
            QTest::addRow("%g degrees, 3 and %g mm", angle, other) << angle << 3.0 << other;
}

// Wrong: what is cut does not go together, does not hold, or stands out of the other's face.
void TestFingers::theyFit()
{
    QFETCH(double, angle);
    QFETCH(double, one);
    QFETCH(double, other);
    const Corner corner{angle, one, other};
    const Analysis analysis = analysed(corner.document());
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(1));
    const Joint &joint = analysis.assembly.joints.front();
    QCOMPARE(joint.kind, JointKind::Tabs);
    QVERIFY(areFingers(analysis.assembly.slits[0]) && areFingers(analysis.assembly.slits[1]));
    const int count = tabsIn(analysis.assembly.slits[0]);
    QVERIFY(count >= 2);
    QCOMPARE(tabsIn(analysis.assembly.slits[1]), count - 1);
    QVERIFY(!analysis.grips.of(joint).held.empty());

    const std::vector<CutPlate> plates = platesOf(analysis.bodies);
    QCOMPARE(plates.size(), std::size_t(2));
    QVERIFY(!areInEachOther(plates[0], plates[1]));
    const ModelPlan plan = planOf(analysis);
    QCOMPARE(plan.plan.verdict, AssemblyPlan::Verdict::Possible);
    QCOMPARE(fault(analysis, plan), QString());
    const Frame &frame = analysis.model.section(0)->frame;
    for (const Vec2 &p : plates[0].region->outer)
        for (const double side : {-0.5, 0.5})
            QVERIFY(corner.outwards().dot(frame.toWorld(p) + side * one * frame.normal() -
                                          Vec3(0, 50, 0)) < 0.5 * other + 1e-5);
}

void TestFingers::itIsTheSameWhereverTheyEnd()
{
    for (const double angle : {60.0, 90.0, 130.0}) {
        const Analysis wanted = analysed(Corner{angle}.document());
        for (const double from : {-1.0, -0.3, 0.4, 1.0}) {
            const Analysis drawn = analysed(Corner{angle, 3.0, 3.0, from, -0.5 * from}.document());
            for (const std::size_t i : {0U, 1U}) {
                QCOMPARE(tabsIn(drawn.assembly.slits[i]), tabsIn(wanted.assembly.slits[i]));
                QVERIFY(std::abs(drawn.cuts[i]->area() - wanted.cuts[i]->area()) < 1e-3);
            }
        }
    }
}

// Two plates with a common edge of 3 × 3 mm: each has half of it, and the one more finger.
void TestFingers::aRightAngleIsFilled()
{
    const Analysis analysis = analysed(Corner{}.document());
    const double both = analysis.cuts[0]->area() + analysis.cuts[1]->area();
    QVERIFY(std::abs(both - (2.0 * 80.0 * 58.5 + 80.0 * 3.0)) < 1e-3);
}

void TestFingers::playIsLeftBetweenThem()
{
    Corner loose{};
    loose.clearance = 0.2;
    const Analysis analysis = analysed(loose.document());
    const int count = tabsIn(analysis.assembly.slits[0]) + tabsIn(analysis.assembly.slits[1]);
    const double both = analysis.cuts[0]->area() + analysis.cuts[1]->area();
    QVERIFY(std::abs(both - (2.0 * 80.0 * 58.5 + (80.0 - 0.1 * (count - 1)) * 3.0)) < 1e-3);
    QVERIFY(!analysis.grips.of(analysis.assembly.joints.front()).held.empty());
}

void TestFingers::theirNumberFollowsFromTheLength_data()
{
    QTest::addColumn<double>("length");
    QTest::addColumn<int>("count");
    QTest::newRow("too short") << 8.5 << 0;
    QTest::newRow("as short as can be") << 9.5 << 3;
    QTest::newRow("usual") << 80.0 << 7;
    QTest::newRow("long") << 400.0 << 43;
}

void TestFingers::theirNumberFollowsFromTheLength()
{
    QFETCH(double, length);
    QFETCH(int, count);
    Corner corner{};
    corner.length = length;
    const Model model = evaluate(corner.document());
    const auto tabs = tabsOf(model, 0, 1);
    QCOMPARE(tabs.has_value(), count > 0);
    if (tabs)
        QCOMPARE(tabsIn(tabs->slits.a) + tabsIn(tabs->slits.b), count);
    else
        QVERIFY(tabs.error() == NoTabs::NoRoom || tabs.error() == NoTabs::EndsNowhere);
}

void TestFingers::someHaveNone_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("from");
    QTest::newRow("nearly flat") << 151.0 << 0.0;
    QTest::newRow("nearly folded") << 29.0 << 0.0;
    QTest::newRow("it does not reach the other") << 90.0 << 2.5;
    QTest::newRow("both go on") << 90.0 << -20.0;
}

// Wrong: fingers that cannot be cut, or that hold nothing.
void TestFingers::someHaveNone()
{
    QFETCH(double, angle);
    QFETCH(double, from);
    const Model model = evaluate(Corner{angle, 3.0, 3.0, from, from}.document());
    QVERIFY(!tabsOf(model, 0, 1));
}

// Wrong: a box of sheets that falls apart as soon as anything is weighed.
void TestFingers::theyCarryForces()
{
    const Analysis analysis = analysed(Corner{}.document());
    const Joint &joint = analysis.assembly.joints.front();
    const std::vector<Grip> &held = analysis.grips.of(joint).held;
    QCOMPARE(held.size(), std::size_t(1));
    // Of seven fingers the two at the ends have one flank free.
    QVERIFY(std::abs(held.front().inB - 2 * 3.0) < 1e-6);
    QVERIFY(std::abs(held.front().inA - 3 * 3.0) < 1e-6);
}

FFF_TEST(TestFingers)
#include "tst_fingers.moc"
