// Cuts through a piece: what they part, and on which side forces are.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/parallel_lines.h"
#include "tests/core/physics/loaded_section.h"
#include "tests/test_program.h"

#include <polyclipping/clipper.hpp>

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Clipper's integers: nanometres.
constexpr double kPerMm = 1e6;

ClipperLib::Path pathOf(const Polygon &polygon)
{
    ClipperLib::Path path;
    for (const Vec2 &p : polygon)
        path.emplace_back(std::llround(p.x() * kPerMm), std::llround(p.y() * kPerMm));
    return path;
}

Polygon ringOf(const ClipperLib::Path &path)
{
    Polygon ring;
    for (const ClipperLib::IntPoint &p : path)
        ring.emplace_back(static_cast<double>(p.X) / kPerMm, static_cast<double>(p.Y) / kPerMm);
    return ring;
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

class TestLineCut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sidesAreThoseOfClipper();
    void forcesAreOnTheirSides();
    void sumsAreThoseOfEachForce();
    void bothSidesAgree();
    void ringsMayRunEitherWay();
    void thousandsOfVertices();
    void nearAsOnAllOfTheLine();
    void parallelLinesAsOneByOne();
    void fromAVertexToTheNearestEdge();
    void cornersThatARayGrazes();
    void forcesOnTheCut();
};

void TestLineCut::sidesAreThoseOfClipper()
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
        cutsOn(outline, line, cuts);
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

void TestLineCut::forcesAreOnTheirSides()
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
        cutsOn(outline, line, cuts);
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
    cutsOn(u, {{0, 40}, {1, 0}}, cuts);
    QCOMPARE(cuts.size(), std::size_t(2));
    // Plus is below the line: all but the tip of the arm that is cut.
    QVERIFY(isOnPlusSide(cuts[0], held(u, {50, 45})));
    QVERIFY(!isOnPlusSide(cuts[0], held(u, {10, 45})));
    QVERIFY(isOnPlusSide(cuts[1], held(u, {10, 45})));
    QVERIFY(!isOnPlusSide(cuts[1], held(u, {50, 45})));
}

void TestLineCut::sumsAreThoseOfEachForce()
{
    // Wrong: what is summed along the boundary is not what all forces on that side come to, looked
    // at one by one.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-55, 55), angle(0, std::numbers::pi),
        newton(-9, 9);
    int compared = 0, parted = 0, whole = 0;
    for (int i = 0; i < 300; ++i) {
        const Region region = starWithHoles(random);
        const SectionOutline outline(region);
        std::vector<AppliedForce> forces;
        for (int k = 0; k < 40; ++k) {
            AppliedForce force;
            force.at = {place(random), place(random)};
            if (locate(force.at, region) != Side::Inside)
                continue;
            force.kind = static_cast<ForceKind>(random() % 3);
            force.force = {newton(random), newton(random), newton(random)};
            force.moment = {newton(random), newton(random), newton(random)};
            force.radius = random() % 2 ? 0.1 * std::abs(newton(random)) : 0.0;
            if (force.kind == ForceKind::Link) {
                force.at = outline.nearest(force.at).at;
                const double a = 2.0 * angle(random);
                force.slit = {force.at,
                              {std::cos(a), std::sin(a)},
                              random() % 2 ? 0.0 : std::abs(newton(random)),
                              3.0};
            }
            forces.push_back(force);
        }
        const ForceSites sites(outline, forces, 3.0);
        const SummedForces summed(outline, sites, forces);
        const double a = angle(random);
        const CutLine line{{0.5 * place(random), 0.5 * place(random)}, {std::cos(a), std::sin(a)}};
        std::vector<LineCut> cuts;
        cutsOn(outline, line, cuts);
        for (const LineCut &cut : cuts) {
            PlusSites each; // no run: all one by one
            for (int p = 0; p < sites.size(); ++p)
                each.near.push_back({p, plusShare(cut, sites.at(p))});
            const PlusSites found = sites.onPlusSide(cut);
            for (const SlitFit fit : {SlitFit::Loose, SlitFit::Tight}) {
                const SideForce one = plusForce(outline, cut, summed, each, {1, 2, 3}, fit),
                                all = plusForce(outline, cut, summed, found, {1, 2, 3}, fit);
                QVERIFY((one.force - all.force).norm() < 1e-9);
                QVERIFY((one.moment - all.moment).norm() < 1e-7);
            }
            ++compared;
            parted += static_cast<int>(found.near.size());
            whole += sites.size() - static_cast<int>(found.near.size());
        }
    }
    QVERIFY2(compared > 300 && parted > 500 && whole > 3000,
             qPrintable(QStringLiteral("%1 %2 %3").arg(compared).arg(parted).arg(whole)));
}

void TestLineCut::bothSidesAgree()
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

void TestLineCut::ringsMayRunEitherWay()
{
    // Wrong: a ring that is given the other way round changes what is material.
    const Sample s = beamWithSlit();
    Sample other = s;
    std::reverse(other.region.outer.begin(), other.region.outer.end());
    std::reverse(other.region.holes[0].begin(), other.region.holes[0].end());
    const double a = worstOf(stressOfSample(s)), b = worstOf(stressOfSample(other));
    QVERIFY(std::abs(a - b) < 1e-9 * a);
}

void TestLineCut::thousandsOfVertices()
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
    cutsOn(shape.outline, {{0, 10}, {0, 1}}, cuts);
    QVERIFY(!cuts.empty());
    const auto found = stressOnLine(shape, heldAt({-95, 0}, {forceAt({95, 0}, {0, -1, 0})}), {},
                                    {20, 35}, {20, 90});
    QVERIFY(found.has_value());
    const SectionStress stress =
        stressOf(SectionCuts(shape), heldAt({-95, 0}, {forceAt({95, 0}, {0, -1, 0})}), {});
    QVERIFY(isFinite(stress));
    QVERIFY(stress.necks.size() > 50);
}

void TestLineCut::nearAsOnAllOfTheLine()
{
    // Wrong: how far a cut looks along its line to begin with changes which one it finds.
    std::mt19937 random(13);
    std::uniform_real_distribution<double> place(-50, 50), angle(0, 2.0 * std::numbers::pi);
    int begun = 0, containing = 0, overHoles = 0;
    const auto isSame = [](const std::optional<CutChord> &a, const std::optional<CutChord> &b) {
        if (!a || !b)
            return a.has_value() == b.has_value();
        return a->chord == b->chord && a->cut.plus.area == b->cut.plus.area &&
               a->cut.chords.size() == b->cut.chords.size() &&
               a->cut.chords.front().from == b->cut.chords.front().from &&
               a->cut.chords.back().to == b->cut.chords.back().to;
    };
    for (int i = 0; i < 300; ++i) {
        const SectionOutline outline(starWithHoles(random));
        LineCutter cutter(outline);
        const double a = angle(random);
        const Vec2 way(std::cos(a), std::sin(a));
        const Vec2 at(place(random), place(random));
        // From a vertex, from a point of an edge, from anywhere.
        const Polygon &ring = outline.rings()[random() % outline.rings().size()];
        for (const Vec2 &from : {ring[random() % ring.size()], outline.nearest(at).at}) {
            const auto whole = cutter.from({from, way}, 1000.0);
            for (const double reach : {0.01, 1.0, 15.0})
                QVERIFY(isSame(cutter.from({from, way}, reach), whole));
            begun += whole ? 1 : 0;
            overHoles += whole && whole->cut.chords.size() > 1 ? 1 : 0;
        }
        const auto whole = cutter.at({at, way}, 3.0, 0.1, 1000.0);
        const auto nearest = cutter.nearest({at, way}, 8.0, 1000.0);
        for (const double reach : {0.01, 1.0, 15.0}) {
            QVERIFY(isSame(cutter.at({at, way}, 3.0, 0.1, reach), whole));
            QVERIFY(isSame(cutter.nearest({at, way}, 8.0, reach), nearest));
        }
        containing += whole && nearest ? 1 : 0;
    }
    QVERIFY2(begun > 100 && containing > 50 && overHoles > 20,
             qPrintable(QStringLiteral("%1 %2 %3").arg(begun).arg(containing).arg(overHoles)));
}

void TestLineCut::parallelLinesAsOneByOne()
{
    // Wrong: of many lines at once another crossing than of each by itself; with vertices on them.
    std::mt19937 random(7);
    int touched = 0, crossed = 0;
    for (int i = 0; i < 200; ++i) {
        Region region = starWithHoles(random);
        if (i % 2 == 1) { // on a grid of 1 mm, as the lines are
            const auto snap = [](Polygon &ring) {
                for (Vec2 &p : ring)
                    p = Vec2(std::round(p.x()), std::round(p.y()));
            };
            snap(region.outer);
            for (Polygon &hole : region.holes)
                snap(hole);
        }
        const SectionOutline outline(region);
        ParallelLines lines(outline);
        for (int k = 0; k < 8; ++k) {
            const double a = std::numbers::pi * k / 8;
            lines.find({std::cos(a), std::sin(a)}, i % 4 == 1 ? 1.0 : 0.37, 1.0);
            LineCrossings expected;
            for (std::size_t n = 0; n < lines.size(); ++n) {
                outline.crossings(lines.line(n), {}, expected);
                const auto found = lines.crossings(n);
                QCOMPARE(found.size(), expected.touchedLeft.size());
                touched += expected.isTouched ? 1 : 0;
                for (std::size_t c = 0; c < found.size(); ++c, ++crossed) {
                    const OutlineCrossing &one = expected.touchedLeft[c];
                    QCOMPARE(found[c].along, one.along);
                    QCOMPARE(found[c].isToLeft, one.isToLeft);
                    QCOMPARE(found[c].point.ring, one.point.ring);
                }
            }
        }
    }
    QVERIFY(touched > 1000 && crossed > 100000);
}

void TestLineCut::fromAVertexToTheNearestEdge()
{
    // Wrong: a cut from a vertex into the material ends elsewhere than on the first edge ahead, or
    // is lost where that is farther away than was thought.
    std::mt19937 random(19);
    std::uniform_real_distribution<double> share(0.02, 0.98);
    int found = 0, missed = 0;
    for (int i = 0; i < 200; ++i) {
        const Region region = starWithHoles(random);
        const SectionOutline outline(region);
        LineCutter cutter(outline);
        const int n = static_cast<int>(outline.rings().front().size());
        for (int v = 0; v < n; ++v) {
            const Vec2 &at = outline.vertex(0, v);
            const double next = std::atan2((outline.vertex(0, v + 1) - at).y(),
                                           (outline.vertex(0, v + 1) - at).x());
            const double inside = std::numbers::pi - outline.turn(0, v);
            const double angle = next + share(random) * inside;
            const CutLine line{at, {std::cos(angle), std::sin(angle)}};
            double nearest = std::numeric_limits<double>::infinity();
            bool isOuter = false;
            for (int ring = 0; ring < static_cast<int>(outline.rings().size()); ++ring) {
                const int size =
                    static_cast<int>(outline.rings()[static_cast<std::size_t>(ring)].size());
                for (int e = 0; e < size; ++e) {
                    const Vec2 p = outline.vertex(ring, e) - at;
                    const Vec2 way = outline.vertex(ring, e + 1) - at - p;
                    const double along = cross(p, way) / cross(line.direction, way);
                    const double of = cross(p, line.direction) / cross(line.direction, way);
                    if (of >= 0.0 && of <= 1.0 && along > 1e-6 && along < nearest) {
                        nearest = along;
                        isOuter = ring == 0;
                    }
                }
            }
            for (const double reach : {200.0, 0.5}) { // all of it is near, or next to nothing
                cutter.focus(at, reach);
                const auto cut = cutter.fromVertex(line, 0, v, reach);
                if (!cut) {
                    ++missed;
                    continue;
                }
                const Chord &chord = cut->cut.chords[static_cast<std::size_t>(cut->chord)];
                QVERIFY2(std::abs(chord.from) < 1e-9 && std::abs(chord.to - nearest) < 1e-6,
                         qPrintable(QStringLiteral("%1 %2: %3, not %4")
                                        .arg(i)
                                        .arg(v)
                                        .arg(chord.to)
                                        .arg(nearest)));
                if (isOuter)
                    QVERIFY(std::abs(cut->cut.plus.area + cut->cut.minus.area -
                                     outline.total().area) < 1e-6);
                ++found;
            }
        }
    }
    QVERIFY2(found > 10000 && missed < found / 100,
             qPrintable(QStringLiteral("%1 found, %2 missed").arg(found).arg(missed)));
}

void TestLineCut::cornersThatARayGrazes()
{
    // Wrong: a ray that passes a corner by as much as coordinates are rounded goes on beyond it, or
    // not, as rounding has it; or what is held to that corner is on the other side then.
    std::mt19937 random(23);
    std::uniform_real_distribution<double> noise(-1e-7, 1e-7);
    for (int i = 0; i < 1000; ++i) {
        const Vec2 by(100.0 * noise(random) * 1e7, 100.0 * noise(random) * 1e7);
        // A plate with a slit from above and one from the right: from corner to corner at 45°.
        Polygon ring{{0, 0},   {60, 0},  {60, 20}, {40, 20}, {40, 23}, {60, 23},
                     {60, 60}, {23, 60}, {23, 40}, {20, 40}, {20, 60}, {0, 60}};
        for (Vec2 &p : ring)
            p += by + Vec2(noise(random), noise(random));
        const SectionOutline outline(Region{ring, {}});
        LineCutter cutter(outline);
        const int begin = 9, end = 3;
        const Vec2 from = outline.vertex(0, begin);
        const Vec2 way = Vec2(1.0, -1.0).normalized();
        cutter.focus(from, 100.0);
        const auto cut = cutter.fromVertex({from, way}, 0, begin, 100.0);
        QVERIFY(cut);
        const Chord &chord = cut->cut.chords.front();
        QVERIFY(std::abs(chord.length() - 20.0 * std::numbers::sqrt2) < 1e-6);
        QVERIFY((chord.end.at - outline.vertex(0, end)).norm() < 1e-6);
        for (const double away : {-5.0, 5.0}) { // both are held to one of the two corners
            const Vec2 at = from + 10.0 * way + away * perpendicular(way);
            QCOMPARE(isOnPlusSide(cut->cut, held(outline, at)), away < 0.0);
        }
        for (const double away : {-2.0, 2.0}) {
            const Vec2 at = outline.vertex(0, end) - 2.0 * way + away * perpendicular(way);
            QCOMPARE(isOnPlusSide(cut->cut, held(outline, at)), away < 0.0);
        }
    }
}

void TestLineCut::forcesOnTheCut()
{
    // Wrong: a force right on a cut is on either side, as rounding has it; one in the middle of a
    // slit is held to either of its walls.
    const Region region{
        {{0, 0}, {60, 0}, {60, 60}, {32, 60}, {32, 30}, {28, 30}, {28, 60}, {0, 60}}, {}};
    const SectionOutline outline(region);
    LineCutter cutter(outline);
    const auto cut = cutter.at({{30, 10}, Vec2::UnitX()}, 0.0, 0.0, 100.0);
    QVERIFY(cut);
    for (const double away : {-1e-9, -1e-14, 0.0, 1e-14, 1e-9}) {
        AppliedForce force;
        force.at = {17.0, 10.0 + away};
        force.force = {0.0, 0.0, 1.0};
        const auto sites = forceSites(outline, {force}, 3.0);
        const PlusShare plus = plusShare(cut->cut, sites.front());
        QVERIFY(std::abs(plus.share - 0.5) < 1e-5);
        const HeldPoint inSlit = held(outline, {30.0 + away, 45.0});
        QVERIFY((inSlit.anchor.at - Vec2(32.0, 45.0)).norm() < 1e-6);
    }
}

FFF_TEST(TestLineCut)
#include "tst_line_cut.moc"
