// Sections with forces on them, as tests of stresses need them: shapes, loads that are held, and
// the same turned, mirrored or in another unit.
#pragma once

#include "core/physics/section_stress.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace fff::test {

inline Polygon box(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Polygon circle(const Vec2 &centre, double radius, int corners)
{
    Polygon ring;
    for (int i = 0; i < corners; ++i) {
        const double a = 2.0 * std::numbers::pi * i / corners;
        ring.push_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
    }
    return ring;
}

inline Vec3 leverCross(const Vec2 &lever, const Vec3 &f)
{
    return Vec3(lever.x(), lever.y(), 0).cross(f);
}

inline AppliedForce forceAt(const Vec2 &at, const Vec3 &force, const Vec3 &moment = Vec3::Zero())
{
    AppliedForce f;
    f.at = at;
    f.force = force;
    f.moment = moment;
    return f;
}

/// The forces with one more that holds them.
inline std::vector<AppliedForce> heldAt(const Vec2 &at, std::vector<AppliedForce> forces)
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

struct Sample
{
    Region region;
    std::vector<SlitLine> slits;
    std::vector<AppliedForce> forces;
    SheetMaterial sheet;
};

/// A beam with a slit from above, a waist and a window; held on the left, loaded at its right end.
inline Sample beamWithSlit()
{
    Sample s;
    s.region.outer = {{0, 0},   {120, 0}, {140, 14}, {160, 0}, {220, 0}, {220, 40},
                      {83, 40}, {83, 20}, {77, 20},  {77, 40}, {0, 40}};
    s.region.holes = {circle({180, 22}, 7, 40)};
    s.slits = {{{80, 20}, {0, 1}, 20.0, 6.0}};
    s.forces = heldAt({0, 20}, {forceAt({220, 20}, {3, -10, 1.5}, {20, -30, 40})});
    return s;
}

/// Half an ellipse about `middle` from the left to the right over its upper side.
inline Polygon archOver(const Vec2 &middle, double rx, double ry, int edges)
{
    Polygon line;
    for (int i = 0; i <= edges; ++i) {
        const double a = std::numbers::pi * (1.0 - static_cast<double>(i) / edges);
        line.push_back(middle + Vec2(rx * std::cos(a), ry * std::sin(a)));
    }
    return line;
}

/// A bar of 220 × 40 that an arch from below narrows to 40 − ry at x = 140, held on the left and
/// loaded at its right end.
inline Sample barWithWaist(double rx, double ry, int edges)
{
    Sample s;
    s.region.outer = {{0, 40}, {0, 0}};
    for (const Vec2 &p : archOver({140, 0}, rx, ry, edges))
        s.region.outer.push_back(p);
    s.region.outer.insert(s.region.outer.end(), {{220, 0}, {220, 40}});
    s.forces = heldAt({0, 20}, {forceAt({220, 20}, {3, -10, 1.5}, {20, -30, 40})});
    return s;
}

/// A bar that gets narrower to the middle, or to its right end.
inline Sample taperedBar(bool hasWaist)
{
    Sample s;
    if (hasWaist)
        s.region.outer = {{0, 0}, {100, 12}, {200, 0}, {200, 40}, {100, 28}, {0, 40}};
    else
        s.region.outer = {{0, 0}, {200, 12}, {200, 24}, {0, 40}};
    s.forces = heldAt({0, 20}, {forceAt({200, 18}, {3, -10, 1.5}, {20, -30, 40})});
    return s;
}

inline Region mapped(const Region &region, const std::function<Vec2(const Vec2 &)> &map)
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
inline Sample mapped(const Sample &s, const Eigen::Matrix2d &turn, const Vec2 &shift, double scale)
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

inline SectionStress stressOfSample(const Sample &s, const SampleOptions &options = {},
                                    int refined = 3)
{
    StressOptions stress;
    stress.refined = refined;
    return stressOf(SectionCuts(PieceShape(s.region, s.slits), options), s.forces, s.sheet, stress);
}

inline double worstOf(const SectionStress &stress)
{
    return stress.worstNeck < 0 ? 0.0
                                : stress.necks[static_cast<std::size_t>(stress.worstNeck)].neckUse;
}

inline bool isFinite(const SectionStress &stress)
{
    for (const NeckStress &n : stress.necks)
        if (!std::isfinite(n.neckUse) || !std::isfinite(n.cornerUse) || !std::isfinite(n.length) ||
            !n.begin.allFinite() || !n.end.allFinite() || n.length <= 0.0)
            return false;
    return std::isfinite(stress.imbalanceShare);
}

} // namespace fff::test
