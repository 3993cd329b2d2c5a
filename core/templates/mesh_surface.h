// A mesh as it is drawn: smooth where it is meant to be round, with edges where it is not.
#pragma once

#include "core/base/long_work.h"
#include "core/templates/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace fff {

/// Faces that meet at less than this look like one round surface (40°, radians).
inline constexpr double kCreaseAngle = 0.6981317007977318;

struct MeshSurface
{
    struct Corner
    {
        std::array<float, 3> position{}; // about the middle of the mesh's bounds
        std::array<float, 3> normal{};   // unit, outwards; zero where faces have no area
    };
    std::vector<Corner> corners;
    std::vector<std::uint32_t> indices; // three a triangle
};

/// A vertex is one corner for all of its faces that look alike, several along a crease. O(n) for
/// vertices with few faces each. Empty when it was stopped.
MeshSurface surfaceOf(const TriangleMesh &mesh, const LongWork &work = {});

/// Of a mesh with the triangles of the one that `before` is of, whose vertices lie elsewhere: with
/// the same corners, each the mean of its own faces, so that creases stay where they were. A small
/// part of the cost of surfaceOf().
MeshSurface movedSurface(const MeshSurface &before, const TriangleMesh &mesh);

} // namespace fff
