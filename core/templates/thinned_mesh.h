// A mesh with fewer triangles that looks like it from afar: what is drawn while the view moves.
#pragma once

#include "core/templates/triangle_mesh.h"

#include <vector>

namespace fff {

/// Vertices of a cell of a grid are one, at their mean; triangles of which less than three cells
/// are left are none. The grid is as fine as leaves about `most` triangles of a surface that is
/// evenly meshed. The mesh itself where it has no more, or nothing would be left. O(n).
///
/// Source  J. Rossignac, P. Borrel 1993, Multi-resolution 3D approximations for rendering complex
///         scenes (vertex clustering).
class ThinnedMesh
{
public:
    ThinnedMesh() = default; // of nothing
    ThinnedMesh(const TriangleMeshPointer &mesh, std::size_t most);

    const TriangleMeshPointer &mesh() const { return m_mesh; }
    bool isWhole() const { return m_vertexOf.empty(); } // nothing was left out
    /// Of a mesh with the same triangles whose vertices lie elsewhere, in the groups that they are
    /// in here.
    TriangleMeshPointer moved(const TriangleMeshPointer &mesh) const;

private:
    TriangleMeshPointer m_mesh;
    std::vector<std::uint32_t> m_vertexOf; // of each vertex of the whole: its group
};

inline TriangleMeshPointer thinned(const TriangleMeshPointer &mesh, std::size_t most)
{
    return ThinnedMesh(mesh, most).mesh();
}

} // namespace fff
