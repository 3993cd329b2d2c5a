// From what a file has to a mesh that makes sense, and a report of what was done for that.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/templates/mesh_report.h"
#include "core/templates/triangle_mesh.h"

namespace fff {

/// A corner that there is no vertex for.
inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;

/// As a file has it: anything may be wrong.
struct MeshDraft
{
    std::vector<Vec3> positions;     // as in TriangleMesh
    std::vector<Triangle> triangles; // indices may be any, such as kNoVertex
    std::optional<double> unit;      // as in TriangleMesh
    bool isMerged = false;           // no two positions are equal: VertexMerger made them
};

struct MendedMesh
{
    TriangleMeshPointer mesh;
    MeshReport report;
};

/// Leaves out faces that are none, makes one vertex of equal ones, turns faces over that look the
/// wrong way, and leaves out vertices that no face has.
///
/// What closes a mesh is kept, also what only looks broken: faces without area between three
/// different corners close the gap where an edge has a corner of its neighbour's on it, and of two
/// equal faces that look at each other, each belongs to another solid. Holes are left open.
///
/// Errors  BadValue without a place when no face is left, with the number where one was too large;
///         Cancelled.
/// Cost    O(n), but for thousands of faces at one vertex.
Result<MendedMesh> mended(MeshDraft draft, const LongWork &work = {});

} // namespace fff
