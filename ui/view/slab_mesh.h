// The solid of a section as plain arrays, ready to be uploaded. Knows no OpenGL.
//
// Coordinates: x and y are the section's frame coordinates in mm, z is -1 at the bottom face and +1
// at the top face. The model matrix stretches z to half the thickness, so that a new thickness
// needs no new mesh.
#pragma once

#include "core/geometry/polygon.h"
#include "core/geometry/triangulation.h"
#include "ui/view/slit_covers.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fff::ui {

/// A unit vector in 127ths; the fourth number is a flag (see where it is used).
using PackedNormal = std::array<std::int8_t, 4>;

struct SlabVertex
{
    std::array<float, 3> position;
    PackedNormal normal; // flag: 127 on a side wall (the cut edge), 0 on a face
};

/// A straight edge and the outward normals of the two surfaces that meet in it. The first normal's
/// flag is 127 when the edge is always drawn, 0 when only as a silhouette (the seams of a curved
/// wall).
struct SlabEdge
{
    std::array<float, 3> from, to;
    PackedNormal normalA, normalB;
};

struct SlabMesh
{
    std::vector<SlabVertex> vertices;
    std::vector<std::uint32_t> triangles; // three indices each, counter-clockwise seen from outside
    std::vector<SlabEdge> edges;
    /// Where the triangles of each cover begin, and the end of the last: those before the first are
    /// always seen, those of a cover only where its guest is not.
    std::vector<std::size_t> coverStarts;
};

/// The solid over these regions; `triangulations[i]` is that of `regions[i]`.
///
/// Walls of smooth curves share their normals over the seams; a vertex where the boundary turns by
/// more than kCornerAngle has a normal and an edge of its own. Repeated points and triangles
/// without area are left out. Empty for no regions. Walls that `covers` hide come last.
SlabMesh buildSlab(std::span<const Region> regions, std::span<const Triangulation> triangulations,
                   std::span<const SlitCover> covers = {});

/// Turn of a boundary, in radians, from which on it looks like a corner (25°): well above the turn
/// between two chords of a drawn curve, below that of a hand-drawn corner.
inline constexpr double kCornerAngle = 0.436;

} // namespace fff::ui
