#include "core/geometry/clip_grid.h"

#include "core/base/tolerances.h"

#include <cmath>
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

bool touchesItself(const GridRegion &region)
{
    const auto hasRepeat = [](GridRing ring) {
        std::sort(ring.begin(), ring.end());
        return std::adjacent_find(ring.begin(), ring.end()) != ring.end();
    };
    return hasRepeat(region.outer) ||
           std::any_of(region.holes.begin(), region.holes.end(), hasRepeat);
}

/// Throws what Clipper throws.
std::vector<GridRegion> execute(const std::vector<GridRing> &subjects, Winding rule,
                                const std::vector<GridRing> &clips, bool strictlySimple)
{
    ClipperLib::Clipper clipper;
    // Corners along a straight edge are where a curve's segments meet: they must survive.
    clipper.PreserveCollinear(true);
    clipper.StrictlySimple(strictlySimple);
    for (const GridRing &ring : subjects)
        clipper.AddPath(toPath(ring), ClipperLib::ptSubject, true);
    for (const GridRing &ring : clips)
        clipper.AddPath(toPath(ring), ClipperLib::ptClip, true);
    ClipperLib::PolyTree tree;
    if (!clipper.Execute(ClipperLib::ctDifference, tree, fillType(rule), ClipperLib::pftNonZero))
        return {};

    std::vector<GridRegion> regions;
    for (const ClipperLib::PolyNode *node = tree.GetFirst(); node; node = node->GetNext()) {
        if (node->IsHole())
            continue;
        GridRegion region{toRing(node->Contour), {}};
        for (const ClipperLib::PolyNode *hole : node->Childs)
            region.holes.push_back(toRing(hole->Contour));
        regions.push_back(std::move(region));
    }
    return regions;
}

std::vector<GridRegion> run(const std::vector<GridRing> &subjects, Winding rule,
                            const std::vector<GridRing> &clips, bool strictlySimple)
{
    try {
        return execute(subjects, rule, clips, strictlySimple);
    } catch (const ClipperLib::clipperException &) {
        return {};
    }
}

} // namespace

ClipGrid::ClipGrid(const Box2 &box)
{
    if (box.isEmpty())
        return;
    const Vec2 middle = box.center() / kClipGrid;
    m_x = std::llround(middle.x());
    m_y = std::llround(middle.y());
}

GridPoint ClipGrid::snap(const Vec2 &point) const
{
    return {std::llround(point.x() / kClipGrid) - m_x, std::llround(point.y() / kClipGrid) - m_y};
}

Vec2 ClipGrid::position(const GridPoint &point) const
{
    return {static_cast<double>(point.x + m_x) * kClipGrid,
            static_cast<double>(point.y + m_y) * kClipGrid};
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

std::vector<GridRegion> clip(const std::vector<GridRing> &subjects, Winding rule,
                             const std::vector<GridRing> &clips)
{
    // Clipper's separation of touching rings is quadratic, and hardly ever needed.
    std::vector<GridRegion> regions = run(subjects, rule, clips, false);
    if (std::any_of(regions.begin(), regions.end(), touchesItself))
        regions = run(subjects, rule, clips, true);
    return regions;
}

} // namespace fff
