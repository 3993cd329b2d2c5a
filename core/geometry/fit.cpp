#include "core/geometry/fit.h"

#include "core/base/tolerances.h"
#include "core/geometry/chain_fitter.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// The closing piece's handles are halved so often at most to take a loop out of it.
constexpr int kHandleHalvings = 8;
/// What an open end points at is within this angle of its direction, and what it meets there at a
/// corner turns by at least that; radians.
constexpr double kPointsAt = 0.26, kClosingCorner = 0.79;
/// Directions at a joint that differ by less, in radians, are one: corners turn by far more.
constexpr double kSameDirectionOfJoints = 1e-6;
/// Of the angle that makes a corner, what directions that meet have to turn by to be one.
constexpr double kLeastCorner = 0.7;
/// A closed line is continued by so many reaches at both ends, so that it is judged as without any.
constexpr double kOverlap = 8.0;

/// Whether the cubic a t³ + b t² + c t + p0 passes a point twice: a (t² + ts + s²) + b (t + s) + c
/// = 0 for two parameters s < t within 0 … 1. Two linear equations give t + s and t² + ts + s².
bool crossesItself(const CubicBezier &curve)
{
    const Vec2 a = curve.p3 - 3.0 * curve.p2 + 3.0 * curve.p1 - curve.p0;
    const Vec2 b = 3.0 * (curve.p2 - 2.0 * curve.p1 + curve.p0);
    const Vec2 c = 3.0 * (curve.p1 - curve.p0);
    const double determinant = cross(a, b);
    const double sum = -cross(a, c) / determinant;
    const double squares = cross(b, c) / determinant;
    const double product = sum * sum - squares;
    const double discriminant = sum * sum - 4.0 * product;
    // False as well for the infinities of a vanishing determinant: a parabola does not cross
    // itself.
    return discriminant > 0.0 && sum - std::sqrt(discriminant) >= 0.0 &&
           sum + std::sqrt(discriminant) <= 2.0;
}

/// Direction of the first of `points` that is away from `from`.
Vec2 directionTo(const Vec2 &from, std::initializer_list<Vec2> points)
{
    for (const Vec2 &p : points) {
        const double distance = (p - from).norm();
        if (distance > 0.0)
            return (p - from) / distance;
    }
    return Vec2::Zero();
}

/// The samples of a line in one direction round, the first not repeated, from one of them on.
std::vector<Vec2> rotated(const std::vector<Vec2> &loop, std::size_t first)
{
    std::vector<Vec2> result(loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
    result.insert(result.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first));
    return result;
}

/// Samples of the loop, from its end backwards or from its start on, over a length.
std::vector<Vec2> overlap(const std::vector<Vec2> &loop, double length, bool isAtEnd)
{
    std::vector<Vec2> result;
    double covered = 0.0;
    for (std::size_t i = 0; i < loop.size() && covered < length; ++i) {
        const Vec2 &p = isAtEnd ? loop[loop.size() - 1 - i] : loop[i];
        if (!result.empty())
            covered += (p - result.back()).norm();
        result.push_back(p);
    }
    if (isAtEnd)
        std::reverse(result.begin(), result.end());
    return result;
}

/// A closed line with no beginning: once round, and as much before and after it as is looked at
/// anywhere.
class Round
{
public:
    Round(const std::vector<Vec2> &loop, const FitOptions &options)
        : Round(overlap(loop, kOverlap * options.reach * options.tolerance, true), loop,
                overlap(loop, kOverlap * options.reach * options.tolerance, false), options)
    {
    }

    /// The samples are still those that were given.
    bool isPlain() const { return m_isPlain; }
    /// Samples of the loop.
    std::optional<std::size_t> firstCorner(double angle) const
    {
        for (const std::size_t corner : m_line.corners(angle)) {
            if (corner >= m_from && corner < m_to)
                return m_line.drawnBefore(corner) - m_line.drawnBefore(m_from);
        }
        return {};
    }
    std::optional<std::size_t> firstStraight() const
    {
        for (const StraightRun &run : m_line.straightRuns(0, m_line.size() - 1)) {
            if (run.from >= m_from && run.from < m_to)
                return m_line.drawnBefore(run.from) - m_line.drawnBefore(m_from);
        }
        return {};
    }
    /// Smooth all round.
    std::vector<CubicBezier> fit(const FitOptions &options) const
    {
        std::size_t from = m_from, to = m_to;
        CurveEnd joint = m_line.smoothJoint(m_from, 0, m_line.size() - 1);
        // Up to the next sample there are those that fill the gap.
        for (const StraightRun &run : m_line.straightRuns(0, m_line.size() - 1)) {
            if (run.from < m_from || m_line.drawnBefore(run.from) != m_line.drawnBefore(m_from))
                continue;
            to += run.from - from;
            from = run.from;
            joint = run.start;
        }
        ChainFitter fitter(m_line, options.tolerance, options.reach * options.tolerance,
                           kLeastCorner * options.cornerAngle);
        ChainFitter::Stretch stretch{from, to, joint, joint, 0, m_line.size() - 1};
        stretch.isStartGiven = stretch.isEndGiven = true;
        fitter.fit(stretch);
        if (options.work)
            *options.work += m_line.size() + fitter.samplesLookedAt();
        return fitter.takeChain();
    }

private:
    Round(const std::vector<Vec2> &before, const std::vector<Vec2> &loop,
          const std::vector<Vec2> &after, const FitOptions &options)
        : m_line(joined(before, loop, after), options.tolerance, options.reach * options.tolerance),
          m_isPlain(m_line.drawnCount() == before.size() + loop.size() + after.size())
    {
        if (!m_isPlain)
            return;
        m_from = m_line.indexOfDrawn(before.size());
        m_to = m_line.indexOfDrawn(before.size() + loop.size());
    }

    static std::vector<Vec2> joined(std::vector<Vec2> before, const std::vector<Vec2> &loop,
                                    const std::vector<Vec2> &after)
    {
        before.insert(before.end(), loop.begin(), loop.end());
        before.insert(before.end(), after.begin(), after.end());
        return before;
    }

    SampledLine m_line;
    bool m_isPlain;
    std::size_t m_from = 0, m_to = 0; // once round
};

} // namespace

namespace {

std::vector<ChainFitter::Link> fitLinks(const SampledLine &line, const FitOptions &options)
{
    if (line.size() < 2)
        return {};
    std::vector<std::size_t> stops = line.corners(options.cornerAngle);
    stops.insert(stops.begin(), 0);
    stops.push_back(line.size() - 1);
    const double leastCorner = kLeastCorner * options.cornerAngle;
    ChainFitter fitter(line, options.tolerance, options.reach * options.tolerance, leastCorner);
    std::vector<ChainFitter::Stretch> stretches;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const std::size_t from = stops[i], to = stops[i + 1];
        stretches.push_back(
            {from, to, line.startJoint(from, to), line.endJoint(from, to), from, to});
        if (i > 0)
            ChainFitter::smoothen(stretches[i - 1], stretches[i], leastCorner);
    }
    if (options.startDirection) {
        stretches.front().start.direction = *options.startDirection;
        stretches.front().isStartGiven = true;
    }
    if (options.endDirection) {
        stretches.back().end.direction = *options.endDirection;
        stretches.back().isEndGiven = true;
    }
    for (const ChainFitter::Stretch &stretch : stretches)
        fitter.fit(stretch);
    if (options.work)
        *options.work += line.size() + fitter.samplesLookedAt();
    return fitter.takeLinks();
}

} // namespace

std::vector<CubicBezier> fitCurve(const std::vector<Vec2> &samples, const FitOptions &options)
{
    const SampledLine line(samples, options.tolerance, options.reach * options.tolerance);
    std::vector<CubicBezier> chain;
    for (const ChainFitter::Link &link : fitLinks(line, options))
        chain.push_back(link.curve);
    return chain;
}

std::vector<FittedPiece> fitPieces(const std::vector<Vec2> &samples, const FitOptions &options)
{
    const SampledLine line(samples, options.tolerance, options.reach * options.tolerance);
    std::vector<FittedPiece> pieces;
    for (const ChainFitter::Link &link : fitLinks(line, options)) {
        const std::size_t from = line.drawnBefore(link.from), to = line.drawnBefore(link.to);
        pieces.push_back({link.curve, from, to});
        pieces.back().isStartBetween = line.indexOfDrawn(from) != link.from;
    }
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        pieces[i].isEndSmooth = pieces[i + 1].isStartSmooth =
            turnBetween(endDirection(pieces[i].curve), startDirection(pieces[i + 1].curve)) <
            kSameDirectionOfJoints;
    return pieces;
}

std::vector<CubicBezier> fitClosedCurve(const std::vector<Vec2> &samples, const FitOptions &options)
{
    std::vector<Vec2> loop = SampledLine::usable(samples);
    while (loop.size() > 1 && (loop.back() - loop.front()).norm() <= kClipGrid)
        loop.pop_back();
    if (loop.size() < 3)
        return fitCurve(samples, options);
    Round round(loop, options);
    if (!round.isPlain())
        return fitCurve(samples, options); // it runs over itself: there is no one way round
    if (const auto corner = round.firstCorner(options.cornerAngle)) {
        std::vector<Vec2> opened = rotated(loop, *corner);
        opened.push_back(opened.front());
        FitOptions plain = options;
        plain.startDirection = plain.endDirection = {};
        return fitCurve(opened, plain);
    }
    // A line is not to be cut in two where the pen happened to begin.
    if (const auto start = round.firstStraight())
        round = Round(rotated(loop, *start), options);
    return round.fit(options);
}

CubicBezier closingSegment(const std::vector<CubicBezier> &chain)
{
    const Vec2 &from = chain.back().p3, &to = chain.front().p0;
    const Vec2 out = endDirection(chain.back()), in = startDirection(chain.front());
    const double leaving = turnBetween(out, to - from), coming = turnBetween(in, to - from);
    if (std::min(leaving, coming) <= kPointsAt && std::max(leaving, coming) >= kClosingCorner)
        return CubicBezier::line(from, to);
    double handle = (to - from).norm() / 3.0;
    CubicBezier closing{from, from + handle * out, to - handle * in, to};
    for (int i = 0; i < kHandleHalvings && crossesItself(closing); ++i) {
        handle *= 0.5;
        closing = {from, from + handle * out, to - handle * in, to};
    }
    return closing;
}

Vec2 startDirection(const CubicBezier &s)
{
    return directionTo(s.p0, {s.p1, s.p2, s.p3});
}

Vec2 endDirection(const CubicBezier &s)
{
    return -directionTo(s.p3, {s.p2, s.p1, s.p0});
}

} // namespace fff
