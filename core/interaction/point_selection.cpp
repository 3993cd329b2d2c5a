#include "core/interaction/point_selection.h"

#include <algorithm>

namespace fff {

bool PointSelection::has(const PointAddress &point) const
{
    return std::binary_search(m_points.begin(), m_points.end(), point);
}

void PointSelection::select(const Section &section, std::vector<PointAddress> points)
{
    std::erase_if(points, [&](const PointAddress &p) { return !isPoint(*section.shape, p); });
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    m_section = section.id;
    m_shape = section.shape;
    m_points = std::move(points);
}

void PointSelection::toggle(const Section &section, const PointAddress &point)
{
    std::vector<PointAddress> points;
    if (section.id == m_section)
        points = m_points;
    if (std::erase(points, point) == 0)
        points.push_back(point);
    select(section, std::move(points));
}

void PointSelection::clear()
{
    m_section = {};
    m_shape.reset();
    m_points.clear();
}

void PointSelection::follow(const Document &document)
{
    if (m_points.empty())
        return;
    const Section *section = document.find(m_section);
    if (!section) {
        clear();
        return;
    }
    if (section->shape == m_shape)
        return;
    const Shape &before = *m_shape, &now = *section->shape;
    bool hasAsMany = boundaryCount(before) == boundaryCount(now);
    for (int b = 0; hasAsMany && b < boundaryCount(now); ++b)
        hasAsMany = boundary(before, b).segmentCount() == boundary(now, b).segmentCount();
    if (hasAsMany) {
        m_shape = section->shape;
        return;
    }
    std::vector<Vec2> places;
    for (const PointAddress &point : m_points)
        places.push_back(position(before, point));
    select(*section, pointsAt(now, places));
}

} // namespace fff
