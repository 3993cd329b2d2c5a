// Whether a ring on the grid meets itself anywhere. Internal to geometry.
#pragma once

#include "core/geometry/clip_grid.h"

#include <optional>
#include <span>

namespace fff {

/// True only when no two edges of the ring have more in common than the vertex between neighbours:
/// then it winds once round what is inside. Exact. False also for rings that merely touch
/// themselves. At least 3 vertices, none followed by its equal.
/// O(n log n) for what people draw: edges sorted along one side of the ring's box, each compared
/// with those that reach beside it.
bool isSimple(const GridRing &ring);

/// The same of each of several rings, and that no two of them have a point in common.
bool areSimpleAndApart(std::span<const GridRing> rings);

/// A place where that is not so, near enough to look there; nothing where it is.
std::optional<GridPoint> firstMeeting(std::span<const GridRing> rings);

/// Whether edges of two rings have a point in common. Exact; the same cost.
bool meet(const GridRing &a, const GridRing &b);

} // namespace fff
