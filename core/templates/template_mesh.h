// What a template of a document is, once its bytes are read.
#pragma once

#include "core/geometry/similarity.h"
#include "core/model/template.h"
#include "core/templates/mesh_report.h"
#include "core/templates/mesh_surface.h"
#include "core/templates/mesh_tree.h"
#include "core/templates/placed_mesh.h"
#include "core/templates/thinned_mesh.h"

namespace fff {

inline constexpr std::size_t kCoarseTriangles = 30'000;

/// A mesh that is ready to be cut. Immutable.
struct TemplateMesh
{
    TriangleMeshPointer mesh; // in the file's coordinates; never null
    MeshTree tree;            // of it
    MeshReport report;
    MeshSurface surface; // as it is drawn,
    MeshSurface coarse;  // and in motion, of kCoarseTriangles about; empty: as the other
    /// What that is of.
    std::shared_ptr<const ThinnedMesh> thinning;

    Vec3 middle() const { return 0.5 * (mesh->bounds().min + mesh->bounds().max); }
};

/// Errors  Cancelled.
Result<TemplateMeshPointer> makeTemplateMesh(TriangleMeshPointer mesh, MeshReport report,
                                             const LongWork &work = {});

/// Of a mesh with the triangles of `original` whose vertices lie elsewhere: tree, creases and
/// groups of vertices are those of the original. Errors  Cancelled.
Result<TemplateMeshPointer> movedTemplateMesh(const TemplateMesh &original,
                                              TriangleMeshPointer mesh, const LongWork &work = {});

/// From the mesh's coordinates to the world.
Similarity worldPlacement(const Template &one, const TemplateMesh &mesh);
/// In the world, of all vertices. O(vertices).
Box3 worldBounds(const Template &one, const TemplateMesh &mesh);

enum class UpAxis { Y, Z };

/// As a mesh comes in: with the axis of its file that is meant upwards; as large as wanted in its
/// largest extent, 0: as its file says, or kTemplateSize where that does not say or where it is
/// more than kMaxCoordinate; above the world's origin, on the ground.
Template stood(Template one, const TemplateMesh &mesh, UpAxis up, double size);
/// Moved straight down, or up, until it stands on the ground.
Template onGround(Template one, const TemplateMesh &mesh);

} // namespace fff
