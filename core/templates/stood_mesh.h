// A mesh of few faces, turned so that it stands on one of them.
#pragma once

#include "core/templates/triangle_mesh.h"

namespace fff {

/// A mesh that leans on a face by no more than this is meant to stand on it (15°): simplifying
/// tilts what was level.
inline constexpr double kMostLean = 0.26179938779914941;

/// The mesh, whose coordinates are mm and whose faces look outwards, turned by the least angle that
/// brings one of its flat pieces to the ground, level: of those that look down within kMostLean,
/// and below which nothing of the mesh is, the largest. Its lowest point keeps its height, and the
/// middle of its box its place above the ground. Null where it stands level already, or there is no
/// such piece.
TriangleMeshPointer stoodOnFacet(const TriangleMesh &mesh);

} // namespace fff
