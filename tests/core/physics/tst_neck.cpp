// The formulas of beams on one cross-section, and what is said of it beside its stress.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/physics/loaded_section.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

SheetMaterial ofThickness(double thickness)
{
    SheetMaterial sheet;
    sheet.thickness = thickness;
    return sheet;
}

Neck ofLength(double length)
{
    Neck neck;
    neck.length = length;
    return neck;
}

} // namespace

class TestNeck : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nominalFormulas();
    void notchFactorAtCorners();
    void curvedBarIsRaised();
    void windowLoadedWithinIsRedundant();
    void legMayBuckle();
};

void TestNeck::nominalFormulas()
{
    // Wrong: a formula of beams is not the one of the books.
    SheetMaterial sheet = ofThickness(4.0);
    const Neck neck = ofLength(10.0);
    CutForces forces;
    forces.axial = -80.0;   // 2 MPa
    forces.inPlane = 200.0; // 6 · 200 / (4 · 100) = 3 MPa
    forces.bending = -80.0; // 6 · 80 / (10 · 16) = 3 MPa
    const NominalStress plain = nominalStress(forces, neck, sheet, {});
    QCOMPARE(plain.axial, 2.0);
    QCOMPARE(plain.inPlane, 3.0);
    QCOMPARE(plain.plate, 3.0);
    QCOMPARE(plain.neck, 8.0);
    forces = {};
    forces.torsion = 160.0; // (3 + 1.8 · 0.4) · 160 / (10 · 16) = 3.72 MPa
    forces.shear = 40.0;    // 1.5 MPa
    forces.plate = -20.0;   // less
    const NominalStress brittle = nominalStress(forces, neck, sheet, {});
    QVERIFY(std::abs(brittle.shear - 5.22) < 1e-12);
    QVERIFY(std::abs(brittle.neck - 5.22) < 1e-12);
    sheet.isDuctile = true;
    QVERIFY(std::abs(nominalStress(forces, neck, sheet, {}).neck - std::sqrt(3.0) * 5.22) < 1e-12);
}

void TestNeck::notchFactorAtCorners()
{
    // Wrong: a sharp corner weakens by another factor than measured, or a plain edge by any.
    const SheetMaterial sheet = ofThickness(4.0);
    Neck neck = ofLength(4.0);
    CutForces forces;
    forces.axial = 16.0;   // 1 MPa
    forces.bending = 32.0; // 6 · 32 / (4 · 16) = 3 MPa
    QCOMPARE(nominalStress(forces, neck, sheet, {}).corner, 4.0);
    neck.isAtCorner = true;
    const NominalStress stress = nominalStress(forces, neck, sheet, {});
    const double k = 0.56 + 0.53 * 4.0; // √(4 / 0.25) = 4
    QVERIFY(std::abs(stress.notch - k) < 1e-12);
    QVERIFY(std::abs(stress.corner - (k + 3.0 * (1.0 + 0.5 * (k - 1.0)))) < 1e-12);
    QCOMPARE(stress.neck, 4.0);
    neck.length = 40.0;
    QCOMPARE(nominalStress(forces, neck, sheet, {}).notch, 5.0);
    NotchRule notch;
    notch.cap = 9.0;
    QVERIFY(std::abs(nominalStress(forces, neck, sheet, notch).notch - 7.26) < 0.01);
}

void TestNeck::curvedBarIsRaised()
{
    // Wrong: a strongly curved bar is taken for a straight one, or a straight one for curved.
    for (const double ratio : {1.0, 2.1, 5.0}) { // R / l
        const double l = 10.0, radius = ratio * l;
        Polygon bar;
        constexpr int kSteps = 60;
        for (int i = 0; i <= kSteps; ++i)
            bar.push_back((radius + 0.5 * l) * Vec2(std::cos(std::numbers::pi * i / kSteps),
                                                    std::sin(std::numbers::pi * i / kSteps)));
        for (int i = kSteps; i >= 0; --i)
            bar.push_back((radius - 0.5 * l) * Vec2(std::cos(std::numbers::pi * i / kSteps),
                                                    std::sin(std::numbers::pi * i / kSteps)));
        const PieceShape shape(Region{bar, {}});
        const auto found = cutAt(shape.outline, {{0, 0}, {0, 1}}, radius, 0.0);
        QVERIFY(found.has_value());
        const Neck neck = neckOf(shape, found->cut, found->chord);
        const double expected = ratio == 1.0 ? 1.52 : ratio == 2.1 ? 1.19 : 1.07;
        QVERIFY2(std::abs(neck.bend - expected) < 0.03, qPrintable(QString::number(neck.bend)));
        QCOMPARE(neck.isCurved, ratio < 2.0);
    }
    const PieceShape straight(Region{box(0, 0, 100, 10), {}});
    const auto cut = cutAt(straight.outline, {{50, 0}, {0, 1}}, 5.0, 0.0);
    QCOMPARE(neckOf(straight, cut->cut, cut->chord).bend, 1.0);
    // A round disc is no bar.
    const PieceShape disc(Region{circle({0, 0}, 30, 64), {}});
    const auto across = cutAt(disc.outline, {{0, -40}, {0, 1}}, 40.0, 0.0);
    QCOMPARE(neckOf(disc, across->cut, across->chord).bend, 1.0);
}

void TestNeck::windowLoadedWithinIsRedundant()
{
    // Wrong: it goes unsaid that statics cannot tell how a load beside a window is shared.
    const PieceShape shape(Region{box(0, 0, 200, 50), {box(60, 10, 140, 40)}});
    const SheetMaterial sheet;
    const auto at = [&](const Vec2 &load) {
        return stressOnLine(shape, heldAt({0, 25}, {forceAt(load, {0, -5, 0})}), sheet, {90, 0},
                            {90, 10});
    };
    QVERIFY(at({110, 45})->doubts.isRedundant);
    QVERIFY(!at({190, 25})->doubts.isRedundant);
}

void TestNeck::legMayBuckle()
{
    // Wrong: a slender leg under a third of Euler's load and more is not warned of, or a stout one
    // is.
    const PieceShape shape(Region{box(0, 0, 10, 300), {}});
    SheetMaterial sheet;
    sheet.thickness = 3.0;
    // I = 10 · 27 / 12 = 22.5, a third of π² · 3200 · 22.5 / (4 · 300²) = 0.66 N.
    const auto pressed = [&](double force) {
        return stressOnLine(shape,
                            {forceAt({5, 0}, {0, force, 0}), forceAt({5, 300}, {0, -force, 0})},
                            sheet, {0, 150}, {10, 150})
            ->doubts.mayBuckle;
    };
    QVERIFY(!pressed(0.6));
    QVERIFY(pressed(0.7));
    QVERIFY(!pressed(-100.0));
}

FFF_TEST(TestNeck)
#include "tst_neck.moc"
