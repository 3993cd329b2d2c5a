#include "core/stroke/leaving.h"

#include "core/base/tolerances.h"

namespace fff {

namespace {

/// Halvings of a parameter interval: after these it is down to the last bit.
constexpr int kBisections = 60;

struct Meeting
{
    double along = 0.0; // parameter on the way
    Vec2 point;
};

/// Where the curve's piece from t0 to t1, whose ends lie on both sides of the way, meets its line.
Vec2 meetingPoint(const CubicBezier &curve, double t0, double t1, const Vec2 &from, const Vec2 &way)
{
    const bool startsLeft = cross(way, curve.at(t0) - from) > 0.0;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (t0 + t1);
        const bool isLeft = cross(way, curve.at(middle) - from) > 0.0;
        (isLeft == startsLeft ? t0 : t1) = middle;
    }
    return curve.at(0.5 * (t0 + t1));
}

/// First meeting of the way with the boundary whose chords are `line`.
std::optional<Meeting> firstMeeting(const Contour &contour, const Polyline &line, const Vec2 &from,
                                    const Vec2 &to)
{
    const Vec2 way = to - from;
    std::optional<Meeting> first;
    for (std::size_t i = 0, n = line.points.size(); i < n; ++i) {
        const Vec2 a = line.points[i] - from, b = line.points[(i + 1) % n] - from;
        const double sideA = cross(way, a), sideB = cross(way, b);
        if ((sideA > 0.0) == (sideB > 0.0))
            continue;
        const Vec2 chordPoint = from + a + (b - a) * (sideA / (sideA - sideB));
        const double along = way.dot(chordPoint - from) / way.squaredNorm();
        // What starts on the boundary leaves it only where it meets it again.
        if (along * way.norm() <= kRayRounding || along > 1.0 || (first && along >= first->along))
            continue;
        const CurvePoint &start = line.origins[i], &end = line.origins[(i + 1) % n];
        const double t1 = end.segment == start.segment && end.t > start.t ? end.t : 1.0;
        first = {along, meetingPoint(contour.segment(start.segment), start.t, t1, from, way)};
    }
    return first;
}

} // namespace

Interior::Interior(ShapePointer shape) : m_shape(std::move(shape))
{
    m_boundaries.push_back(m_shape->contour().flatten(kCutChord));
    for (const Contour &hole : m_shape->holes())
        m_boundaries.push_back(hole.flatten(kCutChord));
}

bool Interior::contains(const Vec2 &point) const
{
    return locate(point, m_shape->region()) != Side::Outside;
}

std::optional<Vec2> Interior::leavingPoint(const Vec2 &from, const Vec2 &to) const
{
    if (from == to)
        return {};
    std::optional<Meeting> first;
    for (std::size_t i = 0; i < m_boundaries.size(); ++i) {
        const Contour &contour = i == 0 ? m_shape->contour() : m_shape->holes()[i - 1];
        const std::optional<Meeting> meeting = firstMeeting(contour, m_boundaries[i], from, to);
        if (meeting && (!first || meeting->along < first->along))
            first = meeting;
    }
    if (first)
        return first->point;
    // A way that starts on the boundary and goes out leaves at its very start.
    if (!contains(to))
        return from;
    return {};
}

} // namespace fff
