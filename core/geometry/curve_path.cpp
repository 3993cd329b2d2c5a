#include "core/geometry/curve_path.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cassert>

namespace fff {

Result<CurvePath> CurvePath::fromPoints(std::vector<Vec2> points)
{
    if (points.size() < 4 || points.size() % 3 != 1)
        return failure(ErrorCode::BadContour);
    for (const Vec2 &p : points) {
        if (!p.allFinite())
            return failure(ErrorCode::NonFinite);
        if (p.cwiseAbs().maxCoeff() > kMaxCoordinate)
            return failure(ErrorCode::BadValue);
    }
    CurvePath path;
    path.m_points = std::move(points);
    return path;
}

Result<CurvePath> CurvePath::fromLine(const Polygon &line)
{
    std::vector<Vec2> points;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const CubicBezier edge = CubicBezier::line(line[i], line[i + 1]);
        points.insert(points.end(), {edge.p0, edge.p1, edge.p2});
    }
    if (!points.empty())
        points.push_back(line.back());
    return fromPoints(std::move(points));
}

CurvePath CurvePath::around(const Contour &contour)
{
    CurvePath path;
    path.m_points.reserve(contour.points().size() + 1);
    path.m_points = contour.points(); // keeps the room
    path.m_points.push_back(contour.points().front());
    return path;
}

CubicBezier CurvePath::segment(int index) const
{
    const auto first = 3 * static_cast<std::size_t>(index);
    return {m_points[first], m_points[first + 1], m_points[first + 2], m_points[first + 3]};
}

Result<Contour> CurvePath::ring() const
{
    assert(isClosed());
    if (segmentCount() == 1) {
        const CubicBezier loop = segment(0);
        return Contour::fromSegments({loop.piece(0.0, 0.5), loop.piece(0.5, 1.0)});
    }
    return Contour::fromPoints({m_points.begin(), m_points.end() - 1});
}

Box2 CurvePath::bounds() const
{
    Box2 box;
    for (const Vec2 &p : m_points)
        box.extend(p);
    return box;
}

Polygon CurvePath::flatten(double tolerance) const
{
    Polygon line;
    if (!m_points.empty())
        line.push_back(m_points.front());
    for (int i = 0; i < segmentCount(); ++i) {
        const CubicBezier curve = segment(i);
        const int count = curve.chordCount(tolerance);
        for (int k = 1; k < count; ++k)
            line.push_back(curve.at(static_cast<double>(k) / count));
        line.push_back(curve.p3);
    }
    return line;
}

Result<CurvePath> CurvePath::mapped(const Eigen::Matrix2d &matrix, const Vec2 &about) const
{
    std::vector<Vec2> points = m_points;
    for (Vec2 &p : points)
        p = about + matrix * (p - about);
    // A closed one stays closed, also where rounding would part its ends.
    if (isClosed())
        points.back() = points.front();
    return fromPoints(std::move(points));
}

} // namespace fff
