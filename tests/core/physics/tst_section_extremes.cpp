// Stresses of shapes and under forces that no one would draw.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/stress_places.h"
#include "tests/core/physics/loaded_section.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

class TestSectionExtremes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nastyRegions_data();
    void nastyRegions();
    void nastyForces();
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

FFF_TEST(TestSectionExtremes)
#include "tst_section_extremes.moc"
