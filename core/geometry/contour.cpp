#include "core/geometry/contour.h"

#include "core/base/fault_point.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cassert>

namespace fff {

namespace {

std::vector<Vec2> pointsOf(const std::vector<CubicBezier> &segments)
{
    std::vector<Vec2> points;
    points.reserve(3 * segments.size());
    for (const CubicBezier &s : segments)
        points.insert(points.end(), {s.p0, s.p1, s.p2});
    return points;
}

std::vector<CubicBezier> edgesOf(const Polygon &polygon)
{
    std::vector<CubicBezier> segments;
    segments.reserve(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
        segments.push_back(CubicBezier::line(polygon[i], polygon[(i + 1) % polygon.size()]));
    return segments;
}

} // namespace

Polyline reversed(const Polyline &chords, int segments)
{
    Polyline result = chords;
    if (chords.points.empty())
        return result;
    std::reverse(result.points.begin() + 1, result.points.end());
    std::reverse(result.origins.begin() + 1, result.origins.end());
    for (CurvePoint &origin : result.origins) {
        // A segment's start is the end of the one before, which becomes the start of its successor.
        origin.segment = segments - origin.segment - (origin.t > 0.0 ? 1 : 0);
        origin.segment = origin.segment < segments ? origin.segment : 0;
        origin.t = origin.t > 0.0 ? 1.0 - origin.t : 0.0;
    }
    return result;
}

Result<Contour> Contour::fromPoints(std::vector<Vec2> points)
{
    if (points.size() % 3 != 0 || points.size() < 6)
        return failure(ErrorCode::BadContour, {}, {std::to_string(points.size()), "3k, k >= 2"});
    if (failsHere(FaultPoint::Contour))
        return failure(ErrorCode::NotWorkedOut);
    for (const Vec2 &p : points) {
        if (!p.allFinite())
            return failure(ErrorCode::NonFinite);
        if (p.cwiseAbs().maxCoeff() > kMaxCoordinate)
            return failure(
                ErrorCode::BadValue, {},
                {std::to_string(p.cwiseAbs().maxCoeff()), std::to_string(kMaxCoordinate)});
    }
    return ofPoints(std::move(points));
}

Result<Contour> Contour::fromSegments(const std::vector<CubicBezier> &segments)
{
    return fromPoints(pointsOf(segments));
}

Result<Contour> Contour::fromPolygon(const Polygon &polygon)
{
    return fromSegments(edgesOf(polygon));
}

Contour Contour::ofPoints(std::vector<Vec2> points)
{
    assert(points.size() % 3 == 0 && points.size() >= 6 && "these make no contour");
    Contour contour;
    contour.m_points = std::move(points);
    return contour;
}

Contour Contour::ofSegments(const std::vector<CubicBezier> &segments)
{
    return ofPoints(pointsOf(segments));
}

Contour Contour::ofPolygon(const Polygon &polygon)
{
    return ofSegments(edgesOf(polygon));
}

CubicBezier Contour::segment(int index) const
{
    const std::size_t i = 3 * static_cast<std::size_t>(index);
    return {m_points[i], m_points[i + 1], m_points[i + 2], m_points[(i + 3) % m_points.size()]};
}

Contour Contour::reversed() const
{
    Contour result;
    if (m_points.empty())
        return result;
    // p0 stays first: p0 h h p1 ... becomes p0, then everything behind it backwards.
    result.m_points.reserve(m_points.size());
    result.m_points.push_back(m_points.front());
    result.m_points.insert(result.m_points.end(), m_points.rbegin(), m_points.rend() - 1);
    return result;
}

double Contour::signedArea() const
{
    // ½ ∮ x dy − y dx of one cubic, in closed form.
    double sum = 0.0;
    for (int i = 0; i < segmentCount(); ++i) {
        const CubicBezier b = segment(i);
        sum += 6.0 * cross(b.p0, b.p1) + 3.0 * cross(b.p0, b.p2) + cross(b.p0, b.p3) +
               3.0 * cross(b.p1, b.p2) + 3.0 * cross(b.p1, b.p3) + 6.0 * cross(b.p2, b.p3);
    }
    return sum / 20.0;
}

Box2 Contour::bounds() const
{
    Box2 box;
    for (const Vec2 &p : m_points)
        box.extend(p);
    return box;
}

Polygon Contour::polygon(double tolerance) const
{
    constexpr std::size_t kUsualChords = 16; // of a curve
    Polygon polygon;
    polygon.reserve(kUsualChords * m_points.size() / 3);
    for (int i = 0; i < segmentCount(); ++i) {
        const CubicBezier curve = segment(i);
        if (polygon.empty() || polygon.back() != curve.p0)
            polygon.push_back(curve.p0);
        if (curve.isStraight(kClipGrid))
            continue;
        const Vec2 c1 = 3.0 * (curve.p1 - curve.p0), c2 = 3.0 * (curve.p2 - curve.p1) - c1,
                   c3 = curve.p3 - curve.p0 - c1 - c2;
        const int count = curve.chordCount(tolerance);
        const double step = 1.0 / count;
        for (int j = 1; j < count; ++j) {
            const double t = j * step;
            polygon.push_back(curve.p0 + t * (c1 + t * (c2 + t * c3)));
        }
    }
    while (polygon.size() > 1 && polygon.back() == polygon.front())
        polygon.pop_back();
    return polygon;
}

Polyline Contour::flatten(double tolerance) const
{
    Polyline polyline;
    std::vector<int> counts;
    std::size_t total = 0;
    counts.reserve(m_points.size() / 3);
    for (int i = 0; i < segmentCount(); ++i) {
        const CubicBezier curve = segment(i);
        counts.push_back(curve.isStraight(kClipGrid) ? 1 : curve.chordCount(tolerance));
        total += static_cast<std::size_t>(counts.back());
    }
    polyline.points.reserve(total);
    polyline.origins.reserve(total);
    for (int i = 0; i < segmentCount(); ++i) {
        const CubicBezier curve = segment(i);
        const int count = counts[static_cast<std::size_t>(i)];
        for (int j = 0; j < count; ++j) {
            const double t = static_cast<double>(j) / count;
            const Vec2 point = curve.at(t);
            if (!polyline.points.empty() && polyline.points.back() == point)
                continue;
            polyline.points.push_back(point);
            polyline.origins.push_back({i, t});
        }
    }
    while (polyline.points.size() > 1 && polyline.points.back() == polyline.points.front()) {
        polyline.points.pop_back();
        polyline.origins.pop_back();
    }
    return polyline;
}

} // namespace fff
