// A drawn line, open or closed: a chain of cubic Béziers that bounds nothing.
#pragma once

#include "core/base/result.h"
#include "core/geometry/bezier.h"
#include "core/geometry/contour.h"
#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

class CurvePath
{
public:
    CurvePath() = default;

    /// points: 3k + 1 control points p0 h h p1 h h … pk. Errors  BadContour when the number is no
    /// such one or below 4, NonFinite, BadValue beyond kMaxCoordinate.
    static Result<CurvePath> fromPoints(std::vector<Vec2> points);
    /// Straight edges between these points, of which there are at least 2.
    static Result<CurvePath> fromLine(const Polygon &line);
    /// All the way round it.
    static CurvePath around(const Contour &contour);

    int segmentCount() const { return static_cast<int>(m_points.size() / 3); }
    CubicBezier segment(int index) const;
    const std::vector<Vec2> &points() const { return m_points; }
    /// It ends where it begins.
    bool isClosed() const { return !m_points.empty() && m_points.front() == m_points.back(); }
    /// What a closed one runs round; a loop of one segment is cut in its middle. Errors  as
    /// Contour::fromPoints().
    Result<Contour> ring() const;
    /// Of the control points: contains the curve.
    Box2 bounds() const;
    /// Chords within `tolerance` mm of the curve, from its first to its last point.
    Polygon flatten(double tolerance) const;
    /// Each control point p as about + matrix (p − about). Errors  as fromPoints().
    Result<CurvePath> mapped(const Eigen::Matrix2d &matrix, const Vec2 &about) const;

    bool operator==(const CurvePath &) const = default;

private:
    std::vector<Vec2> m_points;
};

} // namespace fff
