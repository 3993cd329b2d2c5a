#include "core/templates/loop_nesting.h"

#include "core/geometry/polygon.h"
#include "core/geometry/side_of_line.h"

#include <algorithm>
#include <optional>

namespace fff {

namespace {

/// Positive for counter-clockwise; about the first point, where little is lost.
double signedAreaOf(const std::vector<Vec2> &points)
{
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        twice += cross(points[i] - points[0], points[i + 1] - points[0]);
    return 0.5 * twice;
}

/// None for a point on the edge.
std::optional<bool> isInLoop(const Vec2 &point, const std::vector<Vec2> &loop)
{
    bool isInside = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        switch (rayMeeting(point, loop[j], loop[i])) {
        case RayMeeting::Begins:
            return std::nullopt;
        case RayMeeting::Crosses:
            isInside = !isInside;
            break;
        case RayMeeting::None:
            break;
        }
    }
    return isInside;
}

struct FlatLoop
{
    std::vector<Vec2> points;
    Box2 box;
    double signedArea = 0.0;
    std::size_t index = 0;
};

/// By the first of its points that is not on the other's edge; of loops that meet everywhere, no.
bool liesIn(const FlatLoop &loop, const FlatLoop &other)
{
    if (!(loop.box.min.array() >= other.box.min.array()).all() ||
        !(loop.box.max.array() <= other.box.max.array()).all())
        return false;
    for (const Vec2 &p : loop.points)
        if (const std::optional<bool> isInside = isInLoop(p, other.points))
            return *isInside;
    return false;
}

} // namespace

void nestLoops(std::vector<CutLoop> &loops, const Frame &frame)
{
    std::vector<FlatLoop> flat(loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i) {
        FlatLoop &loop = flat[i];
        loop.index = i;
        loop.points.reserve(loops[i].points.size());
        for (const Vec3 &p : loops[i].points) {
            loop.points.push_back(frame.toLocal(p));
            loop.box.extend(loop.points.back());
        }
        loop.signedArea = signedAreaOf(loop.points);
        loops[i].area = std::abs(loop.signedArea);
    }
    std::stable_sort(flat.begin(), flat.end(), [&](const FlatLoop &a, const FlatLoop &b) {
        return loops[a.index].area > loops[b.index].area;
    });
    std::vector<CutLoop> sorted;
    sorted.reserve(loops.size());
    for (std::size_t i = 0; i < flat.size(); ++i) {
        CutLoop loop = std::move(loops[flat[i].index]);
        const auto around =
            std::count_if(flat.begin(), flat.begin() + static_cast<std::ptrdiff_t>(i),
                          [&](const FlatLoop &other) { return liesIn(flat[i], other); });
        loop.isHole = loop.isOriented ? flat[i].signedArea < 0.0 && around > 0 : around % 2 == 1;
        if (loop.isHole != (flat[i].signedArea < 0.0))
            loop.reverse();
        sorted.push_back(std::move(loop));
    }
    loops = std::move(sorted);
}

} // namespace fff
