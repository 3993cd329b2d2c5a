#include "core/geometry/clip_grid.h"

#include "core/base/fault_point.h"
#include "core/base/tolerances.h"
#include "core/geometry/box_runs.h"
#include "core/geometry/grid_predicates.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <polyclipping/clipper.hpp>

namespace fff {

namespace {

ClipperLib::Path toPath(const GridRing &ring)
{
    ClipperLib::Path path;
    path.reserve(ring.size());
    for (const GridPoint &p : ring)
        path.emplace_back(p.x, p.y);
    return path;
}

GridRing toRing(const ClipperLib::Path &path)
{
    GridRing ring;
    ring.reserve(path.size());
    for (const ClipperLib::IntPoint &p : path)
        ring.push_back({p.X, p.Y});
    return ring;
}

ClipperLib::PolyFillType fillType(Winding rule)
{
    switch (rule) {
    case Winding::Positive:
        return ClipperLib::pftPositive;
    case Winding::Negative:
        return ClipperLib::pftNegative;
    case Winding::NonZero:
        break;
    }
    return ClipperLib::pftNonZero;
}

/// The points that the ring comes to more than once, sorted.
std::vector<GridPoint> repeatedPoints(const GridRing &ring)
{
    // An open hash table of indices + 1, at most half full.
    std::vector<std::uint32_t> table(std::bit_ceil(2 * ring.size() + 1), 0);
    const std::size_t mask = table.size() - 1;
    std::vector<GridPoint> repeated;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        std::size_t slot = hashOf(ring[i]) & mask;
        while (table[slot] != 0 && ring[table[slot] - 1] != ring[i])
            slot = (slot + 1) & mask;
        if (table[slot] != 0)
            repeated.push_back(ring[i]);
        else
            table[slot] = static_cast<std::uint32_t>(i + 1);
    }
    std::sort(repeated.begin(), repeated.end());
    repeated.erase(std::unique(repeated.begin(), repeated.end()), repeated.end());
    return repeated;
}

bool touchesItself(const GridRing &ring)
{
    return !repeatedPoints(ring).empty();
}

bool touchesItself(const GridRegion &region)
{
    return touchesItself(region.outer) ||
           std::any_of(region.holes.begin(), region.holes.end(),
                       [](const GridRing &hole) { return touchesItself(hole); });
}

/// The loops of a ring that meets itself at corners: each time the walk comes to a point again,
/// what lies between is a loop of its own.
void splitAtCorners(const GridRing &ring, std::vector<GridRing> &loops)
{
    const std::vector<GridPoint> corners = repeatedPoints(ring);
    constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> places(corners.size(), kNowhere); // of the corners in the walk
    const auto cornerAt = [&](const GridPoint &p) {
        const auto it = std::lower_bound(corners.begin(), corners.end(), p);
        return it != corners.end() && *it == p ? static_cast<std::size_t>(it - corners.begin())
                                               : kNowhere;
    };
    GridRing walk;
    walk.reserve(ring.size());
    for (const GridPoint &p : ring) {
        const std::size_t corner = cornerAt(p);
        if (corner != kNowhere && places[corner] != kNowhere) {
            const std::size_t first = places[corner];
            if (walk.size() - first > 2)
                loops.emplace_back(walk.begin() + static_cast<std::ptrdiff_t>(first), walk.end());
            walk.resize(first + 1);
            for (std::size_t &place : places) {
                if (place != kNowhere && place > first)
                    place = kNowhere;
            }
            continue;
        }
        if (corner != kNowhere)
            places[corner] = walk.size();
        walk.push_back(p);
    }
    if (walk.size() > 2)
        loops.push_back(std::move(walk));
}

/// Whether the loop lies inside the ring, which it may touch but not cross: by the first of its
/// vertices that is not on the ring.
bool liesInside(const GridRing &loop, const GridRing &ring)
{
    for (const GridPoint &p : loop) {
        bool inside = false, isOn = false;
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size() && !isOn; j = i++) {
            const GridPoint &a = ring[j], &b = ring[i];
            if (a.y == p.y && b.y == p.y) {
                isOn = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x);
            } else if ((a.y <= p.y) != (b.y <= p.y)) {
                const int side = sideOf(a, b, p);
                isOn = side == 0;
                if ((b.y > a.y) == (side > 0))
                    inside = !inside;
            } else {
                isOn = p == a;
            }
        }
        if (!isOn)
            return inside;
    }
    return false;
}

/// Rings that do not cross: each that runs counter-clockwise is a piece, every other one a hole of
/// the smallest piece around it.
std::vector<GridRegion> nested(std::vector<GridRing> rings)
{
    std::vector<GridRegion> pieces;
    std::vector<double> sizes;
    std::vector<GridRing> holes;
    for (GridRing &ring : rings) {
        const double size = signedArea(ring);
        if (size > 0.0) {
            pieces.push_back({std::move(ring), {}});
            sizes.push_back(size);
        } else if (size < 0.0) {
            holes.push_back(std::move(ring));
        }
    }
    if (pieces.size() == 1) {
        pieces.front().holes = std::move(holes);
        return pieces;
    }
    for (GridRing &hole : holes) {
        std::size_t best = pieces.size();
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if ((best == pieces.size() || sizes[i] < sizes[best]) &&
                liesInside(hole, pieces[i].outer))
                best = i;
        }
        if (best < pieces.size())
            pieces[best].holes.push_back(std::move(hole));
    }
    return pieces;
}

/// Regions whose rings meet themselves at corners, as such whose rings do not.
std::vector<GridRegion> separated(const std::vector<GridRegion> &regions)
{
    std::vector<GridRing> loops;
    for (const GridRegion &region : regions) {
        splitAtCorners(region.outer, loops);
        for (const GridRing &hole : region.holes)
            splitAtCorners(hole, loops);
    }
    return nested(std::move(loops));
}

Vec2 inSteps(const GridPoint &p)
{
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

/// The ring with those of its corners put in that lie on its edges, but for their own.
GridRing withTouches(GridRing ring)
{
    constexpr double kTouch = kClipSlack / kClipGrid; // steps
    struct Touch
    {
        std::size_t edge = 0;
        double along = 0.0; // steps from the edge's start
        GridPoint corner;
    };
    const std::size_t count = ring.size();
    const auto at = [&](std::size_t i) -> const GridPoint & { return ring[i < count ? i : 0]; };
    BoxRuns edges;
    edges.fill(count, [&](std::size_t i) {
        Box2 box;
        box.extend(inSteps(at(i)));
        box.extend(inSteps(at(i + 1)));
        return box;
    });
    std::vector<Touch> touches;
    for (const GridPoint &corner : ring) {
        const Vec2 p = inSteps(corner);
        const Box2 near{p - Vec2::Constant(kTouch), p + Vec2::Constant(kTouch)};
        edges.any([&](const Box2 &box) { return box.intersects(near); },
                  [&](std::size_t i) {
                      const Vec2 from = inSteps(at(i)), to = inSteps(at(i + 1));
                      const double along = (p - from).dot((to - from).normalized());
                      if (along > kTouch && along < (to - from).norm() - kTouch &&
                          distanceToSegment(p, from, to) <= kTouch)
                          touches.push_back({i, along, corner});
                      return false;
                  });
    }
    if (touches.empty())
        return ring;
    std::sort(touches.begin(), touches.end(), [](const Touch &a, const Touch &b) {
        return a.edge != b.edge ? a.edge < b.edge : a.along < b.along;
    });
    GridRing whole;
    whole.reserve(count + touches.size());
    auto touch = touches.begin();
    for (std::size_t i = 0; i < count; ++i) {
        whole.push_back(ring[i]);
        for (; touch != touches.end() && touch->edge == i; ++touch)
            whole.push_back(touch->corner);
    }
    return whole;
}

/// Throws what Clipper throws.
std::vector<GridRegion> execute(const std::vector<GridRing> &subjects, Winding rule,
                                const std::vector<GridRing> &clips)
{
    ClipperLib::Clipper clipper;
    // Corners along a straight edge are where a curve's segments meet: they must survive.
    clipper.PreserveCollinear(true);
    bool hasSubject = false; // rings that are flat are none
    for (const GridRing &ring : subjects)
        hasSubject |= clipper.AddPath(toPath(ring), ClipperLib::ptSubject, true);
    for (const GridRing &ring : clips)
        clipper.AddPath(toPath(ring), ClipperLib::ptClip, true);
    // Not as a tree: Clipper's own nesting takes seconds where edges lie on each other a
    // thousand times, as those of a contour that goes to and fro on one curve.
    ClipperLib::Paths paths;
    if (!hasSubject)
        return {};
    if (!clipper.Execute(ClipperLib::ctDifference, paths, fillType(rule), ClipperLib::pftNonZero))
        throw ClipperLib::clipperException("it says that it did not succeed");
    std::vector<GridRing> rings;
    rings.reserve(paths.size());
    for (const ClipperLib::Path &path : paths)
        rings.push_back(toRing(path));
    return nested(std::move(rings));
}

} // namespace

ClipGrid::ClipGrid(const Box2 &box)
{
    if (box.isEmpty())
        return;
    const Vec2 middle = box.center() / kClipGrid;
    m_x = rounded(middle.x());
    m_y = rounded(middle.y());
}

Polygon ClipGrid::positions(const GridRing &ring) const
{
    Polygon polygon;
    polygon.reserve(ring.size());
    for (const GridPoint &p : ring)
        polygon.push_back(position(p));
    return polygon;
}

double signedArea(const GridRing &ring)
{
    if (ring.empty())
        return 0.0;
    // Extended precision about the first point: two areas of one boundary must compare equal.
    const GridPoint base = ring.front();
    long double sum = 0.0L;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        sum += static_cast<long double>(ring[j].x - base.x) *
                   static_cast<long double>(ring[i].y - base.y) -
               static_cast<long double>(ring[i].x - base.x) *
                   static_cast<long double>(ring[j].y - base.y);
    return static_cast<double>(0.5L * sum);
}

double area(const GridRegion &region)
{
    double result = std::abs(signedArea(region.outer));
    for (const GridRing &hole : region.holes)
        result -= std::abs(signedArea(hole));
    return result;
}

std::vector<GridRegion> apartAtPoints(std::vector<GridRegion> regions)
{
    bool touches = false;
    const auto look = [&](GridRing &ring) {
        const std::size_t count = ring.size();
        ring = withTouches(std::move(ring));
        touches |= ring.size() != count;
    };
    for (GridRegion &region : regions) {
        look(region.outer);
        for (GridRing &hole : region.holes)
            look(hole);
    }
    return touches ? separated(regions) : regions;
}

Result<std::vector<GridRegion>> clip(const std::vector<GridRing> &subjects, Winding rule,
                                     const std::vector<GridRing> &clips)
{
    try {
        if (failsHere(FaultPoint::Boolean))
            throw ClipperLib::clipperException("asked for");
        std::vector<GridRegion> regions = execute(subjects, rule, clips);
        // Clipper's own separation of loops that touch is quadratic.
        const bool touches = std::any_of(regions.begin(), regions.end(),
                                         [](const GridRegion &r) { return touchesItself(r); });
        return touches ? separated(regions) : std::move(regions);
    } catch (const ClipperLib::clipperException &) {
        return failure(ErrorCode::NotWorkedOut);
    }
}

} // namespace fff
