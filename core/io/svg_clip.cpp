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
std::vector<Contour> clippedContour(const Contour &contour, const std::vector<Contour> &clip)
{
    std::vector<Contour> outside, inside;
    for (const CurvedRegion &region : subtractContours(contour, {}, clip, kCutChord)) {
        outside.push_back(region.outer);
        for (const Contour &hole : region.holes)
            inside.push_back(hole.reversed());
    }
    if (outside.empty())
        return {contour};
    for (const CurvedRegion &region : subtractContours(contour, {}, outside, kCutChord)) {
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

std::vector<CurvePath> clippedPath(const CurvePath &path, const std::vector<Contour> &clip)
{
    if (contains(clip, path.bounds()))
        return {path};
    std::vector<CurvePath> left;
    if (!path.isClosed()) {
        std::vector<Contour> alike; // running the same way, so that they unite
        for (const Contour &contour : clip)
            alike.push_back(contour.signedArea() < 0.0 ? contour.reversed() : contour);
        for (const CurvedRegion &region : windingRegions(alike, WindingRule::NonZero, kCutChord))
            for (const Polygon &piece : clippedLine(path.flatten(kCutChord), region.region))
                if (Result<CurvePath> cut = CurvePath::fromLine(piece))
                    left.push_back(*std::move(cut));
        return left;
    }
    std::vector<Vec2> points = path.points();
    points.pop_back();
    if (const Result<Contour> contour = Contour::fromPoints(std::move(points)))
        for (const Contour &piece : clippedContour(*contour, clip))
            left.push_back(CurvePath::around(piece));
    return left;
}

} // namespace fff::io
