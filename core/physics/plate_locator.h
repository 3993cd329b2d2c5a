// Which triangle of a plate's mesh a point lies in.
#pragma once

#include "core/physics/plate_element.h"
#include "core/physics/plate_mesh.h"

namespace fff {

PlateCorners cornersOf(const PlateMesh &mesh, std::size_t triangle);

class PlateLocator
{
public:
    explicit PlateLocator(const PlateMesh &mesh);

    struct Place
    {
        std::size_t triangle = 0;
        Barycentric at = Barycentric::Zero();
        Vec2 point = Vec2::Zero(); // in the triangle, mm
        double distance = 0.0;     // from the point asked for, mm
    };

    /// Where the point is, or the nearest point of the mesh where it is outside.
    Place place(const PlateMesh &mesh, const Vec2 &point) const;

private:
    int cell(double along, int axis) const;

    Box2 m_box;
    double m_edge = 1.0; // of a cell, mm
    std::array<int, 2> m_count{1, 1};
    std::vector<std::vector<int>> m_cells;
};

} // namespace fff
