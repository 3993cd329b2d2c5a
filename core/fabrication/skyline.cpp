#include "core/fabrication/skyline.h"

#include <algorithm>
#include <limits>

namespace fff {

Skyline::Skyline(const Vec2 &size) : m_size(size), m_segments{{0.0, size.x(), 0.0}}, m_next() {}

Skyline::Place Skyline::find(const Vec2 &box) const
{
    Place best{Vec2::Zero(), std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < m_segments.size(); ++i) {
        const double left = m_segments[i].from, right = left + box.x();
        if (right > m_size.x() + kClipGrid)
            break;
        double y = 0.0;
        for (std::size_t k = i; k < m_segments.size() && m_segments[k].from < right; ++k) {
            y = std::max(y, m_segments[k].y);
            if (y + box.y() >= best.top)
                break;
        }
        const double top = y + box.y();
        if (top < best.top && isWithin(top, m_size))
            best = {{left, y}, top};
    }
    return best;
}

void Skyline::put(const Vec2 &box, const Place &place)
{
    const double from = place.corner.x(), to = std::min(from + box.x(), m_size.x());
    std::vector<Segment> &next = m_next;
    next.clear();
    const auto append = [&next](const Segment &segment) {
        if (segment.to - segment.from <= kClipGrid)
            return; // too narrow for anything
        if (!next.empty() && next.back().y == segment.y)
            next.back().to = segment.to;
        else
            next.push_back(segment);
    };
    for (const Segment &segment : m_segments) {
        append({segment.from, std::min(segment.to, from), segment.y});
        if (segment.from <= from && from < segment.to)
            append({from, to, place.top});
        append({std::max(segment.from, to), segment.to, segment.y});
    }
    m_segments.swap(next);
    m_lowest = std::numeric_limits<double>::infinity();
    for (const Segment &segment : m_segments)
        m_lowest = std::min(m_lowest, segment.y);
}

} // namespace fff
