// The solid of a body that is bent, as arrays to be uploaded once: flat, and where each vertex
// goes, so that the graphics card bends it as far as it is shown to.
#pragma once

#include "core/physics/stress_field.h"
#include "ui/view/slab_mesh.h"

#include <map>

namespace fff::ui {

/// Of a vertex, as far as the body really moves; `times` as far is
///
///     position + times by        normal + times turn + times² turnMore        (not of length 1)
///
/// of a face exactly: its normal is a sum of products of two sides. Walls keep theirs.
struct VertexMotion
{
    std::array<float, 3> by{}, turn{}, turnMore{}; // in the mesh's coordinates; normals in mm
};

/// Of an edge, in the same way; its first normal turns.
struct EdgeMotion
{
    std::array<float, 3> from{}, to{}, turn{}, turnMore{};
};

struct BentSlab
{
    SlabMesh flat;
    std::vector<VertexMotion> motions;   // of each vertex
    std::vector<EdgeMotion> edgeMotions; // of each edge
    std::vector<std::uint32_t> onFace;   // of each vertex: that of a face at the same place

    /// As it is drawn, for whoever has to know on this side.
    std::array<float, 3> placeAt(std::size_t vertex, double times) const;
};

/// moved  of each point of the field, (u, v, n) of the section's frame, mm
/// half   of the thickness, mm
/// The first vertices are the field's points on the face to which n points, then those on the other
/// one; walls and edges follow the boundary of its triangles. The sheet stays as thick along n.
BentSlab bentSlab(const StressField &field, const std::vector<Vec3> &moved, double half);

/// The way round the triangles of a field: from each point of the boundary to the next, material on
/// the left.
std::map<int, int> boundaryOf(const StressField &field);

} // namespace fff::ui
