#include "core/model/shape_change.h"

#include <algorithm>

namespace fff {

ShapeChange::ShapeChange(const Shape &now, const Shape &before)
{
    const Region &a = now.region(), &b = before.region();
    compare(a.outer, b.outer);
    for (std::size_t i = 0; i < std::min(a.holes.size(), b.holes.size()); ++i)
        compare(a.holes[i], b.holes[i]);
    if (a.holes.size() != b.holes.size())
        for (const Region *region : {&a, &b})
            for (const Vec2 &p : region->outer)
                m_box.extend(p);
}

void ShapeChange::compare(const Polygon &now, const Polygon &before)
{
    const std::size_t n = now.size(), m = before.size(), most = std::min(n, m);
    const auto head = static_cast<std::size_t>(
        std::mismatch(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(most), before.begin())
            .first -
        now.begin());
    std::size_t tail = 0; // equal vertices at the end
    while (tail < most - head && now[n - 1 - tail] == before[m - 1 - tail])
        ++tail;
    m_rings.push_back({static_cast<int>(m - tail), static_cast<int>(n) - static_cast<int>(m)});
    if (head == n && head == m)
        return;
    // With the vertices beside, which the edges come from and go to.
    for (const Polygon *ring : {&now, &before}) {
        const std::size_t count = ring->size(), end = count - tail;
        for (std::size_t i = head; i < end; ++i)
            m_box.extend((*ring)[i]);
        m_box.extend((*ring)[(head + count - 1) % count]);
        m_box.extend((*ring)[end % count]);
    }
}

bool ShapeChange::isBeside(const Vec2 &point, const Vec2 &direction, double half) const
{
    if (m_box.isEmpty())
        return true;
    const Vec2 centre = m_box.center(), reach = 0.5 * m_box.size();
    const Vec2 normal = perpendicular(direction);
    return std::abs(normal.dot(centre - point)) > half + normal.cwiseAbs().dot(reach);
}

int ShapeChange::edgeNow(int ring, int edgeBefore) const
{
    const OfRing &of = m_rings[static_cast<std::size_t>(ring)];
    return edgeBefore < of.tail ? edgeBefore : edgeBefore + of.shift;
}

} // namespace fff
