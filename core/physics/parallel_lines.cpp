#include "core/physics/parallel_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// A vertex is on a line if it is nearer than this share of the largest coordinate: more than
/// rounding can be, less than any feature. Exact predicates decide there.
constexpr double kRounding = 1e-12;

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

void ParallelLines::markUnsure(double position, double slack)
{
    const double nearest = std::round(position);
    if (std::abs(position - nearest) <= slack && nearest >= 0.0 &&
        nearest < static_cast<double>(m_lines.size()))
        m_isUnsure[static_cast<std::size_t>(nearest)] = 1;
}

void ParallelLines::crossRing(int ring, double spacing)
{
    const Polygon &points = m_outline.rings()[static_cast<std::size_t>(ring)];
    const double largest = std::max(m_outline.bounds().min.cwiseAbs().maxCoeff(),
                                    m_outline.bounds().max.cwiseAbs().maxCoeff());
    const double slack = kRounding * (largest + spacing) / spacing;
    m_positions.clear();
    for (const Vec2 &p : points) {
        m_positions.push_back((m_step.dot(p) - m_first) / spacing);
        markUnsure(m_positions.back(), slack);
    }
    const double last = static_cast<double>(m_lines.size()) - 1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double here = m_positions[i];
        const double there = m_positions[i + 1 == points.size() ? 0 : i + 1];
        const double from = std::max(0.0, std::floor(std::min(here, there)) + 1.0);
        const double to = std::min(last, std::floor(std::max(here, there)));
        for (double k = from; k <= to; k += 1.0)
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
