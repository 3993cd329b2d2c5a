#include "core/stroke/straightened.h"

#include "core/geometry/contour_points.h"
#include "core/geometry/fit.h"
#include "core/geometry/sampled_line.h"
#include "core/stroke/meant_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;
/// A joint that turns by more is a corner, radians.
constexpr double kEdgeCorner = 0.44;
/// Tolerances that a line is long at least; and that it may be bent by, or parts of its length,
/// whichever is more, but no more than another part of that.
constexpr double kLeastEdge = 8.0, kBentBy = 1.0, kBentShare = 0.035, kMostBent = 0.06;
/// Lines that lie along or across the others within this angle do so, and level ones within that.
constexpr double kNearlyAlong = 0.17, kNearlyLevel = 0.06;
/// A line that is level or upright within this keeps the others so.
constexpr double kLevel = 0.03;
/// Tolerances that a line between two others is long that is none, but their corner cut off.
constexpr double kCutCorner = 2.0;
/// Tolerances, and part of the shorter of its lines, that a corner may go to where these meet.
constexpr double kCornerWay = 4.0, kCornerShare = 0.2;
/// Radians, and tolerances, by which a right angle is off, and a line is bent or a corner moves,
/// for it to be worth a word: less is not seen.
constexpr double kWorthTurning = 0.005, kWorthSeeing = 0.25;

/// From one corner to the next.
struct Edge
{
    int first = 0, count = 0; // segments
    Vec2 from = Vec2::Zero(), to = Vec2::Zero(), middle = Vec2::Zero();
    Vec2 way = Vec2::Zero(); // unit, of one that is straight
    double length = 0.0;     // mm, of its chord
    double bent = 0.0;       // mm that it goes off its chord at the most
    bool isStraight = false;
    bool isTurned = false; // to lie along or across others
};

Edge edgeOf(const Contour &contour, int first, int count, double tolerance)
{
    Edge edge{first, count};
    const int segments = contour.segmentCount();
    edge.from = contour.segment(first).p0;
    edge.to = contour.segment((first + count - 1) % segments).p3;
    const Vec2 chord = edge.to - edge.from;
    edge.length = chord.norm();
    if (edge.length < kLeastEdge * tolerance)
        return edge;
    edge.way = chord / edge.length;
    double left = 0.0, right = 0.0, furthest = 0.0;
    bool goesOn = true;
    constexpr int kPlaces = 16;
    for (int k = 0; k < count; ++k) {
        const CubicBezier s = contour.segment((first + k) % segments);
        for (int i = 0; i <= kPlaces; ++i) {
            const Vec2 off = s.at(double(i) / kPlaces) - edge.from;
            const double aside = cross(edge.way, off), along = edge.way.dot(off);
            left = std::max(left, aside);
            right = std::max(right, -aside);
            goesOn = goesOn && along >= furthest - tolerance;
            furthest = std::max(furthest, along);
        }
    }
    edge.bent = std::max(left, right);
    edge.isStraight = goesOn && edge.bent <= kMostBent * edge.length &&
                      edge.bent <= std::max(kBentBy * tolerance, kBentShare * edge.length);
    edge.middle = 0.5 * (edge.from + edge.to) +
                  0.5 * (left - right) * perpendicular(edge.way); // between both sides of it
    return edge;
}

/// Empty where there are fewer than two corners.
std::vector<Edge> edgesOf(const Contour &contour, double tolerance)
{
    const std::vector<double> turns = turnsAtJoints(contour);
    std::vector<int> corners;
    for (int i = 0; i < contour.segmentCount(); ++i)
        if (turns[static_cast<std::size_t>(i)] > kEdgeCorner)
            corners.push_back(i);
    std::vector<Edge> edges;
    for (std::size_t k = 0; corners.size() > 1 && k < corners.size(); ++k) {
        const int next = corners[(k + 1) % corners.size()];
        const int count = (next - corners[k] + contour.segmentCount()) % contour.segmentCount();
        edges.push_back(edgeOf(contour, corners[k], count, tolerance));
    }
    return edges;
}

/// Without those that a hasty or noisy corner has in place of its tip; true when there were any.
bool dropCutCorners(std::vector<Edge> &edges, double tolerance)
{
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < edges.size() && edges.size() > 3;) {
        const Edge &before = edges[(i + edges.size() - 1) % edges.size()],
                   &after = edges[(i + 1) % edges.size()];
        const Vec2 way = edges[i].to - edges[i].from;
        const bool isCut = edges[i].length < kCutCorner * tolerance && before.isStraight &&
                           after.isStraight && cross(before.way, way) * cross(way, after.way) > 0.0;
        if (isCut)
            edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
    return edges.size() < count;
}

/// Off a right angle, radians; of two straight edges.
double offRight(const Edge &a, const Edge &b)
{
    return std::abs(turnBetween(a.way, b.way) - kQuarter);
}

double angleOf(const Vec2 &way)
{
    return std::atan2(way.y(), way.x());
}

/// Off the nearest of the four directions, − … +.
double offAxes(double angle, double axes)
{
    return std::remainder(angle - axes, kQuarter);
}

/// Which way the lines of nearly right angles lie, as they do together; none without any.
std::optional<double> axesOf(const std::vector<Edge> &edges)
{
    Vec2 sum = Vec2::Zero();
    bool isOneLevel = false; // or upright: as it was meant to stay
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge &a = edges[i], &b = edges[(i + 1) % edges.size()];
        if (!a.isStraight || !b.isStraight || offRight(a, b) > kNearlyRight)
            continue;
        for (const Edge *edge : {&a, &b}) {
            const double angle = 4.0 * angleOf(edge->way);
            sum += edge->length * Vec2(std::cos(angle), std::sin(angle));
            isOneLevel = isOneLevel || std::abs(offAxes(angleOf(edge->way), 0.0)) <= kLevel;
        }
    }
    if (sum.isZero())
        return {};
    const double axes = 0.25 * angleOf(sum);
    return std::abs(offAxes(axes, 0.0)) <= (isOneLevel ? kNearlyAlong : kNearlyLevel) ? 0.0 : axes;
}

/// True when one of them is turned by more than is worth a word.
bool turnAlongEachOther(std::vector<Edge> &edges)
{
    const std::optional<double> axes = axesOf(edges);
    bool isTurned = false;
    for (Edge &edge : edges) {
        if (!axes || !edge.isStraight)
            continue;
        const double off = offAxes(angleOf(edge.way), *axes);
        if (std::abs(off) > kNearlyAlong)
            continue;
        isTurned = isTurned || std::abs(off) > kWorthTurning;
        const double angle = angleOf(edge.way) - off;
        edge.way = {std::cos(angle), std::sin(angle)};
        edge.isTurned = true;
    }
    return isTurned;
}

/// Where a corner goes that the edge before and the one after it have.
Vec2 cornerBetween(const Edge &before, const Edge &after, double tolerance)
{
    const Vec2 corner = after.from;
    const auto isFar = [&](const Vec2 &to) {
        const double shorter = std::min(before.length, after.length);
        return (to - corner).norm() > std::max(kCornerWay * tolerance, kCornerShare * shorter);
    };
    if (before.isStraight && after.isStraight && (before.isTurned || after.isTurned)) {
        const double determinant = cross(before.way, after.way);
        if (std::abs(determinant) < std::sin(kEdgeCorner))
            return corner;
        const Vec2 meeting = before.middle + cross(after.middle - before.middle, after.way) /
                                                 determinant * before.way;
        return isFar(meeting) ? corner : meeting;
    }
    const Edge *turned = before.isTurned ? &before : after.isTurned ? &after : nullptr;
    if (!turned)
        return corner;
    const Vec2 foot = turned->middle + turned->way.dot(corner - turned->middle) * turned->way;
    return isFar(foot) ? corner : foot;
}

} // namespace

std::vector<double> turnsAtJoints(const Contour &contour)
{
    const int count = contour.segmentCount();
    std::vector<double> turns;
    for (int i = 0; i < count; ++i)
        turns.push_back(turnBetween(endDirection(contour.segment((i + count - 1) % count)),
                                    startDirection(contour.segment(i))));
    return turns;
}

std::optional<Straightened> straightened(const Contour &drawn, double tolerance)
{
    std::vector<Edge> edges = edgesOf(drawn, tolerance);
    bool isChanged = dropCutCorners(edges, tolerance);
    Straightened result;
    result.hasRightAngles = turnAlongEachOther(edges);
    isChanged = isChanged || result.hasRightAngles;
    std::vector<Vec2> corners; // where each edge starts
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge &before = edges[(i + edges.size() - 1) % edges.size()];
        corners.push_back(cornerBetween(before, edges[i], tolerance));
        isChanged = isChanged || (corners[i] - edges[i].from).norm() > kWorthSeeing * tolerance;
    }
    std::vector<CubicBezier> segments;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge &edge = edges[i];
        const Vec2 &from = corners[i], &to = corners[(i + 1) % edges.size()];
        if (edge.isStraight) {
            isChanged = isChanged || edge.bent > kWorthSeeing * tolerance;
            segments.push_back(CubicBezier::line(from, to));
            continue;
        }
        for (int k = 0; k < edge.count; ++k)
            segments.push_back(drawn.segment((edge.first + k) % drawn.segmentCount()));
        CubicBezier &first = segments[segments.size() - static_cast<std::size_t>(edge.count)];
        first.p1 += from - first.p0;
        first.p0 = from;
        CubicBezier &last = segments.back();
        last.p2 += to - last.p3;
        last.p3 = to;
    }
    const bool isPolygon =
        std::all_of(edges.begin(), edges.end(), [](const Edge &edge) { return edge.isStraight; });
    if (!isChanged || segments.size() < (isPolygon ? 3u : 2u))
        return {};
    Result<Contour> contour = Contour::fromSegments(segments);
    if (!contour)
        return {};
    result.contour = *std::move(contour);
    return result;
}

} // namespace fff
