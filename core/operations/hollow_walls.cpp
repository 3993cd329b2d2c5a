#include "core/operations/hollow_walls.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/polygon.h"
#include "core/geometry/raw_offset.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

/// How far what is left within a wall may be off, mm: nothing has to fit there.
constexpr double kRoomError = 0.02;

/// A room less the walls along the lines in which others cross the plane.
std::vector<Contour> roomsBetween(const Frame &frame, Contour room, const HollowOptions &options)
{
    if (options.crossing.empty())
        return {std::move(room)};
    const Box2 box = room.bounds();
    const double far = box.size().norm(), half = 0.5 * (options.wall + options.thickness);
    std::vector<Polygon> walls;
    for (const Frame &other : options.crossing) {
        const Vec2 slope = frame.directionToLocal(other.normal());
        if (slope.norm() < std::sin(kMinJointAngle))
            continue;
        const Vec2 across = slope.normalized(), along = perpendicular(across);
        const Vec2 foot =
            box.center() - other.height(frame.toWorld(box.center())) / slope.norm() * across;
        if ((foot - box.center()).norm() > far + half)
            continue;
        walls.push_back({foot - far * along - half * across, foot + far * along - half * across,
                         foot + far * along + half * across, foot - far * along + half * across});
    }
    const Result<std::vector<CurvedRegion>> left = subtract(room, {}, walls, kRoomError);
    if (!left)
        return {};
    std::vector<Contour> rooms;
    for (const CurvedRegion &region : *left)
        rooms.push_back(region.outer.reversed());
    return rooms;
}

} // namespace

std::vector<Contour> roomIn(const Contour &contour, double wall)
{
    // Clockwise, its right is inside. What winds back there takes the frame's winding away, and
    // where the offset has run over itself it adds to it.
    const Result<RawOffset> inside =
        rawOffset(contour.signedArea() > 0.0 ? contour.reversed() : contour, wall, kRoomError);
    if (!inside)
        return {};
    const Box2 box = contour.bounds();
    const Vec2 margin = Vec2::Constant(wall) + box.size();
    const Vec2 low = box.min - margin, high = box.max + margin;
    const Contour frame = Contour::ofPolygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}});
    Result<std::vector<CurvedRegion>> regions =
        windingRegions({frame, inside->contour}, WindingRule::NonZero, kRoomError);
    return regions && !regions->empty() ? std::move(regions->front().holes)
                                        : std::vector<Contour>();
}

std::vector<Contour> hollowOf(const Frame &frame, const Contour &contour,
                              const std::vector<Contour> &holes, const HollowOptions &options)
{
    std::vector<Contour> taken;
    for (Contour &room : roomIn(contour, options.wall)) {
        const Polygon polygon = room.polygon(kDrawChord);
        const bool isFree = std::none_of(holes.begin(), holes.end(), [&](const Contour &hole) {
            return locate(hole.points().front(), polygon) != Side::Outside;
        });
        if (!isFree)
            continue;
        for (Contour &part : roomsBetween(frame, std::move(room), options))
            if (std::abs(part.signedArea()) >= options.smallest)
                taken.push_back(std::move(part));
    }
    return taken;
}

} // namespace fff
