#include "core/io/svg_clip.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/line_clip.h"

#include <algorithm>

namespace fff::io {

namespace {

/// What of the contour lies in the clip: the contour without what is outside, and what of the clip
/// is a hole in that.
Result<std::vector<Contour>> clippedContour(const Contour &contour,
                                            const std::vector<Contour> &clip)
{
    std::vector<Contour> outside, inside;
    const auto beyond = subtractContours(contour, {}, clip, kCutChord);
    if (!beyond)
        return tl::unexpected(beyond.error());
    for (const CurvedRegion &region : *beyond) {
        outside.push_back(region.outer);
        for (const Contour &hole : region.holes)
            inside.push_back(hole.reversed());
    }
    if (outside.empty())
        return std::vector<Contour>{contour};
    const auto within = subtractContours(contour, {}, outside, kCutChord);
    if (!within)
        return tl::unexpected(within.error());
    for (const CurvedRegion &region : *within) {
        inside.push_back(region.outer);
        inside.insert(inside.end(), region.holes.begin(), region.holes.end());
    }
    return inside;
}

/// Whether a convex contour of the clip has all of the box: nothing is cut then, and what is in it
/// stays exactly what it is. False where that is not known.
bool contains(const std::vector<Contour> &clip, const Box2 &box)
{
    return std::any_of(clip.begin(), clip.end(), [&box](const Contour &contour) {
        const Polygon corners = contour.polygon(kCutChord);
        const auto has = [&corners](double x, double y) {
            return locate(Vec2(x, y), corners) != Side::Outside;
        };
        return convexHull(corners).size() == corners.size() && has(box.min.x(), box.min.y()) &&
               has(box.max.x(), box.min.y()) && has(box.max.x(), box.max.y()) &&
               has(box.min.x(), box.max.y());
    });
}

} // namespace

Result<std::vector<CurvePath>> clippedPath(const CurvePath &path, const std::vector<Contour> &clip)
{
    if (contains(clip, path.bounds()))
        return std::vector<CurvePath>{path};
    std::vector<CurvePath> left;
    if (!path.isClosed()) {
        std::vector<Contour> alike; // running the same way, so that they unite
        for (const Contour &contour : clip)
            alike.push_back(contour.signedArea() < 0.0 ? contour.reversed() : contour);
        const auto regions = windingRegions(alike, WindingRule::NonZero, kCutChord);
        if (!regions)
            return tl::unexpected(regions.error());
        for (const CurvedRegion &region : *regions) {
            const auto pieces = clippedLine(path.flatten(kCutChord), region.region);
            if (!pieces)
                return tl::unexpected(pieces.error());
            for (const Polygon &piece : *pieces)
                if (Result<CurvePath> cut = CurvePath::fromLine(piece))
                    left.push_back(*std::move(cut));
        }
        return left;
    }
    std::vector<Vec2> points = path.points();
    points.pop_back();
    if (points.size() < 6)
        return left;
    const Result<Contour> contour = Contour::fromPoints(std::move(points));
    if (!contour)
        return tl::unexpected(contour.error());
    const auto pieces = clippedContour(*contour, clip);
    if (!pieces)
        return tl::unexpected(pieces.error());
    for (const Contour &piece : *pieces)
        left.push_back(CurvePath::around(piece));
    return left;
}

} // namespace fff::io
