// Stresses of shapes and under forces that no one would draw.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/stress_places.h"
#include "tests/core/physics/loaded_section.h"
#include "tests/test_program.h"

#include <cmath>
#include <limits>

using namespace fff;
using namespace fff::test;

class TestSectionExtremes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nastyRegions_data();
    void nastyRegions();
    void nastyForces();
    void whatIsNotWorkedOutSaysSo();
    void longPlates_data();
    void longPlates();
    void slitThroughAllOfIt();
    void tipUnderAFoot();
};

void TestSectionExtremes::nastyRegions_data()
{
    QTest::addColumn<Polygon>("outer");
    QTest::addColumn<std::vector<Polygon>>("holes");
    const std::vector<Polygon> none;
    QTest::newRow("nothing") << Polygon() << none;
    QTest::newRow("a line") << Polygon{{0, 0}, {10, 0}} << none;
    QTest::newRow("no area") << Polygon{{0, 0}, {10, 0}, {20, 0}} << none;
    QTest::newRow("collinear points")
        << Polygon{{0, 0}, {10, 0}, {20, 0}, {40, 0}, {40, 5}, {40, 20}, {20, 20}, {0, 20}, {0, 10}}
        << none;
    QTest::newRow("repeated points")
        << Polygon{{0, 0}, {0, 0}, {40, 0}, {40, 0}, {40, 20}, {0, 20}, {0, 20}, {0, 0}} << none;
    QTest::newRow("spike out") << Polygon{{0, 0},     {40, 0},  {40, 10}, {90, 10},
                                          {40, 10.0}, {40, 20}, {0, 20}}
                               << none;
    QTest::newRow("spike in") << Polygon{{0, 0},     {40, 0},  {40, 10}, {15, 10},
                                         {40, 10.0}, {40, 20}, {0, 20}}
                              << none;
    QTest::newRow("ligament of nothing")
        << Polygon{{0, 0}, {20, 10}, {40, 0}, {40, 20}, {20, 10}, {0, 20}} << none;
    QTest::newRow("hole that nearly touches")
        << box(0, 0, 40, 20) << std::vector<Polygon>{box(10, 1e-9, 20, 12)};
    QTest::newRow("hole that touches")
        << box(0, 0, 40, 20) << std::vector<Polygon>{box(10, 0, 20, 12)};
    QTest::newRow("holes that touch each other")
        << box(0, 0, 40, 20) << std::vector<Polygon>{box(10, 5, 20, 12), box(20, 5, 30, 12)};
    QTest::newRow("hole without area")
        << box(0, 0, 40, 20) << std::vector<Polygon>{{{5, 5}, {10, 5}, {8, 5}}};
    QTest::newRow("tiny") << box(0, 0, 1e-4, 2e-4) << none;
    QTest::newRow("huge") << box(0, 0, 1e6, 1e6) << none;
    QTest::newRow("thin and long") << box(0, 0, 1e5, 0.1) << none;
    QTest::newRow("not numbers") << Polygon{{0, 0}, {std::nan(""), 0}, {40, 20}, {0, 20}} << none;
}

void TestSectionExtremes::nastyRegions()
{
    // Wrong: a shape that no one would draw makes a number that is none, or no end.
    QFETCH(Polygon, outer);
    QFETCH(std::vector<Polygon>, holes);
    const std::vector<SlitLine> slits{{{20, 10}, {0, 1}, 10.0, 3.0}, {{500, 10}, {1, 0}, 0.0, 0.0}};
    Sample s{
        {outer, holes}, slits, heldAt({0, 10}, {forceAt({40, 10}, {1, -2, 3}, {4, 5, 6})}), {}};
    s.sheet.arealWeight = {0, -0.01, 0};
    AppliedForce link = forceAt({20, 10}, {0.1, 0.2, 0.3});
    link.kind = ForceKind::Link;
    link.slit = slits.front();
    s.forces.push_back(link);
    const SectionStress stress = stressOfSample(s);
    QVERIFY(isFinite(stress));
    QVERIFY(weakestPlaces(stress).size() <= stress.necks.size());
    const auto line =
        stressOnLine(PieceShape(s.region, s.slits), s.forces, s.sheet, {7, -50}, {7, 60});
    QVERIFY(!line || std::isfinite(line->neckUse));
}

void TestSectionExtremes::nastyForces()
{
    // Wrong: a force outside of the material, one that is no number or none at all does harm.
    const PieceShape shape(Region{box(0, 0, 40, 20), {}});
    const SectionCuts cuts(shape);
    SheetMaterial sheet;
    QVERIFY(isFinite(stressOf(cuts, {}, sheet)));
    QCOMPARE(worstOf(stressOf(cuts, {}, sheet)), 0.0);
    const double nan = std::nan("");
    QVERIFY(isFinite(
        stressOf(cuts, {forceAt({nan, 0}, {1, 0, 0}), forceAt({0, 0}, {nan, 0, 0})}, sheet)));
    // Held and loaded from beyond both ends: the same as at the ends.
    const auto inside = stressOnLine(shape, heldAt({-30, 10}, {forceAt({70, 10}, {0, -1, 0})}),
                                     sheet, {20, 0}, {20, 20});
    QVERIFY(inside.has_value());
    QVERIFY(std::abs(inside->forces.inPlane + 50.0) < 1e-9);
    sheet.strength = 0.0;
    QVERIFY(isFinite(stressOf(cuts, heldAt({0, 10}, {forceAt({40, 10}, {0, -1, 0})}), sheet)));
    sheet.thickness = 0.0;
    QVERIFY(isFinite(stressOf(cuts, heldAt({0, 10}, {forceAt({40, 10}, {0, -1, 0})}), sheet)));
    QVERIFY(!stressOnLine(shape, {}, sheet, {5, 5}, {5, 5}));
    QVERIFY(!stressOnLine(shape, {}, sheet, {50, 0}, {50, 5}));
}

void TestSectionExtremes::whatIsNotWorkedOutSaysSo()
{
    // Wrong: a piece that hangs by a point, forces that are no numbers or a sheet of nothing pass
    // for one that holds.
    const auto forces = heldAt({0, 10}, {forceAt({40, 10}, {0, -1, 0})});
    const auto isWorkedOut = [](const Polygon &outer, const std::vector<AppliedForce> &given,
                                const SheetMaterial &sheet) {
        const SectionStress stress =
            stressOf(SectionCuts(PieceShape(Region{outer, {}})), given, sheet);
        return stress.isWorkedOut && isFinite(stress);
    };
    const Polygon plate = box(0, 0, 40, 20);
    SheetMaterial sheet;
    QVERIFY(isWorkedOut(plate, forces, sheet));
    QVERIFY(isWorkedOut(plate, {}, sheet));
    QVERIFY(!isWorkedOut({}, forces, sheet));
    QVERIFY(!isWorkedOut(box(0, 0, 1e-4, 2e-4), forces, sheet));
    for (const double half : {0.0, 0.02})
        QVERIFY(!isWorkedOut({{0, 0}, {20, 10 - half}, {40, 0}, {40, 20}, {20, 10 + half}, {0, 20}},
                             forces, sheet));
    QVERIFY(
        isWorkedOut({{0, 0}, {20, 9.9}, {40, 0}, {40, 20}, {20, 10.1}, {0, 20}}, forces, sheet));
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
        auto given = forces;
        given.front().force.y() = bad;
        QVERIFY(!isWorkedOut(plate, given, sheet));
    }
    for (const double bad : {std::nan(""), 0.0, -1.0}) {
        SheetMaterial none;
        none.thickness = bad;
        QVERIFY(!isWorkedOut(plate, forces, none));
        none = {};
        none.strength = bad;
        QVERIFY(!isWorkedOut(plate, forces, none));
    }
    sheet.arealWeight.x() = std::nan("");
    QVERIFY(!isWorkedOut(plate, forces, sheet));
}

void TestSectionExtremes::longPlates_data()
{
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("width");
    QTest::newRow("a strip") << 400.0 << 1.0;
    QTest::newRow("4000 widths") << 4000.0 << 1.0;
    QTest::newRow("4000 widths of 10 mm") << 4e4 << 10.0;
    QTest::newRow("a million widths") << 1e5 << 0.1;
}

void TestSectionExtremes::longPlates()
{
    // Wrong: of a plate as long as a wire the stress is no number, or that of another place: lines
    // are then farther apart than what is searched between them.
    QFETCH(double, length);
    QFETCH(double, width);
    // Twice as deep at both ends: the worst place is in the middle, between two lines.
    Sample s;
    s.region.outer = {{0, -0.5 * width},     {0.37 * length, 0},     {length, -0.5 * width},
                      {length, 1.5 * width}, {0.37 * length, width}, {0, 1.5 * width}};
    s.forces = {forceAt({0, 0.5 * width}, {-1, 0, 0}), forceAt({length, 0.5 * width}, {1, 0, 0})};
    const double expected = 1.0 / (width * s.sheet.thickness) / s.sheet.strength;
    for (const double shift : {0.0, 0.3, 0.8}) {
        SampleOptions options;
        options.gridShift = shift;
        const SectionStress stress = stressOfSample(s, options);
        QVERIFY(isFinite(stress) && stress.isWorkedOut);
        QVERIFY2(std::abs(worstOf(stress) - expected) < 0.01 * expected,
                 qPrintable(QStringLiteral("%1 %2").arg(worstOf(stress)).arg(expected)));
    }
}

void TestSectionExtremes::slitThroughAllOfIt()
{
    // Wrong: a piece that a slit parts from the rest, with that slit's joint on it, makes a number
    // that is none, or loses forces.
    for (const Polygon &piece : {box(0, 0, 77, 40), box(83, 0, 220, 40)}) {
        Sample s = beamWithSlit();
        s.region = {piece, {}};
        s.slits.front().root = {80, 0};
        s.slits.front().depth = 40.0;
        AppliedForce link = forceAt({80, 0}, {2, -5, 1}, {20, 30, 150});
        link.kind = ForceKind::Link;
        link.slit = s.slits.front();
        s.forces = heldAt(0.5 * (piece[0] + piece[2]), {link});
        const SectionStress stress = stressOfSample(s);
        QVERIFY(isFinite(stress));
        QVERIFY(stress.isWorkedOut);
        QVERIFY(stress.imbalanceShare < 1e-12);
        QVERIFY(worstOf(stress) > 0.0);
    }
}

// Wrong: half of a foot's force is hung on what of a corner is thinner than the foot.
void TestSectionExtremes::tipUnderAFoot()
{
    const Region stand{{{-103, 0}, {103, 0}, {20, 100}, {-20, 100}}, {}};
    std::vector<AppliedForce> forces{forceAt({0, 95}, {0, -10, 0})};
    for (const double side : {-1.0, 1.0}) {
        forces.push_back(forceAt({side * 102.957, 0}, {0, 5, 0}));
        forces.back().kind = ForceKind::Foot;
    }
    const SheetMaterial sheet;
    const SectionStress stress = stressOf(SectionCuts(PieceShape(stand)), forces, sheet);
    QVERIFY(stress.isWorkedOut);
    QVERIFY(stress.worstNeck >= 0);
    const NeckStress &worst = stress.necks[static_cast<std::size_t>(stress.worstNeck)];
    QVERIFY2(worst.length > 0.5 * sheet.thickness, qPrintable(QString::number(worst.length)));
    QVERIFY2(worst.stress.neck < 10.0, qPrintable(QString::number(worst.stress.neck))); // MPa
}

FFF_TEST(TestSectionExtremes)
#include "tst_section_extremes.moc"
