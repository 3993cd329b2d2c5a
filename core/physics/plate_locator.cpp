#include "core/physics/plate_locator.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kOnSide = 1e-9; // of a triangle's shares: on its side is in it

Barycentric sharesOf(const PlateCorners &corners, const Vec2 &point)
{
    const double twice = cross(corners[1] - corners[0], corners[2] - corners[0]);
    return {cross(corners[2] - corners[1], point - corners[1]) / twice,
            cross(corners[0] - corners[2], point - corners[2]) / twice,
            cross(corners[1] - corners[0], point - corners[0]) / twice};
}

Vec2 nearestOnSides(const PlateCorners &corners, const Vec2 &point)
{
    Vec2 best = corners[0];
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 from = corners[i], along = corners[(i + 1) % 3] - from;
        const double at = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const Vec2 candidate = from + at * along;
        if ((candidate - point).squaredNorm() < (best - point).squaredNorm())
            best = candidate;
    }
    return best;
}

} // namespace

PlateCorners cornersOf(const PlateMesh &mesh, std::size_t triangle)
{
    PlateCorners corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = mesh.points[static_cast<std::size_t>(mesh.triangles[triangle][i])];
    return corners;
}

PlateLocator::PlateLocator(const PlateMesh &mesh)
{
    for (const Vec2 &p : mesh.points)
        m_box.extend(p);
    const Vec2 size = m_box.size();
    const double count = std::max<double>(1.0, static_cast<double>(mesh.triangles.size()));
    m_edge = std::max(std::sqrt(size.x() * size.y() / count), size.maxCoeff() / count);
    m_count = {static_cast<int>(size.x() / m_edge) + 1, static_cast<int>(size.y() / m_edge) + 1};
    m_cells.resize(static_cast<std::size_t>(m_count[0]) * static_cast<std::size_t>(m_count[1]));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Box2 box;
        for (const Vec2 &p : cornersOf(mesh, i))
            box.extend(p);
        for (int y = cell(box.min.y(), 1); y <= cell(box.max.y(), 1); ++y) {
            for (int x = cell(box.min.x(), 0); x <= cell(box.max.x(), 0); ++x)
                m_cells[static_cast<std::size_t>(y * m_count[0] + x)].push_back(
                    static_cast<int>(i));
        }
    }
}

int PlateLocator::cell(double along, int axis) const
{
    const double cells = (along - m_box.min[axis]) / m_edge;
    const int last = m_count[static_cast<std::size_t>(axis)] - 1;
    return static_cast<int>(std::clamp(cells, 0.0, static_cast<double>(last)));
}

PlateLocator::Place PlateLocator::place(const PlateMesh &mesh, const Vec2 &point) const
{
    Place best;
    const auto &nearby =
        m_cells[static_cast<std::size_t>(cell(point.y(), 1) * m_count[0] + cell(point.x(), 0))];
    for (const int i : nearby) {
        const auto triangle = static_cast<std::size_t>(i);
        const Barycentric at = sharesOf(cornersOf(mesh, triangle), point);
        if (at.minCoeff() >= -kOnSide)
            return {triangle, at, point, 0.0};
    }
    best.distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec2 candidate = nearestOnSides(cornersOf(mesh, i), point);
        if (const double distance = (candidate - point).norm(); distance < best.distance)
            best = {i, Barycentric::Zero(), candidate, distance};
    }
    best.at = sharesOf(cornersOf(mesh, best.triangle), best.point);
    return best;
}

} // namespace fff
