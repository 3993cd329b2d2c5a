// Stresses within a section by the formulas of beams, against finite elements and by their laws.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/stress_places.h"
#include "tests/core/physics/section_case.h"
#include "tests/test_program.h"

#include <QDir>

#include <functional>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Polygon box(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Polygon circle(const Vec2 &centre, double radius, int corners)
{
    Polygon ring;
    for (int i = 0; i < corners; ++i) {
        const double a = 2.0 * std::numbers::pi * i / corners;
        ring.push_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
    }
    return ring;
}

Vec3 leverCross(const Vec2 &lever, const Vec3 &f)
{
    return Vec3(lever.x(), lever.y(), 0).cross(f);
}

AppliedForce forceAt(const Vec2 &at, const Vec3 &force, const Vec3 &moment = Vec3::Zero())
{
    AppliedForce f;
    f.at = at;
    f.force = force;
    f.moment = moment;
    return f;
}

/// The forces with one more that holds them.
std::vector<AppliedForce> heldAt(const Vec2 &at, std::vector<AppliedForce> forces)
{
    AppliedForce held = forceAt(at, Vec3::Zero());
    held.kind = ForceKind::Clamp;
    for (const AppliedForce &f : forces) {
        held.force -= f.force;
        held.moment -= f.moment + leverCross(f.at - at, f.force);
    }
    forces.push_back(held);
    return forces;
}

/// A beam with a slit from above, a waist and a window; held on the left, loaded at its right end.
struct Sample
{
    Region region;
    std::vector<SlitLine> slits;
    std::vector<AppliedForce> forces;
    SheetMaterial sheet;
};

Sample beamWithSlit()
{
    Sample s;
    s.region.outer = {{0, 0},   {120, 0}, {140, 14}, {160, 0}, {220, 0}, {220, 40},
                      {83, 40}, {83, 20}, {77, 20},  {77, 40}, {0, 40}};
    s.region.holes = {circle({180, 22}, 7, 40)};
    s.slits = {{{80, 20}, {0, 1}, 20.0, 6.0}};
    s.forces = heldAt({0, 20}, {forceAt({220, 20}, {3, -10, 1.5}, {20, -30, 40})});
    return s;
}

Region mapped(const Region &region, const std::function<Vec2(const Vec2 &)> &map)
{
    Region result = region;
    for (Vec2 &p : result.outer)
        p = map(p);
    for (Polygon &hole : result.holes)
        for (Vec2 &p : hole)
            p = map(p);
    return result;
}

/// Points in the plane by `map`, directions by `turn` (a matrix of the plane); `across`: what the
/// direction across the sheet becomes (±1), `spin` what a moment's sign does.
Sample mapped(const Sample &s, const Eigen::Matrix2d &turn, const Vec2 &shift, double scale)
{
    Sample r = s;
    const bool isMirror = turn.determinant() < 0.0;
    r.region = mapped(s.region, [&](const Vec2 &p) -> Vec2 { return scale * (turn * p) + shift; });
    for (SlitLine &slit : r.slits) {
        slit.root = scale * (turn * slit.root) + shift;
        slit.opening = turn * slit.opening;
        slit.depth *= scale;
        slit.width *= scale;
    }
    const auto polar = [&](const Vec3 &a) { // n stays
        Vec3 b(0, 0, a.z());
        b.head<2>() = turn * a.head<2>();
        return b;
    };
    for (AppliedForce &f : r.forces) {
        f.at = scale * (turn * f.at) + shift;
        f.force = polar(f.force);
        f.moment = (isMirror ? -1.0 : 1.0) * scale * polar(f.moment);
        f.radius *= scale;
    }
    r.sheet.thickness *= scale;
    r.sheet.arealWeight = polar(s.sheet.arealWeight);
    return r;
}

SectionStress stressOfSample(const Sample &s, const SampleOptions &options = {}, int refined = 3)
{
    StressOptions stress;
    stress.refined = refined;
    return stressOf(SectionCuts(PieceShape(s.region, s.slits), options), s.forces, s.sheet, stress);
}

double worstOf(const SectionStress &stress)
{
    return stress.worstNeck < 0 ? 0.0
                                : stress.necks[static_cast<std::size_t>(stress.worstNeck)].neckUse;
}

bool isFinite(const SectionStress &stress)
{
    for (const NeckStress &n : stress.necks)
        if (!std::isfinite(n.neckUse) || !std::isfinite(n.cornerUse) || !std::isfinite(n.length) ||
            !n.begin.allFinite() || !n.end.allFinite() || n.length <= 0.0)
            return false;
    return std::isfinite(stress.imbalanceShare);
}

/// Area and first moment of what of a region lies to the right of a line, by Clipper.
AreaMoment rightByClipper(const Region &region, const CutLine &line)
{
    const Vec2 back = line.at(-1000), on = line.at(1000),
               right(line.direction.y(), -line.direction.x());
    ClipperLib::Clipper clipper;
    const auto add = [&clipper](const Polygon &polygon, ClipperLib::PolyType type) {
        clipper.AddPath(pathOf(polygon), type, true);
    };
    add(region.outer, ClipperLib::ptSubject);
    for (const Polygon &hole : region.holes)
        add(hole, ClipperLib::ptSubject);
    add({back, on, on + 1000 * right, back + 1000 * right}, ClipperLib::ptClip);
    ClipperLib::Paths paths;
    clipper.Execute(ClipperLib::ctIntersection, paths, ClipperLib::pftEvenOdd,
                    ClipperLib::pftEvenOdd);
    AreaMoment sum; // of triangles from the origin: holes come with their sign
    for (const ClipperLib::Path &path : paths) {
        const Polygon ring = ringOf(path);
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const double twice = ring[j].x() * ring[i].y() - ring[i].x() * ring[j].y();
            sum.area += 0.5 * twice;
            sum.first += twice / 6.0 * (ring[i] + ring[j]);
        }
    }
    return sum;
}

/// A star of many corners with holes in it.
Region starWithHoles(std::mt19937 &random)
{
    std::uniform_real_distribution<double> radius(40, 60), hole(2, 6);
    Region region;
    const int corners = 5 + static_cast<int>(random() % 60);
    for (int i = 0; i < corners; ++i) {
        const double a = 2.0 * std::numbers::pi * i / corners;
        region.outer.push_back(radius(random) * Vec2(std::cos(a), std::sin(a)));
    }
    const int holes = static_cast<int>(random() % 6);
    for (int i = 0; i < holes; ++i) {
        const double a = 2.0 * std::numbers::pi * i / std::max(1, holes);
        region.holes.push_back(circle(18.0 * Vec2(std::cos(a), std::sin(a)), hole(random),
                                      3 + static_cast<int>(random() % 9)));
    }
    return region;
}

} // namespace

class TestSectionStress : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void caseCuts_data();
    void caseCuts();
    void holeLeftOutFails();
    void netSectionIsTheWorst();
    void sidesAreThoseOfClipper();
    void forcesAreOnTheirSides();
    void bothSidesAgree();
    void gridMayBeShifted();
    void modelMayBeMoved_data();
    void modelMayBeMoved();
    void stressesAreLinear();
    void ringsMayRunEitherWay();
    void cachedSidesAreTheSame();
    void imbalanceIsReported();
    void nominalFormulas();
    void notchFactorAtCorners();
    void curvedBarIsRaised();
    void windowLoadedWithinIsRedundant();
    void legMayBuckle();
    void placesAreThinned();
    void nastyRegions_data();
    void nastyRegions();
    void nastyForces();
    void thousandsOfVertices();
};

void TestSectionStress::caseCuts_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("truth");
    QTest::addColumn<int>("least"); // cuts that are compared
    const auto add = [](const char *file, const char *truth, int least) {
        QTest::addRow("%s %s", file, truth)
            << QString::fromLatin1(file) << QString::fromLatin1(truth) << least;
    };
    add("c01_cantilever_inplane", "truth", 4);
    add("c02_cantilever_outofplane", "truth", 4);
    add("c04_cantilever_round_hole", "truth", 4);
    add("c06_L_arm_inplane", "truth", 4);
    add("c08_tapered_cantilever", "truth", 5);
    add("c10_crossed_stand_indeterminate", "truth", 4);
    add("c10_crossed_stand_indeterminate", "truth_contact", 4);
    add("c13_shelf_two_supports", "truth", 4);
    add("c16_three_leg_glass_stand", "truth", 3);
    add("c17_four_leg_glass_stand", "truth", 3);
    add("c20_slit_net_section", "truth", 3);
}

void TestSectionStress::caseCuts()
{
    // Wrong: a stress of a reference case is outside of the tolerance that index.json gives it.
    QFETCH(QString, file);
    QFETCH(QString, truth);
    QFETCH(int, least);
    const QDir cases(QStringLiteral(FFF_SHARED) + QStringLiteral("/mechanics/cases"));
    if (!cases.exists())
        FFF_WITHOUT_SHARED();
    const QJsonObject given = readCase(cases.filePath(file + QStringLiteral(".json")));
    int compared = 0;
    for (const QJsonValue &section : given[u"sections"].toArray()) {
        const SectionCase c = sectionCase(given, section[QStringLiteral("id")].toString(), truth);
        const PieceShape shape(c.region, c.slits);
        for (const CaseCut &cut : c.cuts) {
            const auto found = stressOnLine(shape, c.forces, c.sheet, cut.p0, cut.p1);
            QVERIFY2(found.has_value(), qPrintable(cut.name));
            double low = -0.05, high = 0.15, linear = cut.linear;
            if (cut.name.startsWith(QStringLiteral("hole_"))) {
                low = -0.1;
                high = 0.3;
            } else if (file.startsWith(QStringLiteral("c08"))) { // the member's stress
                low = -0.03;
                high = 0.1;
                linear = cut.name.endsWith(QStringLiteral("60")) ? 1.306 : 1.224;
            } else if (cut.name == QStringLiteral("disc_half")) {
                high = 0.25; // for information; a fault here would be one of the patch
            } else if (cut.name == QStringLiteral("corner45") ||
                       cut.name == QStringLiteral("wall_x77.5_net")) {
                continue; // outside of what beams can say, says the case
            }
            const double ratio = found->stress.linear() / linear;
            QVERIFY2(ratio >= 1.0 + low && ratio <= 1.0 + high,
                     qPrintable(QStringLiteral("%1 %2: %3 MPa against %4, ratio %5")
                                    .arg(c.section, cut.name)
                                    .arg(found->stress.linear())
                                    .arg(linear)
                                    .arg(ratio)));
            ++compared;
        }
        if (!c.forces.empty()) {
            const SectionStress all =
                stressOf(SectionCuts(PieceShape(c.region, c.slits)), c.forces, c.sheet);
            QVERIFY2(all.imbalanceShare < 1e-4, qPrintable(QString::number(all.imbalanceShare)));
        }
    }
    QVERIFY2(compared >= least, qPrintable(QString::number(compared)));
}

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

void TestSectionStress::sidesAreThoseOfClipper()
{
    // Wrong: a side of a cut is not the area, or not where, that a polygon library finds.
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-20, 20), angle(0, std::numbers::pi);
    int compared = 0, overHoles = 0;
    for (int i = 0; i < 400; ++i) {
        const Region region = starWithHoles(random);
        const SectionOutline outline(region);
        const double a = angle(random);
        const CutLine line{{place(random), place(random)}, {std::cos(a), std::sin(a)}};
        std::vector<LineCut> cuts;
        cutsOn(outline, line, 1, cuts);
        if (cuts.size() != 1) // what lies to the right of the line is then more than one side
            continue;
        const AreaMoment expected = rightByClipper(region, line);
        const AreaMoment &found = cuts.front().plus;
        const Vec2 first = found.first + found.area * outline.base();
        QVERIFY2(std::abs(found.area - expected.area) < 1e-3,
                 qPrintable(QStringLiteral("%1: %2 %3").arg(i).arg(found.area).arg(expected.area)));
        QVERIFY((first - expected.first).norm() < 0.1);
        ++compared;
        overHoles += cuts.front().chords.size() > 1 ? 1 : 0;
    }
    QVERIFY2(compared > 100 && overHoles > 30,
             qPrintable(QStringLiteral("%1 %2").arg(compared).arg(overHoles)));
}

void TestSectionStress::forcesAreOnTheirSides()
{
    // Wrong: a force is taken to be on the other side of a cut than where it is.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-55, 55), angle(0, std::numbers::pi);
    int compared = 0;
    for (int i = 0; i < 200; ++i) {
        const Region region = starWithHoles(random);
        const SectionOutline outline(region);
        const double a = angle(random);
        const CutLine line{{0.3 * place(random), 0.3 * place(random)}, {std::cos(a), std::sin(a)}};
        std::vector<LineCut> cuts;
        cutsOn(outline, line, 1, cuts);
        for (int k = 0; cuts.size() == 1 && k < 20; ++k) {
            const Vec2 p(place(random), place(random));
            if (locate(p, region) != Side::Inside)
                continue;
            QCOMPARE(isOnPlusSide(cuts.front(), held(outline, p)), line.across(p) < 0.0);
            ++compared;
        }
    }
    QVERIFY(compared > 500);
    // A U: to the right of the line but beyond the other arm's cut.
    const SectionOutline u(
        {{{0, 0}, {60, 0}, {60, 50}, {40, 50}, {40, 20}, {20, 20}, {20, 50}, {0, 50}}, {}});
    std::vector<LineCut> cuts;
    cutsOn(u, {{0, 40}, {1, 0}}, 1, cuts);
    QCOMPARE(cuts.size(), std::size_t(2));
    // Plus is below the line: all but the tip of the arm that is cut.
    QVERIFY(isOnPlusSide(cuts[0], held(u, {50, 45})));
    QVERIFY(!isOnPlusSide(cuts[0], held(u, {10, 45})));
    QVERIFY(isOnPlusSide(cuts[1], held(u, {10, 45})));
    QVERIFY(!isOnPlusSide(cuts[1], held(u, {50, 45})));
}

void TestSectionStress::bothSidesAgree()
{
    // Wrong: the minus side does not give the opposite of the plus side, in equilibrium.
    Sample s = beamWithSlit();
    s.sheet.arealWeight = {0.001, -0.002, 0.0005};
    const PieceShape shape(s.region, s.slits);
    const AreaMoment &total = shape.outline.total();
    const Vec2 centre = shape.outline.base() + total.first / total.area;
    s.forces =
        heldAt({0, 20}, {s.forces.front(), forceAt(centre, total.area * s.sheet.arealWeight)});
    s.forces.erase(s.forces.begin() + 1); // its weight is the sheet's own
    for (const double x : {30.0, 60.0, 100.0, 130.0, 180.0, 200.0}) {
        const auto there = stressOnLine(shape, s.forces, s.sheet, {x, 0}, {x, 18});
        const auto back = stressOnLine(shape, s.forces, s.sheet, {x, 18}, {x, 0});
        QVERIFY(there && back);
        QVERIFY(std::abs(there->forces.axial - back->forces.axial) < 1e-9);
        QVERIFY(std::abs(there->stress.neck - back->stress.neck) < 1e-9);
    }
}

void TestSectionStress::gridMayBeShifted()
{
    // Wrong: where the lines of the grid happen to lie decides what the worst stress is.
    const Sample s = beamWithSlit();
    const double expected = worstOf(stressOfSample(s));
    QVERIFY(expected > 0.0);
    for (const double shift : {0.07, 0.2, 0.33, 0.61, 0.9}) {
        SampleOptions options;
        options.gridShift = shift;
        const double found = worstOf(stressOfSample(s, options));
        QVERIFY2(std::abs(found - expected) < 0.01 * expected,
                 qPrintable(QStringLiteral("%1: %2 %3").arg(shift).arg(found).arg(expected)));
    }
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
    QTest::newRow("turned by anything") << 0.3 << false << 7.0 << 1.0 << 0.02;
    QTest::newRow("mirrored") << 0.0 << true << 0.0 << 1.0 << 1e-3;
    QTest::newRow("mirrored and turned") << 1.1 << true << -30.0 << 1.0 << 0.02;
    QTest::newRow("half as large") << 0.0 << false << 0.0 << 0.5 << 0.02;
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

void TestSectionStress::ringsMayRunEitherWay()
{
    // Wrong: a ring that is given the other way round changes what is material.
    const Sample s = beamWithSlit();
    Sample other = s;
    std::reverse(other.region.outer.begin(), other.region.outer.end());
    std::reverse(other.region.holes[0].begin(), other.region.holes[0].end());
    const double a = worstOf(stressOfSample(s)), b = worstOf(stressOfSample(other));
    QVERIFY(std::abs(a - b) < 1e-9 * a);
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

void TestSectionStress::nominalFormulas()
{
    // Wrong: a formula of beams is not the one of the books.
    SheetMaterial sheet;
    sheet.thickness = 4.0;
    Neck neck;
    neck.length = 10.0;
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

void TestSectionStress::notchFactorAtCorners()
{
    // Wrong: a sharp corner weakens by another factor than measured, or a plain edge by any.
    SheetMaterial sheet;
    sheet.thickness = 4.0;
    Neck neck;
    neck.length = 4.0;
    CutForces forces;
    forces.axial = 16.0;   // 1 MPa
    forces.bending = 32.0; // 6 · 32 / (4 · 16) = 3 MPa
    NotchRule notch;
    QCOMPARE(nominalStress(forces, neck, sheet, notch).corner, 4.0);
    neck.isAtCorner = true;
    const NominalStress stress = nominalStress(forces, neck, sheet, notch);
    const double k = 0.56 + 0.53 * 4.0; // √(4 / 0.25) = 4
    QVERIFY(std::abs(stress.notch - k) < 1e-12);
    QVERIFY(std::abs(stress.corner - (k + 3.0 * (1.0 + 0.5 * (k - 1.0)))) < 1e-12);
    QCOMPARE(stress.neck, 4.0);
    neck.length = 40.0;
    QCOMPARE(nominalStress(forces, neck, sheet, notch).notch, 5.0);
    notch.cap = 9.0;
    QVERIFY(std::abs(nominalStress(forces, neck, sheet, notch).notch - 7.26) < 0.01);
}

void TestSectionStress::curvedBarIsRaised()
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

void TestSectionStress::windowLoadedWithinIsRedundant()
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

void TestSectionStress::legMayBuckle()
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

void TestSectionStress::nastyRegions_data()
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

void TestSectionStress::nastyRegions()
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

void TestSectionStress::nastyForces()
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

void TestSectionStress::thousandsOfVertices()
{
    // Wrong: a finely flattened, rough outline takes for ever, or its cuts miss their crossings.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> rough(0.97, 1.03);
    Polygon outer;
    constexpr int kCorners = 4000;
    for (int i = 0; i < kCorners; ++i) {
        const double a = 2.0 * std::numbers::pi * i / kCorners;
        outer.push_back(100.0 * rough(random) * Vec2(std::cos(a), std::sin(a)));
    }
    const Region region{outer, {circle({20, 10}, 20, 2000)}};
    const PieceShape shape(region);
    QVERIFY(std::abs(shape.outline.total().area - area(region)) < 1e-6);
    std::vector<LineCut> cuts;
    cutsOn(shape.outline, {{0, 10}, {0, 1}}, 1, cuts);
    QVERIFY(!cuts.empty());
    const auto found = stressOnLine(shape, heldAt({-95, 0}, {forceAt({95, 0}, {0, -1, 0})}), {},
                                    {20, 35}, {20, 90});
    QVERIFY(found.has_value());
    const SectionStress stress =
        stressOf(SectionCuts(shape), heldAt({-95, 0}, {forceAt({95, 0}, {0, -1, 0})}), {});
    QVERIFY(isFinite(stress));
    QVERIFY(stress.necks.size() > 50);
}

FFF_TEST(TestSectionStress)
#include "tst_section_stress.moc"
