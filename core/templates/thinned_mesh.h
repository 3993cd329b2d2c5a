// A mesh with fewer triangles that looks like it from afar: what is drawn while the view moves.
#pragma once

#include "core/templates/triangle_mesh.h"

namespace fff {

/// Vertices of a cell of a grid are one, at their mean; triangles of which less than three cells
/// are left are none. The grid is as fine as leaves about `most` triangles of a surface that is
/// evenly meshed. The mesh itself where it has no more, or nothing would be left. O(n).
///
/// Source  J. Rossignac, P. Borrel 1993, Multi-resolution 3D approximations for rendering complex
///         scenes (vertex clustering).
TriangleMeshPointer thinned(const TriangleMeshPointer &mesh, std::size_t most);

} // namespace fff
