#include "core/skin/skin_outline.h"

#include "core/base/tolerances.h"
#include "core/skin/skin_measures.h"

#include <algorithm>
#include <cmath>

namespace fff {

SkinOutline::SkinOutline(const Shape &shape, const Frame &frame)
    : m_frame(frame), m_points(shape.contour().polygon(kDrawChord)), m_along{0.0}
{
    for (std::size_t i = 0; i < m_points.size(); ++i)
        m_along.push_back(m_along.back() +
                          (m_points[(i + 1) % m_points.size()] - m_points[i]).norm());
}

/// along: 0 … length
std::size_t SkinOutline::edgeAt(double along) const
{
    const auto after = std::upper_bound(m_along.begin() + 1, m_along.end() - 1, along);
    return static_cast<std::size_t>(after - m_along.begin()) - 1;
}

Vec2 SkinOutline::at(double along) const
{
    along -= length() * std::floor(along / length());
    const std::size_t edge = edgeAt(along);
    const Vec2 &from = m_points[edge], &to = m_points[(edge + 1) % m_points.size()];
    const double span = m_along[edge + 1] - m_along[edge];
    return span > 0.0 ? Vec2(from + (along - m_along[edge]) / span * (to - from)) : from;
}

Vec2 SkinOutline::tangentAt(double along, double reach) const
{
    const Vec2 chord = at(along + reach) - at(along - reach);
    if (chord.norm() > kSkinSame)
        return chord.normalized();
    // The tip of a needle, round which the way there is the way back.
    return (at(along + reach) - at(along)).normalized();
}

std::vector<PlaneCrossing> SkinOutline::crossings(const Frame &other, const Axis &axis) const
{
    std::vector<PlaneCrossing> found;
    const Vec3 normal = other.normal();
    const Vec2 direction = m_frame.directionToLocal(axis.direction);
    const auto heightOf = [&](const Vec2 &p) {
        return normal.dot(m_frame.toWorld(p) - other.origin);
    };
    double height = heightOf(m_points.front());
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const Vec2 &from = m_points[i], &to = m_points[(i + 1) % m_points.size()];
        const double next = heightOf(to);
        if ((height < 0.0) != (next < 0.0)) {
            const double share = height / (height - next);
            const Vec2 point = from + share * (to - from);
            double along = m_along[i] + share * (m_along[i + 1] - m_along[i]);
            if (along > length() - kSkinSame) // else rounding says which turn it is of
                along -= length();
            found.push_back({along, axis.direction.dot(m_frame.toWorld(point) - axis.point),
                             cross(direction, to - from) > 0.0});
        }
        height = next;
    }
    return found;
}

std::vector<double> SkinOutline::cornersBetween(double from, double to) const
{
    std::vector<double> found;
    const double first = length() * std::floor(from / length());
    for (double turn = first; turn < to; turn += length())
        for (std::size_t i = 0; i + 1 < m_along.size(); ++i)
            if (turn + m_along[i] > from && turn + m_along[i] < to)
                found.push_back(turn + m_along[i]);
    return found;
}

} // namespace fff
