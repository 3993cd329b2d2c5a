// Stresses within a section by the formulas of beams: their laws (against finite elements:
// compare_beams.cpp).
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/sample_stresses.h"
#include "core/physics/stress_places.h"
#include "tests/core/physics/loaded_section.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

class TestSectionStress : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holeLeftOutFails();
    void netSectionIsTheWorst();
    void gridMayBeShifted_data();
    void gridMayBeShifted();
    void waistIsThatOfTheFormula();
    void modelMayBeMoved_data();
    void modelMayBeMoved();
    void stressesAreLinear();
    void cachedSidesAreTheSame();
    void doubtsMayBeAskedLater();
    void imbalanceIsReported();
    void placesAreThinned();
};

void TestSectionStress::holeLeftOutFails()
{
    // Wrong: a hole makes no difference, as to a program that knows the outline alone.
    const Polygon outline = box(0, -20, 200, 20);
    const std::vector<AppliedForce> forces = heldAt({0, 0}, {forceAt({200, 0}, {0, -20, 0})});
    SheetMaterial sheet;
    sheet.thickness = 6.0;
    const auto solid = stressOnLine(PieceShape({outline, {}}), forces, sheet, {80, -20}, {80, 20});
    const auto upper = stressOnLine(PieceShape({outline, {circle({80, 5}, 8, 64)}}), forces, sheet,
                                    {80, 13}, {80, 20});
    QVERIFY(solid && upper);
    QVERIFY(upper->stress.linear() > 1.5 * solid->stress.linear());
    QVERIFY(std::abs(upper->length - 7.0) < 0.05);
}

void TestSectionStress::netSectionIsTheWorst()
{
    // Wrong: lines through the material beside a slit hide that only the ligament below it carries.
    Sample s;
    s.region.outer = {{0, -20}, {200, -20}, {200, 20}, {83, 20},
                      {83, 0},  {77, 0},    {77, 20},  {0, 20}};
    s.slits = {{{80, 0}, {0, 1}, 20.0, 6.0}};
    s.forces = heldAt({0, 0}, {forceAt({200, 0}, {0, -10, 0})});
    s.sheet.thickness = 6.0;
    const SectionStress stress = stressOfSample(s);
    const NeckStress &worst = stress.necks[static_cast<std::size_t>(stress.worstNeck)];
    QVERIFY2(std::abs(worst.length - 20.0) < 0.5, qPrintable(QString::number(worst.length)));
    QVERIFY(worst.stress.neck > 2.9 && worst.stress.neck < 3.5);
    // Beside the wall no more than a little less, far from it the whole depth.
    const PieceShape shape(s.region, s.slits);
    const auto at = [&](double x) {
        return stressOnLine(shape, s.forces, s.sheet, {x, -20}, {x, 20})->length;
    };
    QVERIFY(std::abs(at(76.0) - 21.0) < 1e-9);
    QVERIFY(std::abs(at(67.0) - 30.0) < 1e-9);
    QVERIFY(std::abs(at(50.0) - 40.0) < 1e-9);
}

void TestSectionStress::gridMayBeShifted_data()
{
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("angle"); // degrees
    const char *names[] = {"slit", "waist", "coarse waist", "round waist", "taper", "kinked waist"};
    for (int shape = 0; shape < 6; ++shape)
        for (const double angle : {0.0, 7.0, 33.0})
            QTest::addRow("%s at %g", names[shape], angle) << shape << angle;
}

void TestSectionStress::gridMayBeShifted()
{
    // Wrong: where the lines of the grid happen to lie, or which way they run, decides what the
    // worst stress is.
    QFETCH(int, shape);
    QFETCH(double, angle);
    const Sample straight =
        std::vector<Sample>{beamWithSlit(),           barWithWaist(30, 22, 24),
                            barWithWaist(30, 22, 12), barWithWaist(22, 22, 24),
                            taperedBar(false),        taperedBar(true)}[static_cast<std::size_t>(
            shape)];
    const Sample s =
        mapped(straight, Eigen::Rotation2Dd(angle * std::numbers::pi / 180.0).toRotationMatrix(),
               {3, -7}, 1.0);
    const double expected = worstOf(stressOfSample(straight));
    QVERIFY(expected > 0.0);
    constexpr int kShifts = 40;
    for (int i = 0; i < kShifts; ++i) {
        SampleOptions options;
        options.gridShift = static_cast<double>(i) / kShifts;
        const double found = worstOf(stressOfSample(s, options));
        QVERIFY2(std::abs(found - expected) < 0.0025 * expected,
                 qPrintable(QStringLiteral("%1: %2 %3").arg(i).arg(found).arg(expected)));
    }
}

void TestSectionStress::waistIsThatOfTheFormula()
{
    // Wrong: a cut that leans over a curve is taken for a narrower place than there is.
    Sample s = barWithWaist(30, 22, 96);
    s.forces = heldAt({0, 31}, {forceAt({220, 31}, {18, 0, 0}, {0, 0, 54})});
    // At x = 140: 18 mm by 3 mm, 18 / 54 + 6 · 54 / (3 · 18²) = 2 / 3 MPa.
    QVERIFY(std::abs(worstOf(stressOfSample(s)) * s.sheet.strength - 2.0 / 3.0) < 0.002);
}

void TestSectionStress::modelMayBeMoved_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<bool>("isMirrored");
    QTest::addColumn<double>("shift");
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("far away") << 0.0 << false << 5000.0 << 1.0 << 1e-6;
    QTest::newRow("turned by a direction of the grid")
        << std::numbers::pi / 4 << false << 0.0 << 1.0 << 1e-3;
    QTest::newRow("turned by anything") << 0.3 << false << 7.0 << 1.0 << 0.0025;
    QTest::newRow("mirrored") << 0.0 << true << 0.0 << 1.0 << 1e-3;
    QTest::newRow("mirrored and turned") << 1.1 << true << -30.0 << 1.0 << 0.0025;
    QTest::newRow("half as large") << 0.0 << false << 0.0 << 0.5 << 0.0025;
}

void TestSectionStress::modelMayBeMoved()
{
    // Wrong: the stress depends on where the section lies in its frame, or on the unit of length.
    QFETCH(double, angle);
    QFETCH(bool, isMirrored);
    QFETCH(double, shift);
    QFETCH(double, scale);
    QFETCH(double, tolerance);
    Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    if (isMirrored)
        turn.col(0) = -turn.col(0);
    const Sample s = beamWithSlit();
    const double expected = worstOf(stressOfSample(s));
    const double found =
        worstOf(stressOfSample(mapped(s, turn, {shift, -0.5 * shift}, scale))) * scale * scale;
    QVERIFY2(std::abs(found - expected) < tolerance * expected,
             qPrintable(QStringLiteral("%1 %2").arg(found).arg(expected)));
    // The same line exactly, wherever it is.
    const auto at = [&](const Vec2 &p) -> Vec2 {
        return scale * (turn * p) + Vec2(shift, -0.5 * shift);
    };
    const Sample m = mapped(s, turn, {shift, -0.5 * shift}, scale);
    const auto here =
        stressOnLine(PieceShape(s.region, s.slits), s.forces, s.sheet, {55, 0}, {60, 40});
    const auto there =
        stressOnLine(PieceShape(m.region, m.slits), m.forces, m.sheet, at({55, 0}), at({60, 40}));
    QVERIFY(here && there);
    QVERIFY(std::abs(there->stress.neck * scale * scale - here->stress.neck) <
            1e-8 * here->stress.neck);
}

void TestSectionStress::stressesAreLinear()
{
    // Wrong: twice the forces are not twice the stresses.
    Sample s = beamWithSlit();
    const SectionStress once = stressOfSample(s);
    for (AppliedForce &f : s.forces) {
        f.force *= 2.0;
        f.moment *= 2.0;
    }
    const SectionStress twice = stressOfSample(s);
    QCOMPARE(once.necks.size(), twice.necks.size());
    QVERIFY(once.necks.size() > 60);
    for (std::size_t i = 0; i < once.necks.size(); ++i)
        QVERIFY(std::abs(twice.necks[i].neckUse - 2.0 * once.necks[i].neckUse) <=
                1e-9 * (once.necks[i].neckUse + 1e-9));
}

void TestSectionStress::cachedSidesAreTheSame()
{
    // Wrong: sides that are kept while forces change give another answer than all made anew.
    Sample s = beamWithSlit();
    const SectionCuts cuts(PieceShape(s.region, s.slits));
    const CutShares shares = cutShares(cuts, s.forces, s.sheet.thickness);
    s.forces[0].force *= -3.0;
    s.forces[1].force *= -3.0;
    const SectionStress kept = stressOf(cuts, shares, s.forces, s.sheet);
    const SectionStress anew = stressOf(cuts, s.forces, s.sheet);
    QCOMPARE(kept.necks.size(), anew.necks.size());
    for (std::size_t i = 0; i < kept.necks.size(); ++i)
        QCOMPARE(kept.necks[i].neckUse, anew.necks[i].neckUse);
}

void TestSectionStress::doubtsMayBeAskedLater()
{
    // Wrong: what is worst, or local, hangs on how many necks were asked for their doubts.
    for (const Sample &s : {beamWithSlit(), barWithWaist(30, 25, 24), taperedBar(true)}) {
        const SectionCuts cuts(PieceShape(s.region, s.slits));
        const CutShares shares = cutShares(cuts, s.forces, s.sheet.thickness);
        const SectionStress all = stressOf(cuts, shares, s.forces, s.sheet);
        SampleStresses some(cuts, shares, s.forces, s.sheet, {});
        QVERIFY(some.worstNeck() > 0.0);
        some.refine(StressOptions().refined);
        const double from = 0.5 * some.worstCorner();
        const SectionStress &found = some.result(from);
        QCOMPARE(found.worstNeck, all.worstNeck);
        QCOMPARE(found.worstCorner, all.worstCorner);
        QCOMPARE(found.necks.size(), all.necks.size());
        for (std::size_t i = 0; i < all.necks.size(); ++i) {
            QCOMPARE(found.necks[i].neckUse, all.necks[i].neckUse);
            QCOMPARE(found.necks[i].isCovered, all.necks[i].isCovered);
            if (all.necks[i].cornerUse >= from)
                QCOMPARE(found.necks[i].counts(), all.necks[i].counts());
        }
    }
}

void TestSectionStress::imbalanceIsReported()
{
    // Wrong: forces that do not hold each other go unnoticed, as a mean of both sides lets them.
    Sample s = beamWithSlit();
    QVERIFY(stressOfSample(s).imbalanceShare < 1e-12);
    s.forces.pop_back();
    const SectionStress stress = stressOfSample(s);
    QVERIFY(stress.imbalanceShare > 0.5);
    QVERIFY((stress.imbalance.force - Vec3(3, -10, 1.5)).norm() < 1e-12);
}

void TestSectionStress::placesAreThinned()
{
    // Wrong: the weakest places are not shown worst first, or one place is shown over and over.
    const SectionStress stress = stressOfSample(beamWithSlit());
    const std::vector<int> places = weakestPlaces(stress);
    QVERIFY(places.size() > 5 && places.size() < stress.necks.size());
    QCOMPARE(places.front(), stress.worstCorner);
    int atCorner = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const NeckStress &a = stress.necks[static_cast<std::size_t>(places[i])];
        if (i > 0)
            QVERIFY(a.cornerUse <= stress.necks[static_cast<std::size_t>(places[i - 1])].cornerUse);
        const Vec2 corner(77, 20);
        atCorner += (a.begin - corner).norm() < 0.05 || (a.end - corner).norm() < 0.05 ? 1 : 0;
        for (std::size_t k = 0; k < i; ++k) {
            const NeckStress &b = stress.necks[static_cast<std::size_t>(places[k])];
            if (a.stress.notch > 1.0 || b.stress.notch > 1.0)
                continue;
            QVERIFY((0.5 * (a.begin + a.end) - 0.5 * (b.begin + b.end)).norm() >= 3.0);
        }
    }
    QVERIFY2(atCorner >= 1 && atCorner <= 4, qPrintable(QString::number(atCorner)));
}

FFF_TEST(TestSectionStress)
#include "tst_section_stress.moc"
