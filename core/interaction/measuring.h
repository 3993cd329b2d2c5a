// Places of the model that can be measured, and lengths between them.
#pragma once

#include "core/interaction/gesture.h"
#include "core/model/dimensions.h"

#include <optional>

namespace fff {

/// A place, and where it belongs.
struct MeasuredPlace
{
    Vec3 point = Vec3::Zero(); // world, mm
    Anchor anchor;
};

/// What is meant at a place of the screen: a control point or a corner of a slit nearby, else the
/// nearest place of a contour nearby, else the section under it, else the ground, and where that
/// cannot be seen, the plane through the origin that faces the view. With `snaps` false what is
/// under it to the pixel.
std::optional<MeasuredPlace> measuredPlaceAt(const Vec2 &position, bool snaps,
                                             const GestureContext &context);

/// The dimension whose line is within reach of the position; not valid: none.
DimensionId dimensionAt(const Vec2 &position, const GestureContext &context);

/// How near a place must be to be meant, px.
inline constexpr double kMeasureReach = 10.0;

} // namespace fff
