#include "core/physics/parallel_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// A vertex may be on a line if it is nearer, mm: then that line is asked for by itself.
constexpr double kMayBeOn = 2.0 * kOnCut;

} // namespace

void ParallelLines::placeLines(const Vec2 &direction, double shift, double spacing)
{
    m_step = perpendicular(direction);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec2 &p : m_outline.rings().front()) {
        low = std::min(low, m_step.dot(p));
        high = std::max(high, m_step.dot(p));
    }
    m_first = low + shift;
    m_lines.clear();
    for (std::size_t i = 0;; ++i) {
        const double at = m_first + static_cast<double>(i) * spacing;
        if (!(at < high))
            break;
        m_lines.push_back({at * m_step, direction});
    }
    m_isUnsure.assign(m_lines.size(), 0);
}

/// The last line that does not lie beyond a position, which is in spacings from the first one; and
/// marks one that this may be on. All before the first line are −1.
int ParallelLines::rowOf(double position, double slack)
{
    const int count = static_cast<int>(m_lines.size());
    const double within = std::clamp(position, -1.0, static_cast<double>(count));
    const int row = static_cast<int>(within + 1.0) - 1; // the sum rounds: then it is unsure
    const double beyond = within - row;
    if (beyond <= slack && row >= 0 && row < count)
        m_isUnsure[static_cast<std::size_t>(row)] = 1;
    if (beyond >= 1.0 - slack && row + 1 < count)
        m_isUnsure[static_cast<std::size_t>(row + 1)] = 1;
    return row;
}

void ParallelLines::crossRing(int ring, double spacing)
{
    const Polygon &points = m_outline.rings()[static_cast<std::size_t>(ring)];
    const double slack = kMayBeOn / spacing;
    m_rows.clear();
    for (const Vec2 &p : points)
        m_rows.push_back(rowOf((m_step.dot(p) - m_first) / spacing, slack));
    const int last = static_cast<int>(m_lines.size()) - 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int here = m_rows[i], there = m_rows[i + 1 == points.size() ? 0 : i + 1];
        if (here == there)
            continue;
        for (int k = std::min(here, there) + 1; k <= std::min(std::max(here, there), last); ++k)
            m_events.push_back(
                {static_cast<std::size_t>(k), ring, static_cast<int>(i), there > here});
    }
}

void ParallelLines::find(const Vec2 &direction, double shift, double spacing)
{
    placeLines(direction, shift, spacing);
    m_events.clear();
    for (std::size_t ring = 0; ring < m_outline.rings().size(); ++ring)
        crossRing(static_cast<int>(ring), spacing);
    m_begins.assign(m_lines.size() + 1, 0);
    for (const Event &event : m_events)
        ++m_begins[event.line + 1];
    for (std::size_t i = 1; i < m_begins.size(); ++i)
        m_begins[i] += m_begins[i - 1];
    m_sorted.resize(m_events.size());
    std::vector<std::size_t> next(m_begins.begin(), m_begins.end() - 1);
    for (const Event &event : m_events)
        m_sorted[next[event.line]++] = event;
}

std::span<const OutlineCrossing> ParallelLines::crossings(std::size_t i)
{
    if (m_isUnsure[i]) {
        m_outline.crossings(m_lines[i], {}, m_exact);
        return m_exact.touchedLeft;
    }
    m_row.clear();
    for (std::size_t k = m_begins[i]; k < m_begins[i + 1]; ++k) {
        const Event &event = m_sorted[k];
        m_row.push_back(crossingOf(m_outline.rings()[static_cast<std::size_t>(event.ring)],
                                   event.ring, event.edge, m_lines[i], event.isToLeft));
    }
    std::sort(m_row.begin(), m_row.end(),
              [](const OutlineCrossing &a, const OutlineCrossing &b) { return a.along < b.along; });
    return m_row;
}

} // namespace fff
