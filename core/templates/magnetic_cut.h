// A template bent towards the sections that are drawn on it, so that its outline seen along a
// section's normal lies on that section.
#pragma once

#include "core/templates/cut_plane.h"
#include "core/templates/triangle_mesh.h"

#include <span>

namespace fff {

/// Of a section: what lies within `reach` mm of its plane is drawn to it.
struct MagneticPlane
{
    CutPlane plane; // with a normal of length 1
    double reach = 25.4;
};

/// How strongly a plane draws what is `distance` reaches away: 1 up to kFirmReach, 0 from 1 on, and
/// smooth in between.
double magneticWeight(double distance);
inline constexpr double kFirmReach = 0.8;

/// The mesh with its vertices moved, by each plane from where they were in the undeformed mesh:
///
///     P' = P + w(d / r) · N [N · (Q − P) + (N_P · N) r],     d = |N · (P − Q)|
///
/// with N_P the undeformed normal at P, so that what looks across the plane, the outline seen along
/// N, comes to lie in it, and what looks along N keeps its distance. Of several planes it is the
/// mean of the ways by their weights. Triangles and vertices stay the same in number and order.
///
/// normals  vertexNormals() of the mesh
/// Source   J. McCrae et al. 2014, FlatFitFab, "Non-ideal templates", which has no w: all points
///          within r move by the same rule and those just beyond it not at all, which tears the
///          mesh.
TriangleMeshPointer magneticCut(const TriangleMesh &mesh, std::span<const Vec3> normals,
                                std::span<const MagneticPlane> planes);

} // namespace fff
