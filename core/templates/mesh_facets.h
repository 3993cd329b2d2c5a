// The flat pieces that a mesh of few faces is made of: each a sheet, when it is built.
#pragma once

#include "core/templates/triangle_mesh.h"

namespace fff {

/// Faces whose normals differ by less than this from the first one's are one flat piece (1°),
inline constexpr double kCoplanarAngle = 0.017453292519943295;
/// while they stay this near to its plane, mm.
inline constexpr double kCoplanarDepth = 0.2;
/// A face that is nowhere higher than this above its longest side, mm, says nothing of a plane: it
/// goes to a piece beside it.
inline constexpr double kSliverHeight = 0.05;

/// A stretch of a piece's boundary, from one vertex of the mesh to another.
struct FacetEdge
{
    std::uint32_t from = 0, to = 0;
    int beyond = -1; // the piece on the other side; −1: none, the mesh is open there
};

struct MeshFacet
{
    Vec3 normal = Vec3::UnitY(); // unit, outwards: the mean of its faces by their areas
    Vec3 middle = Vec3::Zero();  // of their areas, in its plane
    double area = 0.0;           // of its faces, mm²
    /// Counter-clockwise seen from outside, those of holes clockwise; the one with the largest box
    /// first. Each at least three edges.
    std::vector<std::vector<FacetEdge>> loops;
};

/// The pieces of a mesh whose coordinates are mm, in the order of the largest face of each: faces
/// that hang together by edges of two and are flat together. Every face is in one, but for slivers
/// that have none beside them. Edges of one face alone, or of more than two, are where pieces end.
/// The same input gives the same output. O(n log n).
std::vector<MeshFacet> meshFacets(const TriangleMesh &mesh);

} // namespace fff
