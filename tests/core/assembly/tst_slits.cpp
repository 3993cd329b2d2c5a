#include "core/assembly/assembly.h"
#include "core/assembly/slits.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Assembly assembled(const Model &model)
{
    return assemble(model);
}

/// World height (Y) of a slit's bottom and mouth.
std::pair<double, double> heights(const Model &model, std::size_t section, const Slit &slit)
{
    const Frame &frame = model.section(section)->frame;
    return {frame.toWorld(slit.inner).y(), frame.toWorld(slit.mouth).y()};
}

} // namespace

class TestSlits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void widthAtAnAngle();
    void halfLapOpensWhereEachEnds();
    void equalExtentsOpenByTheLowerId();
    void reachingBeyondExtendsTheSlit();
    void overlapInsideAHoleOpensOutwards();
    void windowOnTheAxisLeavesOneGrip();
    void windowsInBothHoldNowhere();
    void plateThroughARingGetsAMortise();
    void toothTooWideForItsMortiseCollides();
    void obliqueMouthOpensAllAcross();
    void severalOverlapsSlideOneWay();
    void touchingIsNoJoint();
    void swappingTheSectionsGivesTheSameSlits();
    void turningTheModelTurnsTheSlits();
    void thicknessOfTheOtherIsTheWidth();
    void slitsWithoutWidthAreNone();
};

// A slit narrower than this does not take the oblique sheet; wider and it wobbles.
void TestSlits::widthAtAnAngle()
{
    const Model square = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                     polygonShape(rectangle(-50, 0, 50, 40)), side());
    QCOMPARE(assembled(square).slits[0].at(0).width, 3.0);
    const Model oblique = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                      polygonShape(rectangle(-50, 0, 50, 40)), turned(radians(60)));
    QVERIFY(std::abs(assembled(oblique).slits[0].at(0).width -
                     (3.0 + 3.0 * std::cos(radians(60))) / std::sin(radians(60))) < 1e-9);
}

void TestSlits::halfLapOpensWhereEachEnds()
{
    // a from 0 to 50, b from 20 to 90: a ends at 50, so it opens up; they meet at 35.
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(-50, 20, 50, 90)), side());
    const Assembly assembly = assembled(model);
    QCOMPARE(assembly.joints.size(), std::size_t(1));
    QCOMPARE(assembly.joints[0].kind, JointKind::CrossLap);
    const auto [innerA, mouthA] = heights(model, 0, assembly.slits[0].at(0));
    const auto [innerB, mouthB] = heights(model, 1, assembly.slits[1].at(0));
    QCOMPARE(innerA, 35.0);
    QCOMPARE(innerB, 35.0);
    QVERIFY(mouthA >= 50.0 && mouthA < 50.2);
    QVERIFY(mouthB <= 20.0 && mouthB > 19.8);
}

void TestSlits::equalExtentsOpenByTheLowerId()
{
    // Two plates on the ground; also when rounding makes one a hair longer than the other.
    for (const double hair : {0.0, 1e-9, -1e-9, 1e-4}) {
        const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                        polygonShape(rectangle(-50, hair, 50, 50 - hair)), side());
        const Assembly assembly = assembled(model);
        QVERIFY(heights(model, 0, assembly.slits[0].at(0)).second > 49.0);
        QVERIFY(heights(model, 1, assembly.slits[1].at(0)).second < 1.0);
    }
}

void TestSlits::reachingBeyondExtendsTheSlit()
{
    // b reaches from −30 to 60 beyond a (0 … 50) at both ends, less far above: it is cut from
    // above.
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(-50, -30, 50, 60)), side());
    const Assembly assembly = assembled(model);
    QCOMPARE(assembly.joints[0].kind, JointKind::ExtendedCrossLap);
    const auto [innerA, mouthA] = heights(model, 0, assembly.slits[0].at(0));
    const auto [innerB, mouthB] = heights(model, 1, assembly.slits[1].at(0));
    QCOMPARE(innerA, 25.0);
    QCOMPARE(innerB, 25.0);
    QVERIFY(mouthB >= 60.0);
    QVERIFY(mouthA <= 0.0);
}

void TestSlits::overlapInsideAHoleOpensOutwards()
{
    // b ends within a's hole: opening there would be opening into the hole.
    const Model model =
        twoSections(polygonShape(rectangle(-50, 0, 50, 100), {rectangle(-20, 30, 20, 70)}), front(),
                    polygonShape(rectangle(-50, -40, 50, 50)), side());
    const Assembly assembly = assembled(model);
    QCOMPARE(assembly.joints[0].crossing->overlaps.size(), std::size_t(1));
    const auto [innerA, mouthA] = heights(model, 0, assembly.slits[0].at(0));
    const auto [innerB, mouthB] = heights(model, 1, assembly.slits[1].at(0));
    QVERIFY(mouthA <= 0.0);
    QVERIFY(mouthB >= 50.0);
    QCOMPARE(innerA, innerB);
}

// Two plates, one with a window on the axis: below the window the other's slit takes all, above it
// both are cut half. Without this they had no joint at all.
void TestSlits::windowOnTheAxisLeavesOneGrip()
{
    const ShapePointer windowed =
        polygonShape(rectangle(-50, 0, 50, 100), {rectangle(-20, 35, 20, 65)});
    const ShapePointer plain = polygonShape(rectangle(-50, 0, 50, 100));
    const Model model = twoSections(windowed, front(), plain, side());
    const Assembly assembly = assembled(model);
    QCOMPARE(assembly.joints.size(), std::size_t(1));
    QCOMPARE(assembly.joints[0].crossing->overlaps.size(), std::size_t(2));
    QVERIFY(assembly.joints[0].kind != JointKind::None);
    QCOMPARE(assembly.slits[0].size(), std::size_t(1));
    QCOMPARE(assembly.slits[1].size(), std::size_t(2));
    QCOMPARE(locate(assembly.slits[0][0].mouth, windowed->region()), Side::Outside);
    // Wherever the axis is inside both, a slit takes it from one of them, and not from both.
    const auto isCut = [&](std::size_t section, double height) {
        for (const Slit &slit : assembly.slits[section]) {
            const auto [inner, mouth] = heights(model, section, slit);
            if (std::min(inner, mouth) < height && height < std::max(inner, mouth))
                return true;
        }
        return false;
    };
    for (double height = 0.25; height < 100.0; height += 1.0) {
        if (height < 35.0 || height > 65.0)
            QVERIFY(isCut(0, height) != isCut(1, height));
    }
}

void TestSlits::windowsInBothHoldNowhere()
{
    const ShapePointer windowed =
        polygonShape(rectangle(-50, 0, 50, 100), {rectangle(-20, 35, 20, 65)});
    const Assembly assembly = assembled(twoSections(windowed, front(), windowed, side()));
    QCOMPARE(assembly.joints.at(0).kind, JointKind::None);
}

void TestSlits::plateThroughARingGetsAMortise()
{
    // a's bar between two holes, b a strip that lies within: neither end of the bar is outside.
    const Model model =
        twoSections(polygonShape(rectangle(-50, 0, 50, 100),
                                 {rectangle(-20, 10, 20, 30), rectangle(-20, 70, 20, 90)}),
                    front(), polygonShape({{-50, 40}, {50, 40}, {50, 60}, {-50, 60}}), side());
    const Assembly assembly = assembled(model);
    QCOMPARE(assembly.joints.size(), std::size_t(1));
    QCOMPARE(assembly.joints[0].kind, JointKind::Mortise);
    QCOMPARE(assembly.slits[0].size(), std::size_t(1));
    QVERIFY(!assembly.slits[0][0].isOpen);
    QVERIFY(assembly.slits[1].empty());
    QCOMPARE((assembly.slits[0][0].mouth - assembly.slits[0][0].inner).norm(), 20.0);
}

void TestSlits::toothTooWideForItsMortiseCollides()
{
    // The strip widens on both sides of the bar: it can be pushed through from neither.
    const Model model =
        twoSections(polygonShape(rectangle(-50, 0, 50, 100),
                                 {rectangle(-20, 10, 20, 30), rectangle(-20, 70, 20, 90)}),
                    front(),
                    polygonShape({{-50, 20},
                                  {-20, 20},
                                  {-20, 40},
                                  {20, 40},
                                  {20, 20},
                                  {50, 20},
                                  {50, 80},
                                  {20, 80},
                                  {20, 60},
                                  {-20, 60},
                                  {-20, 80},
                                  {-50, 80}}),
                    side());
    const Assembly assembly = assembled(model);
    QCOMPARE(assembly.joints.size(), std::size_t(1));
    QCOMPARE(assembly.joints[0].kind, JointKind::None);
    QVERIFY(assembly.slits[0].empty() && assembly.slits[1].empty());
    QCOMPARE(heldGroups(analysed(model)).size(), std::size_t(2));
}

// A corner left standing at an oblique mouth keeps the other section out.
void TestSlits::obliqueMouthOpensAllAcross()
{
    const Model model = twoSections(polygonShape({{-50, 0}, {50, 0}, {50, 100}, {-50, 0.5}}),
                                    front(), polygonShape(rectangle(-50, 20, 50, 90)), side());
    const Assembly assembly = assembled(model);
    const Slit &slit = assembly.slits[0].at(0);
    const Region &region = model.section(0)->shape->region();
    const Polygon corners = slit.outline();
    QCOMPARE(locate(corners[1], region), Side::Outside);
    QCOMPARE(locate(corners[2], region), Side::Outside);
}

void TestSlits::severalOverlapsSlideOneWay()
{
    // A fork with three tines (cut by a horizontal axis), crossed by one strip that ends in the
    // last tine.
    const Polygon fork = {{0, 0},   {70, 0},  {70, 60}, {50, 60}, {50, 20}, {45, 20},
                          {45, 60}, {25, 60}, {25, 20}, {20, 20}, {20, 60}, {0, 60}};
    const Frame lying{{0, 40, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
    const Model model =
        twoSections(polygonShape(fork), front(), polygonShape(rectangle(-10, -20, 60, 20)), lying);
    const Assembly assembly = assembled(model);
    QCOMPARE(assembly.joints.size(), std::size_t(1));
    QCOMPARE(assembly.joints[0].crossing->overlaps.size(), std::size_t(3));
    QCOMPARE(assembly.slits[0].size(), std::size_t(3));
    QCOMPARE(assembly.slits[1].size(), std::size_t(3));
    for (std::size_t section : {0u, 1u}) {
        const std::vector<Slit> &slits = assembly.slits[section];
        const Vec2 way = (slits[0].mouth - slits[0].inner).normalized();
        for (const Slit &slit : slits)
            QVERIFY((slit.mouth - slit.inner).normalized().dot(way) > 0.999);
    }
}

void TestSlits::touchingIsNoJoint()
{
    // b ends exactly in a's plane.
    const Model model = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                    polygonShape(rectangle(0, 0, 50, 50)), side());
    QVERIFY(assembled(model).joints.empty());
    // b stands on a corner of a.
    const Model corner = twoSections(polygonShape(rectangle(-50, 0, 50, 50)), front(),
                                     polygonShape(rectangle(-50, 50, 50, 90)), side());
    QVERIFY(assembled(corner).joints.empty());
}

// Slits that hang on the order in which sections are looked at would flip with an undo.
void TestSlits::swappingTheSectionsGivesTheSameSlits()
{
    const ShapePointer a = polygonShape(rectangle(-50, 0, 50, 50));
    const ShapePointer b = polygonShape(rectangle(-50, 20, 50, 90));
    const Model one = twoSections(a, front(), b, turned(1.0));
    const Model two = twoSections(b, turned(1.0), a, front());
    const Assembly first = assembled(one), second = assembled(two);
    for (const std::size_t i : {0u, 1u}) {
        const Slit &x = first.slits[i].at(0);
        const Slit &y = second.slits[1 - i].at(0);
        QVERIFY((x.inner - y.inner).norm() < 1e-9);
        QVERIFY((x.mouth - y.mouth).norm() < 1e-9);
        QVERIFY(std::abs(x.width - y.width) < 1e-9);
    }
}

void TestSlits::turningTheModelTurnsTheSlits()
{
    std::mt19937_64 random(33);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const ShapePointer a = polygonShape({{-50, 0}, {50, 0}, {45, 55}, {-30, 50}});
    const ShapePointer b = polygonShape({{-40, 20}, {50, 25}, {30, 90}, {-50, 80}});
    const Assembly straight = assembled(twoSections(a, front(), b, turned(1.2)));
    for (int round = 0; round < 50; ++round) {
        const Eigen::Quaterniond turn =
            Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random)).normalized();
        const Vec3 shift(100 * unit(random), 100 * unit(random), 100 * unit(random));
        const auto moved = [&](const Frame &f) {
            return Frame{turn * f.origin + shift, turn * f.x, turn * f.y};
        };
        const Assembly found = assembled(twoSections(a, moved(front()), b, moved(turned(1.2))));
        for (const std::size_t i : {0u, 1u}) {
            QVERIFY((found.slits[i].at(0).inner - straight.slits[i].at(0).inner).norm() < 1e-8);
            QVERIFY((found.slits[i].at(0).mouth - straight.slits[i].at(0).mouth).norm() < 1e-8);
        }
    }
}

void TestSlits::thicknessOfTheOtherIsTheWidth()
{
    Document document = newDocument();
    document = withSection(std::move(document), polygonShape(rectangle(-50, 0, 50, 50)), front());
    Stock thick = birchPlywood();
    thick.thickness = 6.0;
    thick.clearance = 0.1;
    document = *addStock(std::move(document), thick);
    document = withSection(std::move(document), polygonShape(rectangle(-50, 20, 50, 90)), side());
    const Assembly assembly = assembled(evaluate(document));
    QCOMPARE(assembly.slits[0].at(0).width, 6.0);
    QCOMPARE(assembly.slits[1].at(0).width, 3.1);
}

// A negative width would be cut as wide as its absolute value.
void TestSlits::slitsWithoutWidthAreNone()
{
    QVERIFY(!slitWidth(3.0, 3.0, radians(90), -3.0));
    QVERIFY(!slitWidth(3.0, 3.0, radians(90), -10.0));
    QVERIFY(slitWidth(3.0, 3.0, radians(90), -2.9));
    Stock stock = birchPlywood();
    stock.clearance = -3.0;
    const auto refused = addStock(newDocument(), stock);
    QVERIFY(!refused);
    QCOMPARE(refused.error().place, std::string("clearance"));
}

FFF_TEST(TestSlits)
#include "tst_slits.moc"
