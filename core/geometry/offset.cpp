#include "core/geometry/offset.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff {

namespace {

// Halvings of one segment before what is left of it is bridged by a straight line; what is left is
// then a cusp.
constexpr int kMaxHalvings = 10;
// A mitre reaches at most this many distances from its corner (SVG and Clipper cut off at a like
// ratio); a right angle needs 1.41.
constexpr double kMitreLimit = 2.5;
// Sine of the angle below which a boundary that turns back is a cusp, and the share of the curve's
// parameter from its tip at which its sides are told apart.
constexpr double kCuspSine = 1e-6;
constexpr double kBesideTip = 1.0 / 64.0;

/// Right of the direction: away from the material.
Vec2 rightOf(const Vec2 &direction)
{
    return -perpendicular(direction);
}

/// Unit tangent, also where the handle lies on the end point: there the next derivative that does
/// not vanish has it. Nothing for a segment that is a point.
std::optional<Vec2> tangent(const CubicBezier &curve, double t)
{
    const double size = std::max(
        {(curve.p1 - curve.p0).norm(), (curve.p2 - curve.p0).norm(), (curve.p3 - curve.p0).norm()});
    if (const Vec2 d = curve.derivative(t); d.norm() > kParallelSine * size)
        return d.normalized();
    // Towards the inside of the parameter range, and always forwards.
    const double side = t < 0.5 ? 1.0 : -1.0;
    if (const Vec2 d = side * curve.secondDerivative(t); d.norm() > kParallelSine * size)
        return d.normalized();
    const Vec2 chord = curve.p3 - curve.p0;
    if (chord.isZero())
        return std::nullopt;
    return chord.normalized();
}

/// Appends cubics for the offset of the curve between two parameters: Hermite pieces with the exact
/// ends and derivatives o' = c' (1 + distance · curvature). The curve itself is reproduced, so the
/// error is only that of the normal, times the distance.
void appendOffset(std::vector<CubicBezier> &pieces, const CubicBezier &curve, double distance,
                  double from, double to, int halvings)
{
    const auto direction = [&](double t) { return tangent(curve, t).value_or(Vec2::UnitX()); };
    const auto point = [&](double t) -> Vec2 {
        return curve.at(t) + distance * rightOf(direction(t));
    };
    const auto derivative = [&](double t) -> Vec2 {
        const Vec2 d = curve.derivative(t);
        const double speed = d.norm();
        const double turn = cross(d, curve.secondDerivative(t)) / (speed * speed * speed);
        return d * (1.0 + distance * (std::isfinite(turn) ? turn : 0.0));
    };
    const double step = (to - from) / 3.0;
    const Vec2 start = point(from), end = point(to);
    const CubicBezier piece{start, start + step * derivative(from), end - step * derivative(to),
                            end};
    bool isNear = true;
    for (double u : {0.2, 0.4, 0.6, 0.8})
        isNear = isNear && (piece.at(u) - point(from + u * (to - from))).norm() <= kOffsetError;
    if (isNear) {
        pieces.push_back(piece);
    } else if (halvings == kMaxHalvings) {
        pieces.push_back(CubicBezier::line(start, end));
    } else {
        const double middle = 0.5 * (from + to);
        appendOffset(pieces, curve, distance, from, middle, halvings + 1);
        appendOffset(pieces, curve, distance, middle, to, halvings + 1);
    }
}

/// A segment's offset with the directions in which it begins and ends.
struct OffsetSegment
{
    CubicBezier source;
    std::vector<CubicBezier> pieces;
    Vec2 first = Vec2::UnitX(), last = Vec2::UnitX();
    bool isStraight = false;
};

std::vector<OffsetSegment> offsetSegments(const Contour &contour, double distance)
{
    std::vector<OffsetSegment> result;
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        OffsetSegment next;
        next.source = curve;
        next.isStraight = curve.isStraight(kClipGrid);
        const Vec2 chord = curve.p3 - curve.p0;
        if (next.isStraight) {
            if (chord.norm() <= kClipGrid)
                continue;
            next.first = next.last = chord.normalized();
            const Vec2 shift = distance * rightOf(next.first);
            next.pieces.push_back(CubicBezier::line(curve.p0 + shift, curve.p3 + shift));
        } else {
            next.first = tangent(curve, 0.0).value_or(Vec2::UnitX());
            next.last = tangent(curve, 1.0).value_or(Vec2::UnitX());
            appendOffset(next.pieces, curve, distance, 0.0, 1.0, 0);
        }
        result.push_back(std::move(next));
    }
    return result;
}

/// Whether the boundary turns left from a to b. Where it turns back on itself, at the tip of a
/// cusp, the tangents do not tell; points a little away from the tip do.
bool turnsLeft(const OffsetSegment &a, const OffsetSegment &b)
{
    const double sine = cross(a.last, b.first);
    if (a.last.dot(b.first) > 0.0 || std::abs(sine) > kCuspSine)
        return sine > 0.0;
    const Vec2 tip = a.source.p3;
    return cross(tip - a.source.at(1.0 - kBesideTip), b.source.at(kBesideTip) - tip) >= 0.0;
}

/// Corners of the mitre on the way round a corner that turns left, in order; none where the
/// boundary turns right or goes smoothly on.
std::vector<Vec2> mitre(const OffsetSegment &a, const OffsetSegment &b, double distance)
{
    if (!turnsLeft(a, b))
        return {};
    const double sine = std::abs(cross(a.last, b.first)), cosine = a.last.dot(b.first);
    const Vec2 end = a.pieces.back().p3, start = b.pieces.front().p0;
    const double half = 0.5 * std::atan2(sine, cosine);
    if (std::cos(half) * kMitreLimit >= 1.0)
        return {end + distance * std::tan(half) * a.last};
    const double reach = distance * std::tan(0.5 * half);
    return {end + reach * a.last, start - reach * b.first};
}

/// Straight edges from the end of a's offset to the start of b's. A straight neighbour goes on to
/// the mitre's corner instead.
std::vector<CubicBezier> joinSegments(OffsetSegment &a, OffsetSegment &b, double distance)
{
    Vec2 &start = b.pieces.front().p0;
    Vec2 &end = a.pieces.back().p3;
    if ((start - end).norm() <= kClipGrid)
        return {};
    std::vector<Vec2> way = mitre(a, b, distance);
    if (!way.empty()) {
        const Vec2 first = way.front(), last = way.back();
        if (a.isStraight)
            a.pieces.back() = CubicBezier::line(a.pieces.back().p0, first);
        if (b.isStraight)
            b.pieces.front() = CubicBezier::line(last, b.pieces.front().p3);
    }
    way.insert(way.begin(), end);
    way.push_back(start);
    std::vector<CubicBezier> join;
    for (std::size_t i = 1; i < way.size(); ++i) {
        if ((way[i] - way[i - 1]).norm() > kClipGrid)
            join.push_back(CubicBezier::line(way[i - 1], way[i]));
    }
    return join;
}

Contour rawOffset(const Contour &contour, double distance)
{
    std::vector<OffsetSegment> segments = offsetSegments(contour, distance);
    std::vector<std::vector<CubicBezier>> joins;
    for (std::size_t i = 0; i < segments.size(); ++i)
        joins.push_back(joinSegments(segments[i], segments[(i + 1) % segments.size()], distance));
    std::vector<CubicBezier> chain;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        chain.insert(chain.end(), segments[i].pieces.begin(), segments[i].pieces.end());
        chain.insert(chain.end(), joins[i].begin(), joins[i].end());
    }
    return Contour::fromSegments(chain).value_or(Contour());
}

} // namespace

CurvedRegion grow(const CurvedRegion &region, double distance)
{
    if (distance == 0.0)
        return region;
    std::vector<Contour> boundaries{rawOffset(region.outer, distance)};
    for (const Contour &hole : region.holes)
        boundaries.push_back(rawOffset(hole, distance));
    Result<std::vector<CurvedRegion>> grown =
        windingRegions(boundaries, WindingRule::Positive, kCutChord);
    return !grown || grown->empty() ? region : std::move(grown->front());
}

} // namespace fff
