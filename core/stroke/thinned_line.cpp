#include "core/stroke/thinned_line.h"

#include "core/base/tolerances.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>

namespace fff {

namespace {

/// Samples that the last edge stands for at most: each is looked at when its end is to move.
constexpr std::size_t kMostLeftOut = 24;
/// Edges back from the end that a sample may lie beside, and how many errors around it they have to
/// stay: what lies further is another stretch of the line.
constexpr std::size_t kEdgesBack = 96;
constexpr double kSurroundings = 14.0;

} // namespace

/// Beside what was drawn last, as long as that has not been left.
bool ThinnedLine::isBesideLine(const Vec2 &p) const
{
    const std::size_t last = m_points.size() - 1;
    for (std::size_t back = 0; back < std::min(kEdgesBack, last); ++back) {
        const Vec2 &a = m_points[last - back - 1], &b = m_points[last - back];
        if ((b - p).norm() > kSurroundings * m_error)
            return false;
        if (distanceToSegment(p, a, b) <= m_error)
            return true;
    }
    return false;
}

bool ThinnedLine::canMoveEnd(const Vec2 &to) const
{
    if (m_points.size() < 2 || m_leftOut.empty() || m_leftOut.size() >= kMostLeftOut)
        return false;
    const Vec2 &from = m_points[m_points.size() - 2];
    if ((to - from).norm() > kLongestStep * m_error)
        return false;
    return std::all_of(m_leftOut.begin(), m_leftOut.end(),
                       [&](const Vec2 &p) { return distanceToSegment(p, from, to) <= m_error; });
}

/// The line stays as it is.
bool ThinnedLine::keep(const Vec2 &p)
{
    if (m_leftOut.size() >= kMostLeftOut)
        m_leftOut.clear();
    else if (!m_leftOut.empty() && m_leftOut.back() != p)
        m_leftOut.push_back(p);
    return false;
}

bool ThinnedLine::add(const Vec2 &p)
{
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kMaxCoordinate)
        return false;
    if (!m_points.empty() && (p - m_points.back()).norm() <= std::max(m_error, kClipGrid))
        return keep(p);
    if (!m_points.empty() && canMoveEnd(p)) {
        m_points.back() = p;
    } else if (!m_points.empty() && isBesideLine(p)) {
        m_leftOut.clear(); // what the end stands for may not be left by moving it
        return false;
    } else {
        m_points.push_back(p);
        m_leftOut.clear();
    }
    m_leftOut.push_back(p);
    ++m_revision;
    return true;
}

void ThinnedLine::clear()
{
    m_points.clear();
    m_leftOut.clear();
    ++m_revision;
}

} // namespace fff
