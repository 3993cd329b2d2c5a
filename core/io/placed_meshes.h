// Meshes that a file has once and places often. Internal to io.
#pragma once

#include "core/io/mesh_builder.h"

#include <Eigen/Geometry>

namespace fff::io {

/// Adds vertices and triangles of `part` under a map; one that mirrors turns the triangles over.
/// False, and an error, where there are too many.
bool addPlaced(MeshBuilder &builder, const MeshDraft &part, const Eigen::Affine3d &place);

/// How deep files may nest what they place: what goes deeper goes round in a circle.
inline constexpr int kMostNested = 64;

} // namespace fff::io
