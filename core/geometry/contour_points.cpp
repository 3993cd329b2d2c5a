#include "core/geometry/contour_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

using Points = std::vector<Vec2>;

std::size_t anchorAt(int index)
{
    return 3 * static_cast<std::size_t>(index);
}

std::size_t handleAt(const Points &points, int index, HandleSide side)
{
    const std::size_t at = anchorAt(index);
    return side == HandleSide::Out ? at + 1 : (at + points.size() - 1) % points.size();
}

HandleSide other(HandleSide side)
{
    return side == HandleSide::In ? HandleSide::Out : HandleSide::In;
}

int before(const Contour &contour, int index)
{
    return (index + contour.segmentCount() - 1) % contour.segmentCount();
}

/// The segment on this side of an anchor.
CubicBezier segmentBeside(const Contour &contour, int index, HandleSide side)
{
    return contour.segment(side == HandleSide::Out ? index : before(contour, index));
}

bool hasThirds(const CubicBezier &s)
{
    const Vec2 chord = s.p3 - s.p0;
    const double slack = kLineShare * chord.norm();
    return (s.p1 - s.p0 - chord / 3.0).norm() <= slack &&
           (s.p2 - s.p3 + chord / 3.0).norm() <= slack;
}

Vec2 turnedBy(const Vec2 &v, const Vec2 &from, const Vec2 &to)
{
    // As complex numbers: v · (to / from), without the change of length.
    const double length = from.norm() * to.norm();
    const double c = from.dot(to) / length, s = cross(from, to) / length;
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

/// The same line between its ends as they are now.
void straighten(Points &points, int segment)
{
    const std::size_t i = anchorAt(segment);
    const CubicBezier line = CubicBezier::line(points[i], points[(i + 3) % points.size()]);
    points[i + 1] = line.p1;
    points[i + 2] = line.p2;
}

/// A smooth point's handle turns with the line on its other side.
void turnWithLine(const Contour &contour, int index, HandleSide lineSide, const Vec2 &chordBefore,
                  const Vec2 &chordNow, Points &points)
{
    const PointKind kind = kindOf(contour, index);
    if (kind == PointKind::Corner || !(chordNow.norm() > kNoHandle))
        return;
    const std::size_t at = handleAt(points, index, other(lineSide));
    const Vec2 &center = points[anchorAt(index)];
    Vec2 arm = turnedBy(points[at] - center, chordBefore, chordNow);
    if (kind == PointKind::Symmetric)
        arm *= chordNow.norm() / chordBefore.norm();
    points[at] = center + arm;
}

} // namespace

bool isLine(const CubicBezier &s)
{
    if ((s.p3 - s.p0).norm() <= kNoHandle)
        return false;
    return hasThirds(s) || ((s.p1 - s.p0).norm() <= kNoHandle && (s.p2 - s.p3).norm() <= kNoHandle);
}

Vec2 anchor(const Contour &contour, int index)
{
    return contour.points()[anchorAt(index)];
}

Vec2 handle(const Contour &contour, int index, HandleSide side)
{
    return contour.points()[handleAt(contour.points(), index, side)];
}

PointKind kindOf(const Contour &contour, int index)
{
    const Vec2 at = anchor(contour, index);
    const Vec2 in = at - handle(contour, index, HandleSide::In);
    const Vec2 out = handle(contour, index, HandleSide::Out) - at;
    const double shorter = std::min(in.norm(), out.norm()),
                 longer = std::max(in.norm(), out.norm());
    if (shorter <= kNoHandle || in.dot(out) <= 0.0 ||
        std::abs(cross(in, out)) > std::sin(kSmoothAngle) * shorter * longer)
        return PointKind::Corner;
    if (isLine(segmentBeside(contour, index, HandleSide::In)) &&
        isLine(segmentBeside(contour, index, HandleSide::Out)))
        return PointKind::Corner;
    return longer - shorter <= kSymmetricShare * longer ? PointKind::Symmetric : PointKind::Smooth;
}

namespace {

Points pointsMoved(const Contour &contour, std::span<const int> indices, const Vec2 &by,
                   bool breaks)
{
    Points points = contour.points();
    std::vector<char> isMoved(static_cast<std::size_t>(contour.segmentCount()), char(false));
    for (const int index : indices) {
        if (std::exchange(isMoved[static_cast<std::size_t>(index)], char(true)))
            continue;
        points[anchorAt(index)] += by;
        if (breaks)
            continue;
        points[handleAt(points, index, HandleSide::In)] += by;
        points[handleAt(points, index, HandleSide::Out)] += by;
    }
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const int next = (i + 1) % contour.segmentCount();
        if (isMoved[static_cast<std::size_t>(i)] == isMoved[static_cast<std::size_t>(next)])
            continue; // it moves as it is, or stays
        const CubicBezier segment = contour.segment(i);
        if (!isLine(segment))
            continue;
        if (hasThirds(segment))
            straighten(points, i);
        if (breaks)
            continue;
        const Vec2 chord = points[anchorAt(next)] - points[anchorAt(i)];
        turnWithLine(contour, i, HandleSide::Out, segment.p3 - segment.p0, chord, points);
        turnWithLine(contour, next, HandleSide::In, segment.p3 - segment.p0, chord, points);
    }
    return points;
}

void moveHandle(const Contour &contour, int index, HandleSide side, const Vec2 &to, bool breaks,
                Points &points)
{
    const PointKind kind = breaks ? PointKind::Corner : kindOf(contour, index);
    const Vec2 center = anchor(contour, index);
    Vec2 &own = points[handleAt(points, index, side)];
    Vec2 &opposite = points[handleAt(points, index, other(side))];
    own = to;
    if (kind == PointKind::Corner)
        return;
    if (isLine(segmentBeside(contour, index, other(side)))) {
        const Vec2 direction = (center - opposite).normalized();
        own = center + std::max(direction.dot(to - center), 0.0) * direction;
    } else if (const double length = (to - center).norm(); length > kNoHandle) {
        const double keeps =
            kind == PointKind::Symmetric ? 1.0 : (opposite - center).norm() / length;
        opposite = center - keeps * (to - center);
    }
}

} // namespace

Result<Contour> movedAnchors(const Contour &contour, std::span<const int> indices, const Vec2 &by,
                             bool breaks)
{
    return Contour::fromPoints(pointsMoved(contour, indices, by, breaks));
}

Result<Contour> movedAnchor(const Contour &contour, int index, const Vec2 &to)
{
    Points points = pointsMoved(contour, {&index, 1}, to - anchor(contour, index), false);
    points[anchorAt(index)] = to; // from + (to − from) need not be `to`
    return Contour::fromPoints(std::move(points));
}

Result<Contour> movedHandle(const Contour &contour, int index, HandleSide side, const Vec2 &to,
                            bool breaks)
{
    Points points = contour.points();
    moveHandle(contour, index, side, to, breaks, points);
    return Contour::fromPoints(std::move(points));
}

Result<Contour> movedSegment(const Contour &contour, int segment, double t, const Vec2 &by,
                             bool breaks)
{
    // The point follows when b1 d1 + b2 d2 = by; the least such d1, d2 are along `by`.
    const double u = std::clamp(t, kNearestPull, 1.0 - kNearestPull), s = 1.0 - u;
    const double b1 = 3.0 * s * s * u, b2 = 3.0 * s * u * u;
    const Vec2 unit = by / (b1 * b1 + b2 * b2);
    const CubicBezier curve = contour.segment(segment);
    const int end = (segment + 1) % contour.segmentCount();
    Points points = contour.points();
    moveHandle(contour, segment, HandleSide::Out, curve.p1 + b1 * unit, breaks, points);
    moveHandle(contour, end, HandleSide::In, curve.p2 + b2 * unit, breaks, points);
    return Contour::fromPoints(std::move(points));
}

Result<Contour> insertedPoint(const Contour &contour, int segment, double t)
{
    const CubicBezier curve = contour.segment(segment);
    const CubicBezier first = curve.piece(0.0, t), second = curve.piece(t, 1.0);
    Points points = contour.points();
    const auto at = points.begin() + static_cast<std::ptrdiff_t>(anchorAt(segment)) + 1;
    *at = first.p1;
    *(at + 1) = second.p2;
    points.insert(at + 1, {first.p2, first.p3, second.p1});
    return Contour::fromPoints(std::move(points));
}

namespace {

/// Where the curve goes to at an end of a segment, as a unit vector; 0 for one of no length.
Vec2 startDirection(const CubicBezier &s)
{
    for (const Vec2 &p : {s.p1, s.p2, s.p3})
        if ((p - s.p0).norm() > kNoHandle)
            return (p - s.p0).normalized();
    return Vec2::Zero();
}

struct Arms
{
    Vec2 in, out; // from the anchor to its handles

    void apply(const Vec2 &center, int index, Points &points) const
    {
        points[handleAt(points, index, HandleSide::In)] = center + in;
        points[handleAt(points, index, HandleSide::Out)] = center + out;
    }
};

/// The handles that make an anchor smooth, or symmetric. Lines beside it have their thirds.
Arms smoothArms(const Contour &contour, int index, bool isSymmetric)
{
    const Vec2 center = anchor(contour, index);
    const CubicBezier in = segmentBeside(contour, index, HandleSide::In);
    const CubicBezier out = segmentBeside(contour, index, HandleSide::Out);
    const bool isLineIn = isLine(in), isLineOut = isLine(out);
    const Vec2 arriving = -startDirection(in.reversed()), leaving = startDirection(out);
    Vec2 tangent = arriving + leaving;
    if (isLineIn != isLineOut)
        tangent = isLineIn ? arriving : leaving;
    else if (tangent.norm() <= kSmoothAngle)
        tangent = out.p3 - in.p0; // a cusp: past it, as its neighbours lie
    if (tangent.norm() <= kNoHandle)
        tangent = perpendicular(leaving);
    tangent.normalize();

    const auto length = [&](const Vec2 &arm, const CubicBezier &s, bool isLineHere) {
        const bool keeps = arm.norm() > kNoHandle && !(isLineHere && isLineIn && isLineOut);
        return keeps ? arm.norm() : kHandleShare * (s.p3 - s.p0).norm();
    };
    double inLength = length(center - in.p2, in, isLineIn);
    double outLength = length(out.p1 - center, out, isLineOut);
    if (isSymmetric) {
        const double mean = isLineIn == isLineOut ? 0.5 * (inLength + outLength)
                            : isLineIn            ? inLength
                                                  : outLength;
        inLength = outLength = mean;
    } else if (std::abs(inLength - outLength) <= 2.0 * kSymmetricShare * inLength) {
        // Free to differ from now on: nobody sees the difference, and it is no symmetric point.
        double &freer = isLineOut && !isLineIn ? inLength : outLength;
        freer = (1.0 + 3.0 * kSymmetricShare) * (isLineOut && !isLineIn ? outLength : inLength);
    }
    return {-inLength * tangent, outLength * tangent};
}

Arms cornerArms(const Contour &contour, int index)
{
    const Vec2 center = anchor(contour, index);
    const Vec2 in = segmentBeside(contour, index, HandleSide::In).p0 - center;
    const Vec2 out = segmentBeside(contour, index, HandleSide::Out).p3 - center;
    return {in / 3.0, out / 3.0};
}

} // namespace

Result<Contour> withKind(const Contour &contour, int index, PointKind kind)
{
    if (kindOf(contour, index) == kind)
        return contour;
    Points points = contour.points();
    const Vec2 center = anchor(contour, index);
    if (kind == PointKind::Corner) {
        cornerArms(contour, index).apply(center, index, points);
        const Result<Contour> turned = Contour::fromPoints(points);
        if (!turned || kindOf(*turned, index) == PointKind::Corner)
            return turned;
        Arms{Vec2::Zero(), Vec2::Zero()}.apply(center, index, points);
        return Contour::fromPoints(std::move(points));
    }
    for (const int segment : {before(contour, index), index})
        if (isLine(contour.segment(segment)))
            straighten(points, segment); // one whose handles are in its ends has them now
    const Result<Contour> lines = Contour::fromPoints(points);
    if (!lines)
        return lines;
    smoothArms(*lines, index, kind == PointKind::Symmetric).apply(center, index, points);
    return Contour::fromPoints(std::move(points));
}

namespace {

constexpr int kSamples = 12; // a segment

/// The parameter between two at which the curve is nearest to a point, by golden sections: the
/// distance has one minimum between neighbouring samples.
double nearestParameter(const CubicBezier &curve, const Vec2 &point, double from, double to)
{
    constexpr double kGolden = 0.61803398874989485;
    constexpr int kSteps = 40; // 0.618^40 of a twelfth is below rounding of the distance
    const auto distance = [&](double t) { return (curve.at(t) - point).squaredNorm(); };
    double a = to - kGolden * (to - from), b = from + kGolden * (to - from);
    double atA = distance(a), atB = distance(b);
    for (int i = 0; i < kSteps; ++i) {
        if (atA < atB) {
            to = b;
            b = std::exchange(a, b - kGolden * (b - from));
            atB = std::exchange(atA, distance(a));
        } else {
            from = a;
            a = std::exchange(b, a + kGolden * (to - a));
            atA = std::exchange(atB, distance(b));
        }
    }
    return 0.5 * (from + to);
}

double distanceTo(const Box2 &box, const Vec2 &p)
{
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).norm();
}

} // namespace

NearestPlace nearestPlace(const Contour &contour, const Vec2 &point)
{
    NearestPlace best;
    best.distance = std::numeric_limits<double>::infinity();
    const auto consider = [&](int segment, double t, const CubicBezier &curve) {
        const Vec2 position = curve.at(t);
        const double distance = (position - point).norm();
        if (distance < best.distance)
            best = {{segment, t}, position, distance};
    };
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        Box2 box;
        for (const Vec2 &p : {curve.p0, curve.p1, curve.p2, curve.p3})
            box.extend(p);
        if (distanceTo(box, point) >= best.distance)
            continue;
        std::array<double, kSamples + 1> distances;
        for (int k = 0; k <= kSamples; ++k)
            distances[static_cast<std::size_t>(k)] =
                (curve.at(static_cast<double>(k) / kSamples) - point).squaredNorm();
        consider(i, 0.0, curve);
        for (int k = 0; k <= kSamples; ++k) {
            const auto at = static_cast<std::size_t>(k);
            const int from = std::max(k - 1, 0), to = std::min(k + 1, kSamples);
            if (distances[at] > distances[static_cast<std::size_t>(from)] ||
                distances[at] > distances[static_cast<std::size_t>(to)])
                continue;
            const double t = nearestParameter(curve, point, static_cast<double>(from) / kSamples,
                                              static_cast<double>(to) / kSamples);
            consider(i, t, curve);
        }
    }
    return best;
}

} // namespace fff
