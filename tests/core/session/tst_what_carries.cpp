// Verdicts on how a model stands speak of the solids that are cut, and of where these come to rest.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/findings/thin_necks.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/base/units.h"
#include "core/model/edits.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/assembly/settle_oracle.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/staged.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

Document ofThickness(double thickness, double clearance = 0.0)
{
    Document document = newDocument();
    Stock stock = *document.stocks.front();
    stock.thickness = thickness;
    stock.clearance = clearance;
    return *setStock(std::move(document), std::move(stock));
}

/// An arch on two feet, the right one of which ends so high.
ShapePointer arch(double high)
{
    return polygonShape(
        {{-40, 0}, {-30, 0}, {-30, 20}, {30, 20}, {30, high}, {40, high}, {40, 40}, {-40, 40}});
}

/// With a beam to its right.
ShapePointer archWithBeam(double high)
{
    return polygonShape({{-40, 0},
                         {-30, 0},
                         {-30, 20},
                         {30, 20},
                         {30, high},
                         {40, high},
                         {40, 40},
                         {80, 40},
                         {80, 50},
                         {-40, 50}});
}

/// A head heavy to the left, and a prop that leans by 60° to the right, its middle on the ground.
Document propped(double thickness)
{
    const ShapePointer head = polygonShape(
        {{-25, 0}, {25, 0}, {25, 100}, {15, 100}, {15, 160}, {-45, 160}, {-45, 120}, {-25, 90}});
    const double c = std::cos(std::numbers::pi / 6), s = 0.5;
    return withSection(withSection(ofThickness(thickness), head, front()), plateOf(-40, 0, 40, 60),
                       {Vec3::Zero(), -Vec3::UnitZ(), Vec3(-c, s, 0)});
}

/// All turned about the front's axis, and put down again.
Document tilted(double angle)
{
    const Vec3 x(std::cos(angle), std::sin(angle), 0), y(-std::sin(angle), std::cos(angle), 0);
    const Vec3 up(0, 40 * std::sin(angle), 0);
    const ShapePointer plate = plateOf(-40, 0, 40, 80);
    Document document = withSection(newDocument(), plate, {up, x, y});
    return withSection(std::move(document), plate, {up, -Vec3::UnitZ(), y});
}

SettleOracle settledOf(const Staged &all)
{
    std::vector<Vec3> points;
    double mass = 0.0;
    Vec3 centre = Vec3::Zero();
    for (const Body &body : all.analysis->bodies) {
        const Vec3 half = 0.5 * body.thickness() * body.frame().normal();
        for (const Vec2 &corner : body.outline().region.outer)
            for (const double side : {-1.0, 1.0})
                points.push_back(body.frame().toWorld(corner) + side * half);
        mass += body.mass().mass;
        centre += body.mass().mass * body.mass().centre;
    }
    return {points, centre / mass};
}

/// A triangle with a slit from above through its oblique side.
Document triangle(double clearance, double at)
{
    Document document = withSection(ofThickness(3.0, clearance),
                                    polygonShape({{-40, 0}, {40, 0}, {0, 80}}), front());
    return withSection(std::move(document), plateOf(-30, 0, 30, 60), side(at));
}

} // namespace

class TestWhatCarries : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itStandsAsItsSolidsRest_data();
    void itStandsAsItsSolidsRest();
    void whatHangsBesideIsAFoot_data();
    void whatHangsBesideIsAFoot();
    void leaningBearsAsStandingDoes();
    void aToothAtASlitsMouthHoldsNothing();
    void halfInAnotherIsNoJoint();
    void aWallThatBurnsAwayIsAnError();
};

void TestWhatCarries::itStandsAsItsSolidsRest_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<QByteArray>("kind");
    const auto on = [](const ShapePointer &one, const ShapePointer &other) {
        return withSection(withSection(newDocument(), one, front()), other, side());
    };
    QTest::newRow("level") << on(arch(0), arch(0)) << QByteArray("stands");
    // Wrong: "Barely stands", past 3 degrees.
    QTest::newRow("one leg a tenth short") << on(arch(0.1), arch(0)) << QByteArray("stands");
    // Wrong: "Falls over".
    QTest::newRow("short where the weight is")
        << on(archWithBeam(0.1), arch(0)) << QByteArray("stands");
    QTest::newRow("more than anybody overlooks")
        << on(archWithBeam(3), arch(0)) << QByteArray("leans");
    QTest::newRow("turned by a tenth of a degree") << tilted(radians(0.1)) << QByteArray("stands");
    QTest::newRow("turned by 3 degrees") << tilted(radians(3)) << QByteArray("leans");
    QTest::newRow("turned by 30 degrees") << tilted(radians(30)) << QByteArray("lineSupport");
    // Wrong: "Stands" on a face that is 5 mm below the ground, beside feet that then hang.
    QTest::newRow("on a thick prop") << propped(12) << QByteArray("lineSupport");
    QTest::newRow("a tenth above the ground")
        << moveAll(on(arch(0), arch(0)), {0, 0.1, 0}) << QByteArray("stands");
}

// By a way that knows no feet.
void TestWhatCarries::itStandsAsItsSolidsRest()
{
    QFETCH(Document, document);
    QFETCH(QByteArray, kind);
    const Staged all = staged(document);
    const auto found = std::find_if(all.found.begin(), all.found.end(), [](const Finding &one) {
        return one.details<Footing>() != nullptr;
    });
    QVERIFY(found != all.found.end());
    QCOMPARE(QByteArray(found->kind->name), kind);
    const Footing &footing = *found->details<Footing>();
    const SettleOracle oracle = settledOf(all);
    if (kind == "lineSupport") {
        QVERIFY(oracle.lean() > kSteadyTilt);
        return;
    }
    QVERIFY(std::abs(footing.lean - oracle.lean()) < radians(0.1));
    QVERIFY2(std::abs(footing.tipAngle - oracle.tipAngle()) < radians(2.5),
             qPrintable(QStringLiteral("%1 %2")
                            .arg(degrees(footing.tipAngle))
                            .arg(degrees(oracle.tipAngle()))));
}

// Wrong: forces along the drawn vertical on a ground that leans, which broke sections of 20 g.
void TestWhatCarries::whatHangsBesideIsAFoot_data()
{
    QTest::addColumn<double>("hangs"); // mm
    QTest::addColumn<bool>("isGood");
    QTest::newRow("0.3 mm") << 0.3 << true;
    QTest::newRow("0.5 mm") << 0.5 << true;
    QTest::newRow("2 mm") << 2.0 << false;
    QTest::newRow("4 mm") << 4.0 << false;
}

// Wrong: "Barely stands: the slightest push tips it over" of a plate on its edge, crossed by one
// that ends half a millimetre above the ground.
void TestWhatCarries::whatHangsBesideIsAFoot()
{
    QFETCH(double, hangs);
    QFETCH(bool, isGood);
    const Document document =
        withSection(withSection(newDocument(), plateOf(-40, 0, 40, 60), front()),
                    plateOf(-40, hangs, 40, 60), side());
    const Staged all = staged(document);
    const auto said = std::find_if(all.found.begin(), all.found.end(), [](const Finding &one) {
        return one.details<Footing>() != nullptr;
    });
    QVERIFY(said != all.found.end());
    QCOMPARE(said->is(isGood ? kStands : kLeans), true);
    QCOMPARE(said->severity, isGood ? Severity::Good : Severity::Warning);
    const Footing &footing = *said->details<Footing>();
    QCOMPARE(footing.lean, 0.0);
    const double rocks = std::atan(hangs / 38.5);
    QVERIFY(footing.rocking >= rocks - 1e-6 && footing.rocking < rocks + radians(0.2));
    QVERIFY(footing.tipAngle > radians(40));
    // Its energy: it comes down on the foot before the plate's edge lets it go.
    const SettleOracle oracle = settledOf(all);
    QVERIFY(std::abs(oracle.lean()) < radians(0.1));
}

void TestWhatCarries::leaningBearsAsStandingDoes()
{
    const Finding *level = nullptr;
    const Staged straight = staged(tilted(0.0));
    level = find(straight.found, kHolds);
    QVERIFY(level);
    for (const double angle : {0.1, 1.0, 3.0}) {
        const Staged all = staged(tilted(radians(angle)));
        const Finding *found = find(all.found, kHolds);
        QVERIFY2(found, qPrintable(QString::number(angle)));
    }
}

// Wrong: "Falls apart", because a tooth of 0.03 mm stands beside the mouth of a slit.
void TestWhatCarries::aToothAtASlitsMouthHoldsNothing()
{
    for (const double clearance : {0.0, 0.05, 0.1, 0.12, 0.15, 0.2, 0.3})
        for (const double at : {10.0, 15.0, 20.0, 25.0, 30.0}) {
            const Staged all = staged(triangle(clearance, at));
            QVERIFY2(!find(all.found, kHangsByNothing),
                     qPrintable(QStringLiteral("%1 %2").arg(clearance).arg(at)));
        }
}

// Wrong: a plate that ends in the middle of another one, 6 mm of it, was told and let pass.
void TestWhatCarries::halfInAnotherIsNoJoint()
{
    for (const double thickness : {1.0, 3.0, 12.0}) {
        const ShapePointer plate = plateOf(-20, 0, 20, 80);
        Document document = ofThickness(thickness);
        for (const double right : {-50.0, 50.0})
            for (Frame frame : {front(), side()}) {
                frame.origin.x() = right;
                document = withSection(std::move(document), plate, frame);
            }
        const Frame shelf{{0, 40, 15}, Vec3::UnitX(), -Vec3::UnitZ()};
        document = withSection(std::move(document), plateOf(-58, -15, 58, 15), shelf);
        const Staged all = staged(document);
        const Finding *found = find(all.found, kInterference);
        QVERIFY(found);
        QCOMPARE(found->severity, thickness > 2.0 ? Severity::Error : Severity::Warning);
    }
}

void TestWhatCarries::aWallThatBurnsAwayIsAnError()
{
    for (const double wall : {0.15, 0.6}) {
        Document document = withSection(newDocument(), plateOf(-40, 0, 40, 80), front());
        document = withSection(std::move(document), plateOf(-30, 0, 30, 60), side(40 - 1.5 - wall));
        const Staged all = staged(document);
        const Finding *found = find(all.found, kThinWeb);
        QVERIFY(found);
        QCOMPARE(found->severity, wall < 0.3 ? Severity::Error : Severity::Warning);
    }
}

FFF_TEST(TestWhatCarries)
#include "tst_what_carries.moc"
