// A drawn line by the way along it, as who looks at its ends sees it. Internal to stroke.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace fff {

/// Samples with how far along the line each is.
class LineWay
{
public:
    explicit LineWay(const std::vector<Vec2> &points)
        : m_points(points), m_along(points.size(), 0.0)
    {
        for (std::size_t i = 1; i < points.size(); ++i)
            m_along[i] = m_along[i - 1] + (points[i] - points[i - 1]).norm();
    }

    double length() const { return m_along.back(); }
    double along(std::size_t i) const { return m_along[i]; }
    const Vec2 &point(std::size_t i) const { return m_points[i]; }
    std::size_t size() const { return m_points.size(); }
    /// The edge that it lies on.
    std::size_t edgeAt(double s) const
    {
        const auto after = std::upper_bound(m_along.begin(), m_along.end(), s);
        const auto i = static_cast<std::size_t>(after - m_along.begin());
        return std::min(i > 0 ? i - 1 : 0, size() - 2);
    }
    Vec2 at(double s) const
    {
        const std::size_t i = edgeAt(s);
        const double edge = m_along[i + 1] - m_along[i];
        const double share = edge > 0.0 ? std::clamp((s - m_along[i]) / edge, 0.0, 1.0) : 0.0;
        return m_points[i] + share * (m_points[i + 1] - m_points[i]);
    }

private:
    const std::vector<Vec2> &m_points;
    std::vector<double> m_along; // mm
};

/// What of the way is kept, by lengths along it.
struct KeptStretch
{
    double from = 0.0, to = 0.0;
    double length() const { return to - from; }
};

/// Where the line points at one of its ends, outwards at the last and inwards at the first; and by
/// how much it bends over a mm, to the left.
struct EndPointing
{
    Vec2 way = Vec2::UnitX();
    double bend = 0.0;
};

/// Where it points at its last end (isEnd) or at its first one: as the circle does through the end
/// and two places beside it, kPointingWay `scale` away or nearer. A corner of more than `corner`
/// radians that close to the end says nothing about it.
EndPointing pointingAt(const LineWay &way, const KeptStretch &kept, bool isEnd, double scale,
                       double corner);
/// Scales by which that is judged.
inline constexpr double kPointingWay = 12.0;

/// The place within a stretch that is nearest to a point, and how far that is. O(edges).
double nearestAlong(const LineWay &way, double from, double to, const Vec2 &p, double &distance);

/// Where the last part of the way crosses the first one, so that least is cut off, and no more than
/// the budget, mm. O(edges), and what comes near to each other.
std::optional<KeptStretch> crossingOfEnds(const LineWay &way, const KeptStretch &kept,
                                          double budget);

} // namespace fff
