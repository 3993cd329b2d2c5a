// A mesh of triangles to draw over. Immutable, shared by all versions of a document.
#pragma once

#include "core/geometry/vector.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// Corners by their index, counter-clockwise seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// What a mesh may have at most where nobody says otherwise: of so many a computer with 4 GB can
/// have the file, the mesh, its tree and what is drawn of it at once.
inline constexpr std::size_t kMostTriangles = 10'000'000;
/// A coordinate beyond this is as good as none: products of three of them stay exact enough.
inline constexpr double kMostMeshCoordinate = 1e12;

class TriangleMesh
{
public:
    /// positions  n × 3, mm where `unit` is known, else in whatever the file's unit is; finite
    /// triangles  m × 3, m ≥ 1, indices below n, three different ones each
    /// unit       mm of the unit that the file's numbers were in, where it says that
    TriangleMesh(std::vector<Vec3> positions, std::vector<Triangle> triangles,
                 std::optional<double> unit = {});

    const std::vector<Vec3> &positions() const { return m_positions; }
    const std::vector<Triangle> &triangles() const { return m_triangles; }
    std::optional<double> unit() const { return m_unit; }

    const Box3 &bounds() const { return m_bounds; }
    /// Largest extent along an axis.
    double size() const { return m_bounds.size().maxCoeff(); }
    /// Of the surface.
    double area() const { return m_area; }
    const Vec3 &centroid() const { return m_centroid; }
    /// Enclosed, where the mesh is closed; below 0 where its faces look inwards.
    double volume() const { return m_volume; }

private:
    std::vector<Vec3> m_positions;
    std::vector<Triangle> m_triangles;
    std::optional<double> m_unit;
    Box3 m_bounds;
    Vec3 m_centroid = Vec3::Zero();
    double m_area = 0.0, m_volume = 0.0;
};

using TriangleMeshPointer = std::shared_ptr<const TriangleMesh>;

} // namespace fff
