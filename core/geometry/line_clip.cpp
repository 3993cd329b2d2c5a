#include "core/geometry/line_clip.h"

#include "core/base/fault_point.h"
#include "core/geometry/clip_grid.h"

#include <algorithm>
#include <polyclipping/clipper.hpp>

namespace fff {

namespace {

ClipperLib::Path toPath(const Polygon &line, const ClipGrid &grid)
{
    ClipperLib::Path path;
    path.reserve(line.size());
    for (const Vec2 &point : line) {
        const GridPoint p = grid.snap(point);
        path.emplace_back(p.x, p.y);
    }
    return path;
}

} // namespace

Result<std::vector<Polygon>> clippedLine(const Polygon &line, const Region &region)
{
    Box2 box = bounds(region.outer);
    for (const Vec2 &p : line)
        box.extend(p);
    const ClipGrid grid(box);
    ClipperLib::Clipper clipper;
    ClipperLib::PolyTree found;
    std::vector<Polygon> pieces;
    try {
        if (failsHere(FaultPoint::Line))
            throw ClipperLib::clipperException("asked for");
        if (!clipper.AddPath(toPath(line, grid), ClipperLib::ptSubject, false))
            return pieces; // a point
        clipper.AddPath(toPath(region.outer, grid), ClipperLib::ptClip, true);
        for (const Polygon &hole : region.holes)
            clipper.AddPath(toPath(hole, grid), ClipperLib::ptClip, true);
        if (!clipper.Execute(ClipperLib::ctIntersection, found, ClipperLib::pftEvenOdd,
                             ClipperLib::pftEvenOdd))
            return failure(ErrorCode::NotWorkedOut);
    } catch (const ClipperLib::clipperException &) {
        return failure(ErrorCode::NotWorkedOut);
    }
    ClipperLib::Paths paths;
    ClipperLib::OpenPathsFromPolyTree(found, paths);
    for (const ClipperLib::Path &path : paths) {
        Polygon piece;
        for (const ClipperLib::IntPoint &p : path)
            piece.push_back(grid.position({p.X, p.Y}));
        // Clipper may walk a piece from its end.
        const auto at = [&](const Vec2 &p) {
            return std::min_element(line.begin(), line.end(),
                                    [&p](const Vec2 &a, const Vec2 &b) {
                                        return (a - p).squaredNorm() < (b - p).squaredNorm();
                                    }) -
                   line.begin();
        };
        if (piece.size() >= 2 && at(piece.front()) > at(piece.back()))
            std::reverse(piece.begin(), piece.end());
        if (piece.size() >= 2)
            pieces.push_back(std::move(piece));
    }
    return pieces;
}

} // namespace fff
