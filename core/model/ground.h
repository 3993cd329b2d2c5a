// Cutting shapes flat at the ground, the plane Y = 0, so that feet stand on it. A deliberate
// deviation from the paper, which moves control points there.
#pragma once

#include "core/geometry/frame.h"
#include "core/geometry/halfplane_clip.h"
#include "core/model/shape.h"

#include <optional>
#include <vector>

namespace fff {

/// The line in which the frame's plane meets the ground, what is above it inside; frame
/// coordinates. None for a level plane, whose normal is vertical to kSameDirection.
std::optional<Halfplane> groundLine(const Frame &frame);

/// The contour, or the shape, without what lies below the ground: connected pieces, largest first.
/// The very pointer (the contour bit for bit) where nothing is below; empty where nothing is above.
/// A level plane is above or below as a whole; on the ground is above. See clip() for the rest, and
/// the errors.
Result<std::vector<ClippedPiece>> clippedAtGround(const Contour &contour, const Frame &frame);
Result<std::vector<ShapePointer>> clippedAtGround(const ShapePointer &shape, const Frame &frame);

} // namespace fff
