// The solid of a body that is bent, as arrays to be uploaded.
#pragma once

#include "core/physics/stress_field.h"
#include "ui/view/slab_mesh.h"

namespace fff::ui {

/// moved  of each point of the field as far as it is shown to move, (u, v, n) of the section's
///        frame, mm
/// half   of the thickness, mm
/// The first vertices are the field's points on the face to which n points, then those on the other
/// one; walls and edges follow the boundary of its triangles. The sheet stays as thick along n.
SlabMesh bentMesh(const StressField &field, const std::vector<Vec3> &moved, double half);

} // namespace fff::ui
