// Joints that an edit of a contour does not come near. Internal to assembly.
#pragma once

#include "core/assembly/found_joint.h"
#include "core/model/shape_change.h"

#include <optional>

namespace fff {

/// The joint of two sections (indices into the model, a < b) as findJoint() would have it now, by
/// what it was before: where all that differs of either is its shape, and that only beside the
/// strip which the other's slab takes up, on one side of it. Nothing where that does not tell.
///
/// before        of the model before, with sections and mates numbered as they are now
/// ofA, ofB      null: the section's shape is the same
std::optional<FoundJoint> keptJoint(const Model &model, const Assembly &before, int a, int b,
                                    const ShapeChange *ofA, const ShapeChange *ofB);

} // namespace fff
