// A mesh of few faces that keeps the form: what is built of flat sheets.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/templates/triangle_mesh.h"

namespace fff {

/// The mesh with at most `faces` triangles: edges are collapsed, those first that change the volume
/// and the boundary least. The mesh itself where it has no more. Where collapsing more would tear
/// it or fold it over, more triangles stay. The same input gives the same output. O(n log n).
///
/// faces   4 or more
/// Errors  BadValue, args = what is there and what was expected, for a mesh that is no surface:
///         of which three faces or more share an edge. Cancelled.
/// Source  P. Lindstrom, G. Turk 1998, Fast and memory efficient polygonal simplification, as CGAL
///         (Surface_mesh_simplification) has it.
Result<TriangleMeshPointer> simplified(const TriangleMeshPointer &mesh, std::size_t faces,
                                       const LongWork &work = {});

} // namespace fff
