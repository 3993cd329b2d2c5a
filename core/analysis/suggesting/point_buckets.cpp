#include "core/analysis/suggesting/point_buckets.h"

#include <cmath>
#include <numeric>

namespace fff {

PointBuckets::PointBuckets(std::vector<Vec3> points, double cell)
    : m_points(std::move(points)), m_cell(cell)
{
    Box3 box;
    for (const Vec3 &p : m_points)
        box.extend(p);
    if (box.isEmpty())
        return;
    m_low = box.min;
    for (int axis = 0; axis < 3; ++axis)
        m_count[static_cast<std::size_t>(axis)] =
            static_cast<int>(std::floor(box.size()[axis] / m_cell)) + 1;
    const auto bucketOf = [this](const Vec3 &p) {
        std::array<int, 3> at{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            at[i] =
                std::clamp(static_cast<int>((p[axis] - m_low[axis]) / m_cell), 0, m_count[i] - 1);
        }
        return bucket(at[0], at[1], at[2]);
    };
    m_starts.assign(bucket(m_count[0] - 1, m_count[1] - 1, m_count[2] - 1) + 2, 0);
    for (const Vec3 &p : m_points)
        ++m_starts[bucketOf(p) + 1];
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    std::vector<std::uint32_t> next(m_starts.begin(), m_starts.end() - 1);
    m_order.resize(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i)
        m_order[next[bucketOf(m_points[i])]++] = static_cast<std::uint32_t>(i);
}

} // namespace fff
