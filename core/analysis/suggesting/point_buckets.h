// Points in buckets, so that those near to a place are found at once.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fff {

/// Cubes of one size over the box of all points. Immutable.
class PointBuckets
{
public:
    PointBuckets() = default;
    /// cell  mm, above 0: how far visitNear() looks
    PointBuckets(std::vector<Vec3> points, double cell);

    const std::vector<Vec3> &points() const { return m_points; }

    /// Calls visit(index) for each point within a cell's size of p, and for some beyond.
    template <class Visit>
    void visitNear(const Vec3 &p, Visit visit) const
    {
        std::array<int, 3> from{}, to{};
        for (int axis = 0; axis < 3; ++axis) {
            const double at = (p[axis] - m_low[axis]) / m_cell;
            const auto i = static_cast<std::size_t>(axis);
            if (!(at > -1.0) || !(at < m_count[i] + 1.0))
                return;
            const int middle = static_cast<int>(at + 1.0) - 1;
            from[i] = std::max(0, middle - 1);
            to[i] = std::min(m_count[i] - 1, middle + 1);
        }
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y) {
                const std::size_t first = m_starts[bucket(from[0], y, z)];
                const std::size_t last = m_starts[bucket(to[0], y, z) + 1];
                for (std::size_t i = first; i < last; ++i)
                    visit(m_order[i]);
            }
    }

private:
    std::size_t bucket(int x, int y, int z) const
    {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(m_count[1]) +
                static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(m_count[0]) +
               static_cast<std::size_t>(x);
    }

    std::vector<Vec3> m_points;
    Vec3 m_low = Vec3::Zero();
    double m_cell = 1.0;
    std::array<int, 3> m_count{1, 1, 1};
    std::vector<std::uint32_t> m_order;        // of the points, by their buckets
    std::vector<std::uint32_t> m_starts{0, 0}; // of each bucket in that, and its end
};

} // namespace fff
