#include "core/physics/wall_pressure.h"

#include <algorithm>

namespace fff {

WallPressure::WallPressure(const AppliedForce &link) : m_depth(link.slit.depth)
{
    const double across = perpendicular(link.slit.opening).dot(link.force.head<2>());
    const double turning = link.moment.z() / m_depth;
    m_atRoot = (4.0 * across - 6.0 * turning) / m_depth;
    m_slope = (12.0 * turning - 6.0 * across) / (m_depth * m_depth);
}

WallForce WallPressure::on(bool isLeft, double from, double to, SlitFit fit) const
{
    double begin = from * m_depth, end = to * m_depth;
    if (begin >= end)
        return {};
    if (fit == SlitFit::Tight) {
        const WallForce both = all(begin, end);
        return {0.5 * both.force, 0.5 * both.moment};
    }
    const auto presses = [&](double s) { return (m_atRoot + m_slope * s > 0.0) == isLeft; };
    const bool isFirst = presses(begin), isLast = presses(end);
    if (!isFirst && !isLast)
        return {};
    if (isFirst != isLast)
        (isFirst ? end : begin) = std::clamp(-m_atRoot / m_slope, begin, end);
    return all(begin, end);
}

WallForce WallPressure::all(double begin, double end) const
{
    const double length = end - begin, middle = 0.5 * (begin + end);
    const double force = (m_atRoot + m_slope * middle) * length;
    return {force, force * middle + m_slope * length * length * length / 12.0};
}

} // namespace fff
