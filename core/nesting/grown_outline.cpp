#include "core/nesting/grown_outline.h"

#include "core/base/tolerances.h"
#include "core/geometry/simplified_line.h"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff::nest {

namespace {

namespace C = ClipperLib;

constexpr double kMitre = 2.0;

C::Path pathOf(const Polygon &polygon)
{
    C::Path path;
    path.reserve(polygon.size());
    for (const Vec2 &p : polygon)
        path.emplace_back(std::llround(p.x() / kClipGrid), std::llround(p.y() / kClipGrid));
    return path;
}

Polygon polygonOf(const C::Path &path)
{
    Polygon polygon;
    polygon.reserve(path.size());
    for (const C::IntPoint &p : path)
        polygon.emplace_back(static_cast<double>(p.X) * kClipGrid,
                             static_cast<double>(p.Y) * kClipGrid);
    return polygon;
}

/// The rings as what they enclose, whatever way they run.
C::Paths enclosed(const Region &region)
{
    C::Clipper clipper;
    const C::Path outer = pathOf(region.outer);
    if (!clipper.AddPath(outer, C::ptSubject, true))
        return {};
    for (const Polygon &hole : region.holes)
        clipper.AddPath(pathOf(hole), C::ptClip, true);
    C::Paths result;
    clipper.Execute(C::ctDifference, result, C::pftNonZero, C::pftNonZero);
    return result;
}

C::Paths grownPaths(const C::Paths &paths, double distance)
{
    C::ClipperOffset offset(kMitre);
    offset.AddPaths(paths, C::jtMiter, C::etClosedPolygon);
    C::Paths result;
    offset.Execute(result, distance / kClipGrid);
    return result;
}

/// Connected pieces.
std::vector<Region> regionsOf(const C::PolyTree &tree)
{
    std::vector<Region> regions;
    for (const C::PolyNode *node = tree.GetFirst(); node; node = node->GetNext()) {
        if (node->IsHole())
            continue;
        Region region;
        region.outer = polygonOf(node->Contour);
        for (const C::PolyNode *hole : node->Childs)
            region.holes.push_back(polygonOf(hole->Contour));
        regions.push_back(std::move(region));
    }
    return regions;
}

std::vector<Region> regionsOf(const C::Paths &paths)
{
    C::Clipper clipper;
    clipper.AddPaths(paths, C::ptSubject, true);
    C::PolyTree tree;
    clipper.Execute(C::ctUnion, tree, C::pftNonZero, C::pftNonZero);
    return regionsOf(tree);
}

Polygon rectangle(const Box2 &box)
{
    return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}

Polygon simplifiedRing(const Polygon &ring, double error)
{
    if (!(error > 0.0) || ring.size() < 5)
        return ring;
    std::vector<Vec2> line(ring);
    line.push_back(ring.front());
    Polygon result;
    for (const std::size_t index : simplified(line, error))
        result.push_back(line[index]);
    result.pop_back();
    return result.size() < 3 ? ring : result;
}

/// The largest piece of the outline grown by so much; nothing for what has no area.
std::optional<Region> largestGrown(const C::Paths &outline, double distance)
{
    std::vector<Region> regions = regionsOf(grownPaths(outline, distance));
    const auto isSmaller = [](const Region &a, const Region &b) { return area(a) < area(b); };
    const auto largest = std::max_element(regions.begin(), regions.end(), isSmaller);
    return largest == regions.end() ? std::nullopt : std::optional(std::move(*largest));
}

std::size_t cornerCount(const Region &region)
{
    std::size_t count = region.outer.size();
    for (const Polygon &hole : region.holes)
        count += hole.size();
    return count;
}

} // namespace

Region grownOutline(const Region &outline, double distance, double slack)
{
    const C::Paths paths = enclosed(outline);
    std::optional<Region> grown = largestGrown(paths, distance);
    if (!grown) {
        const Vec2 more = Vec2::Constant(distance);
        const Box2 box = bounds(outline.outer);
        return {rectangle({box.min - more, box.max + more}), {}};
    }
    if (!(slack > 0.0))
        return *std::move(grown);
    Region simple = largestGrown(paths, distance + slack).value_or(*grown);
    simple.outer = simplifiedRing(simple.outer, slack);
    for (Polygon &hole : simple.holes)
        hole = simplifiedRing(hole, slack);
    // What has few corners as it is stays as small as it is.
    return 4 * cornerCount(simple) < 3 * cornerCount(*grown) ? simple : *std::move(grown);
}

Inside insideOf(const Region &container, double distance)
{
    Inside inside;
    const C::Paths left = grownPaths(enclosed(container), -distance);
    for (const C::Path &path : left)
        inside.box.extend(bounds(polygonOf(path)));
    if (inside.box.isEmpty())
        return inside;
    C::Clipper clipper;
    clipper.AddPath(pathOf(rectangle(inside.box)), C::ptSubject, true);
    clipper.AddPaths(left, C::ptClip, true);
    C::PolyTree tree;
    clipper.Execute(C::ctDifference, tree, C::pftEvenOdd, C::pftNonZero);
    inside.obstacles = regionsOf(tree);
    return inside;
}

} // namespace fff::nest
