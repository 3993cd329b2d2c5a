// Where a plane crosses the triangles of a mesh: pieces between edges of the mesh. Internal to
// templates.
#pragma once

#include "core/templates/mesh_tree.h"

namespace fff {

/// Where vertices on the plane count to. Each is the cut by a plane that is shifted by less than
/// anything, to its other side, so that a plane through vertices and along faces crosses edges only
/// in between.
enum class OnPlane { Above, Below };

/// An edge of the mesh that is crossed: lower and higher vertex.
struct CrossedEdge
{
    std::uint32_t low = 0, high = 0;

    bool operator==(const CrossedEdge &) const = default;
};

/// Of one triangle, from edge to edge; what the mesh encloses lies to the left, seen from the
/// normal's tip, where its triangles look outwards.
struct CutSegment
{
    CrossedEdge from, to;
    std::uint32_t face = 0;
};

struct CutSegments
{
    std::vector<CutSegment> segments; // in the order of the triangles
    bool liesInPlane = false;         // a triangle does, with all three corners
};

/// tree: of this mesh; null: all triangles are looked at.
CutSegments cutSegments(const TriangleMesh &mesh, const CutPlane &plane, OnPlane onPlane,
                        const MeshTree *tree);

} // namespace fff
