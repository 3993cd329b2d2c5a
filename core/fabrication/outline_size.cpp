#include "core/fabrication/outline_size.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>

namespace fff {

namespace {

/// Chords on which it is told how a part is best turned, as a share of its size, and mm at most;
/// its box is that of its curves.
constexpr double kTurnShare = 0.01, kMaxTurnChord = 1.0;

double areaOf(const CurvedRegion &outline)
{
    double sum = outline.outer.signedArea();
    for (const Contour &hole : outline.holes)
        sum += hole.signedArea();
    return sum;
}

bool hasCurves(const CurvedRegion &outline)
{
    for (int i = 0; i < outline.outer.segmentCount(); ++i)
        if (!outline.outer.segment(i).isStraight(kClipGrid))
            return true;
    return false;
}

Pose poseOf(const Contour &outline, const Vec2 &turn)
{
    return {turn, turnedBounds(outline, turn)};
}

} // namespace

Pose quarterMore(const Pose &pose)
{
    Pose next{perpendicular(pose.turn), {}};
    next.box.extend(perpendicular(pose.box.min));
    next.box.extend(perpendicular(pose.box.max));
    return next;
}

bool fits(const Vec2 &size, const Vec2 &room)
{
    return (size.array() <= room.array() + kClipGrid).all();
}

bool haveSamePoses(const OutlineSize &a, const OutlineSize &b)
{
    return &a == &b || (a.drawn == b.drawn && a.smallest == b.smallest && a.lowest == b.lowest &&
                        a.isTooLarge == b.isTooLarge && a.fitting == b.fitting);
}

OutlineSize sizeOf(const CurvedRegion &outline, const Vec2 &room, bool turnsFreely)
{
    OutlineSize result;
    result.area = areaOf(outline);
    result.drawn = poseOf(outline.outer, Vec2::UnitX());
    result.smallest = result.lowest = result.drawn;
    const Vec2 size = result.drawn.size();
    const bool fitsStraight = fits(size, room) || fits(quarterMore(result.drawn).size(), room);
    if (!fitsStraight) {
        result.isTooLarge = true;
        // Longer than the room's diagonal, it fits at no angle.
        const bool isHopeless = !turnsFreely || size.maxCoeff() > room.norm() + kClipGrid;
        const Polygon hull =
            isHopeless ? Polygon() : convexHull(outline.outer.flatten(kCutChord).points);
        if (hull.size() < 3)
            return result;
        const double bulge = hasCurves(outline) ? 2.0 * kCutChord : 0.0; // beyond the chords
        if (const auto turn = findFittingTurn(hull, room - Vec2::Constant(bulge))) {
            result.isTooLarge = false;
            result.fitting = poseOf(outline.outer, *turn);
        }
        return result;
    }
    if (turnsFreely) {
        const double chord = std::min(kTurnShare * size.maxCoeff(), kMaxTurnChord);
        const Turns turns = findTurns(outline.outer.polygon(chord));
        result.smallest = poseOf(outline.outer, turns.smallest);
        result.lowest =
            turns.lowest == turns.smallest ? result.smallest : poseOf(outline.outer, turns.lowest);
    }
    return result;
}

} // namespace fff
