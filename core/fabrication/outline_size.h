// How large an outline is, however it may lie on a sheet: what a layout asks of a part, worked out
// once for as long as the outline stays.
#pragma once

#include "core/geometry/boolean.h"
#include "core/geometry/turning.h"

#include <optional>

namespace fff {

/// A part's box after a turn.
struct Pose
{
    Vec2 turn = Vec2::UnitX();
    Box2 box;

    Vec2 size() const { return box.size(); }
    bool operator==(const Pose &other) const
    {
        return turn == other.turn && box.min == other.box.min && box.max == other.box.max;
    }
};

/// The same a quarter turn further.
Pose quarterMore(const Pose &pose);

/// Whether a box of this size goes into the room.
bool fits(const Vec2 &size, const Vec2 &room);

struct OutlineSize
{
    double area = 0.0; // mm², without its holes
    Pose drawn;
    Pose smallest, lowest; // of all turns; as drawn where it is not turned freely
    bool isTooLarge = false;
    std::optional<Pose> fitting; // where it fits neither as drawn nor by a quarter turn
};

/// Whether they may lie in the same ways; their areas may differ.
bool haveSamePoses(const OutlineSize &a, const OutlineSize &b);

/// room         mm, of a sheet without its margins
/// turnsFreely  false: quarter turns only
/// O(v log v).
OutlineSize sizeOf(const CurvedRegion &outline, const Vec2 &room, bool turnsFreely);

} // namespace fff
