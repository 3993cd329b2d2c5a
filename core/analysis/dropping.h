// The whole model onto the ground.
#pragma once

#include "core/base/text.h"
#include "core/model/model.h"

#include <optional>

namespace fff::steps {

inline constexpr Text kDropToGround = FFF_TEXT("Step", "Drop to the ground");

} // namespace fff::steps

namespace fff {

/// Y of the lowest point of the slabs, mm; none without sections. O(vertices).
std::optional<double> lowestPoint(const Model &model);

/// The document with that point on the ground. Nothing where the model stands on it as it is
/// (assembly/stability.h): also with what lies there with its middle at Y = 0, or is a tenth of a
/// millimetre too low, as no verdict would be another one.
std::optional<Document> droppedToGround(const Model &model);

} // namespace fff
