// A drawn boundary: a closed chain of cubic Béziers, in the coordinates of its section's frame, mm.
#pragma once

#include "core/base/result.h"
#include "core/geometry/bezier.h"
#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// Where on a contour: a segment and the parameter in it (0 ≤ t < 1 but at a piece's end).
struct CurvePoint
{
    int segment = 0;
    double t = 0.0;

    bool operator==(const CurvePoint &) const = default;
};

/// A contour as chords, and from where on the curve each vertex came.
struct Polyline
{
    Polygon points;                  // n, the first not repeated
    std::vector<CurvePoint> origins; // n
};

/// The chords of a contour of so many segments, of the same one reversed. The first vertex stays.
Polyline reversed(const Polyline &chords, int segments);

class Contour
{
public:
    Contour() = default;

    /// points: 3k control points p0 h h p1 h h …; the last segment closes onto p0.
    /// Errors  BadContour when the number is no multiple of 3 or below 6, NonFinite, BadValue
    /// beyond kMaxCoordinate. Area and crossings are not looked at.
    static Result<Contour> fromPoints(std::vector<Vec2> points);
    /// From a chain of segments, each starting where the one before ended, the last ending at the
    /// first's start. At least 2.
    static Result<Contour> fromSegments(const std::vector<CubicBezier> &segments);
    /// Straight edges between these corners. At least 3 (2 are taken too: a contour without area).
    static Result<Contour> fromPolygon(const Polygon &polygon);

    /// The same of what is known to be a contour by how it was made, and cannot fail. Whoever makes
    /// one of less than two segments has a bug. What is too large for booleans fails there.
    static Contour ofPoints(std::vector<Vec2> points);
    static Contour ofSegments(const std::vector<CubicBezier> &segments);
    static Contour ofPolygon(const Polygon &polygon);

    int segmentCount() const { return static_cast<int>(m_points.size() / 3); }
    CubicBezier segment(int index) const;
    const std::vector<Vec2> &points() const { return m_points; }

    Contour reversed() const;
    /// Exact, positive for counter-clockwise. mm².
    double signedArea() const;
    /// Of the control points: contains the curve.
    Box2 bounds() const;
    /// Chords within `tolerance` mm of the curve; every segment's start is a vertex; consecutive
    /// equal points are left out. O(number of chords).
    Polyline flatten(double tolerance) const;
    /// Its points alone, off the curve by rounding: for what looks at a boundary and keeps nothing.
    Polygon polygon(double tolerance) const;

    bool operator==(const Contour &) const = default;

private:
    std::vector<Vec2> m_points;
};

} // namespace fff
