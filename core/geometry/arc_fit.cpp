#include "core/geometry/arc_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace fff {

namespace {

/// A piece is halved no more often: then it is as small as rounding.
constexpr int kMostArcHalvings = 40;
/// Of the sine between a single arc and the curve at its ends: what is smooth stays so to the eye
/// and to a machine's feed.
constexpr double kArcKink = 0.01;
/// An arc of less height over its chord, in tolerances, is an edge.
constexpr double kFlatArc = 0.01;
/// Turns by less than a half circle: of a larger one its centre is not on one side of it.
constexpr double kMostBulge = 0.9;
/// Handles shorter than this share of the curve's size show in no direction.
constexpr double kShownHandle = 1e-9;
/// Steps that are shorter are none, mm.
constexpr double kLeastStep = 1e-5;

Vec2 directionOf(const Vec2 &way)
{
    const double length = way.norm();
    return length > 0.0 ? Vec2(way / length) : Vec2(Vec2::Zero());
}

/// At its start; zero where all of it is one point.
Vec2 leavingWay(const CubicBezier &curve)
{
    const double least =
        kShownHandle * std::max({(curve.p1 - curve.p0).norm(), (curve.p2 - curve.p0).norm(),
                                 (curve.p3 - curve.p0).norm()});
    for (const Vec2 &p : {curve.p1, curve.p2, curve.p3})
        if ((p - curve.p0).norm() > least)
            return directionOf(p - curve.p0);
    return Vec2::Zero();
}

Vec2 arrivingWay(const CubicBezier &curve)
{
    return -leavingWay(curve.reversed());
}

std::array<Vec2, 4> controlsOf(const CubicBezier &curve)
{
    return {curve.p0, curve.p1, curve.p2, curve.p3};
}

/// Bernstein coefficients, degree 6, of |c(t) − from|² − 2 (c(t) − from) · center.
std::array<double, 7> squaresAbout(const CubicBezier &curve, const Vec2 &from, const Vec2 &center)
{
    constexpr std::array<double, 4> kThree = {1, 3, 3, 1};
    constexpr std::array<double, 7> kSix = {1, 6, 15, 20, 15, 6, 1};
    std::array<Vec2, 4> w = controlsOf(curve);
    for (Vec2 &p : w)
        p -= from;
    std::array<double, 7> sums{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            // Half of the linear term of each, so that it is raised to degree 6 by the same sum.
            sums[i + j] +=
                kThree[i] * kThree[j] / kSix[i + j] * (w[i].dot(w[j]) - (w[i] + w[j]).dot(center));
    return sums;
}

/// No value of the polynomial with these Bernstein coefficients is farther from 0. Halved a few
/// times, they come close to it.
double mostOf(std::array<double, 7> coefficients, int halvings = 3)
{
    double most = 0.0;
    for (const double c : coefficients)
        most = std::max(most, std::abs(c));
    const double ends = std::max(std::abs(coefficients.front()), std::abs(coefficients.back()));
    if (halvings == 0 || most == ends)
        return most;
    std::array<double, 7> first{};
    for (std::size_t i = 0; i < 7; ++i) {
        first[i] = coefficients[0];
        for (std::size_t k = 0; k + 1 < 7 - i; ++k)
            coefficients[k] = 0.5 * (coefficients[k] + coefficients[k + 1]);
    }
    return std::max(mostOf(first, halvings - 1), mostOf(coefficients, halvings - 1));
}

/// Whether all of the curve is within the tolerance of the edge between its ends, and runs along
/// it.
bool followsEdge(const CubicBezier &curve, double tolerance)
{
    const Vec2 chord = curve.p3 - curve.p0;
    const double squared = chord.squaredNorm();
    if (squared == 0.0)
        return false;
    for (const Vec2 &p : {curve.p1, curve.p2}) {
        const double along = chord.dot(p - curve.p0), across = cross(chord, p - curve.p0);
        if (across * across > tolerance * tolerance * squared || along < 0.0 || along > squared)
            return false;
    }
    return true;
}

/// Whether all control points, and so all of the curve, are within the tolerance of both ends.
bool isAPoint(const CubicBezier &curve, double tolerance)
{
    const double most = 0.25 * tolerance * tolerance;
    return (curve.p1 - curve.p0).squaredNorm() <= most &&
           (curve.p2 - curve.p0).squaredNorm() <= most &&
           (curve.p3 - curve.p0).squaredNorm() <= most;
}

/// Whether the curve stays within the tolerance of the circle round the step's arc, which its ends
/// need not be on, and turns about its centre in the arc's direction alone, by less than a half
/// turn.
bool followsCircle(const CubicBezier &curve, const Vec2 &start, const ArcStep &step,
                   double tolerance)
{
    const Arc arc = arcOf(start, step);
    const Vec2 center = arc.center - start;
    // | |c − m| − r | = | |c − m|² − r² | / (|c − m| + r), and |c − m| is at least r − tolerance.
    const double most = tolerance * (2.0 * arc.radius - tolerance);
    if (!(most > 0.0))
        return false;
    if (mostOf(squaresAbout(curve, start, center)) > most)
        return false;
    // (c − m) × c' in degree 5: the products of the third degree's points and the second's ways.
    constexpr std::array<double, 4> kThree = {1, 3, 3, 1};
    constexpr std::array<double, 3> kTwo = {1, 2, 1};
    const std::array<Vec2, 4> points = controlsOf(curve);
    std::array<double, 6> turns{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            turns[i + j] +=
                kThree[i] * kTwo[j] * cross(points[i] - arc.center, points[j + 1] - points[j]);
    const double sign = step.bulge > 0.0 ? 1.0 : -1.0;
    if (std::any_of(turns.begin(), turns.end(), [sign](double t) { return sign * t < 0.0; }))
        return false;
    const Vec2 middle = arc.at(0.5) - arc.center;
    return std::all_of(points.begin(), points.end(),
                       [&](const Vec2 &p) { return middle.dot(p - arc.center) > 0.0; });
}

/// The arc from a point that leaves it in this direction and ends there; straight where it is.
std::optional<ArcStep> arcFrom(const Vec2 &start, const Vec2 &direction, const Vec2 &end)
{
    const Vec2 chord = end - start;
    const double along = direction.dot(chord), length = chord.norm();
    // Half the angle between direction and chord has the bulge as its tangent.
    const double divisor = length + along;
    if (!(length > 0.0) || !(divisor > 0.0))
        return std::nullopt;
    const double bulge = cross(direction, chord) / divisor;
    return std::abs(bulge) <= kMostBulge ? std::optional(ArcStep{end, bulge}) : std::nullopt;
}

/// Its height over the chord is what rounding and tolerance make of an edge.
bool isFlat(const Vec2 &start, const ArcStep &step, double tolerance)
{
    return 0.5 * std::abs(step.bulge) * (step.end - start).norm() <= kFlatArc * tolerance;
}

/// One arc through both ends and the curve's middle.
std::optional<ArcStep> oneArc(const CubicBezier &curve, const Vec2 &first, const Vec2 &last,
                              double tolerance)
{
    const Vec2 chord = curve.p3 - curve.p0, middle = curve.at(0.5);
    // The tangent at the start of the circle through three points is turned from the chord by the
    // angle at the third.
    const Vec2 a = curve.p0 - middle, b = curve.p3 - middle;
    const double sine = cross(a, b), cosine = a.dot(b);
    const double divisor = std::hypot(sine, cosine) - cosine;
    if (!(chord.squaredNorm() > 0.0) || !(divisor > 0.0))
        return std::nullopt;
    const ArcStep step{curve.p3, -sine / divisor};
    if (std::abs(step.bulge) > kMostBulge || isFlat(curve.p0, step, tolerance) ||
        !followsCircle(curve, curve.p0, step, tolerance))
        return std::nullopt;
    const Arc arc = arcOf(curve.p0, step);
    const double side = step.bulge > 0.0 ? 1.0 : -1.0;
    const auto isSmooth = [&](const Vec2 &p, const Vec2 &direction) {
        const Vec2 tangent = side * perpendicular(p - arc.center) / arc.radius;
        return tangent.dot(direction) > 0.0 && std::abs(cross(tangent, direction)) <= kArcKink;
    };
    return isSmooth(curve.p0, first) && isSmooth(curve.p3, last) ? std::optional(step)
                                                                 : std::nullopt;
}

/// Where the curve crosses the line through a point square to a direction, near its middle.
double crossingOf(const CubicBezier &curve, const Vec2 &point, const Vec2 &direction)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (direction.dot(curve.at(middle) - point) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Two arcs, tangent to the curve at its ends and to each other: of the family of these the one
/// whose handles are equal.
std::optional<std::array<ArcStep, 2>> twoArcs(const CubicBezier &curve, const Vec2 &first,
                                              const Vec2 &last, double tolerance)
{
    const Vec2 chord = curve.p3 - curve.p0, sum = first + last;
    // Handles of length d: |chord − d (first + last)| = 2 d.
    const double a = 4.0 - sum.squaredNorm(), b = chord.dot(sum), c = chord.squaredNorm();
    const double root = std::sqrt(std::max(0.0, b * b + a * c));
    if (!(b + root > 0.0))
        return std::nullopt;
    const double handle = c / (b + root);
    const Vec2 q = curve.p0 + handle * first, r = curve.p3 - handle * last;
    const Vec2 joint = 0.5 * (q + r), direction = directionOf(r - q);
    const std::optional<ArcStep> one = arcFrom(curve.p0, first, joint),
                                 back = arcFrom(curve.p3, -last, joint);
    if (!one || !back)
        return std::nullopt;
    const std::array<ArcStep, 2> steps = {*one, ArcStep{curve.p3, -back->bulge}};
    const double t = crossingOf(curve, joint, direction);
    const std::array<CubicBezier, 2> halves = {curve.piece(0.0, t), curve.piece(t, 1.0)};
    const std::array<Vec2, 2> starts = {curve.p0, joint};
    for (const std::size_t i : {0, 1}) {
        const bool follows = isFlat(starts[i], steps[i], tolerance)
                                 ? followsEdge(halves[i], tolerance)
                                 : followsCircle(halves[i], starts[i], steps[i], tolerance);
        if (!follows)
            return std::nullopt;
    }
    return steps;
}

void addStep(const Vec2 &start, ArcStep step, double tolerance, std::vector<ArcStep> &steps)
{
    if (step.end == start)
        return;
    if (isFlat(start, step, tolerance))
        step.bulge = 0.0;
    steps.push_back(step);
}

void fitArcs(const CubicBezier &curve, double tolerance, int halvings, std::vector<ArcStep> &steps)
{
    if (halvings == 0 || isAPoint(curve, tolerance) || followsEdge(curve, tolerance))
        return addStep(curve.p0, {curve.p3, 0.0}, tolerance, steps);
    // What an arc that is written as an edge is off by comes on top.
    const double most = (1.0 - kFlatArc) * tolerance;
    const Vec2 first = leavingWay(curve), last = arrivingWay(curve);
    if (const std::optional<ArcStep> arc = oneArc(curve, first, last, most))
        return addStep(curve.p0, *arc, tolerance, steps);
    if (const auto arcs = twoArcs(curve, first, last, most)) {
        addStep(curve.p0, (*arcs)[0], tolerance, steps);
        return addStep((*arcs)[0].end, (*arcs)[1], tolerance, steps);
    }
    fitArcs(curve.piece(0.0, 0.5), tolerance, halvings - 1, steps);
    fitArcs(curve.piece(0.5, 1.0), tolerance, halvings - 1, steps);
}

/// Takes out steps that have no length in what is written; those before them reach as far.
void dropDust(ArcPath &path)
{
    std::vector<ArcStep> kept;
    Vec2 at = path.start;
    for (const ArcStep &step : path.steps) {
        if ((step.end - at).cwiseAbs().maxCoeff() > kLeastStep)
            kept.push_back(step);
        else if (!kept.empty())
            kept.back().end = step.end;
        else
            continue;
        at = step.end;
    }
    path.steps = std::move(kept);
}

} // namespace

void appendArcs(const CubicBezier &curve, double tolerance, std::vector<ArcStep> &steps)
{
    fitArcs(curve, tolerance, kMostArcHalvings, steps);
}

ArcPath arcsAlong(std::span<const CubicBezier> curves, bool isClosed, double tolerance)
{
    ArcPath path;
    path.isClosed = isClosed;
    if (curves.empty())
        return path;
    path.start = curves.front().p0;
    for (const CubicBezier &curve : curves)
        appendArcs(curve, tolerance, path.steps);
    dropDust(path);
    return path;
}

} // namespace fff
