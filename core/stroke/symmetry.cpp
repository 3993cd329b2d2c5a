#include "core/stroke/symmetry.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/closed_line.h"
#include "core/geometry/fit.h"
#include "core/geometry/halfplane_clip.h"
#include "core/stroke/closed_fit.h"
#include "core/stroke/line_ends.h"
#include "core/stroke/settled_half.h"
#include "core/stroke/waists.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace fff {

namespace {

/// A stroke that meets the axis at less than this is a tip: mirrored, it turns by a right angle or
/// more there. Radians.
constexpr double kTipAngle = std::numbers::pi / 4.0;
/// An end that heads for the axis at less than this will not reach it soon: it gets a join, no tip.
constexpr double kLeastTipAngle = 0.17;
/// Ends nearer to each other than this part of the stroke's largest distance close it.
constexpr double kClosingGap = 0.15;
/// A join lands no further along the axis than so many times its height: an end that heads away
/// from the axis would make it endless.
constexpr double kLongestJoin = 2.0;
/// Reaches along the axis by which a half that runs beside it is longer than where it crosses.
constexpr double kAlongAxis = 4.0;
/// Samples of the stroke that are looked at for the next point of a half.
constexpr std::size_t kStrangers = 3;
/// A closed stroke is opened where it is within so many times its least distance from the axis.
constexpr double kNeckHeight = 2.0;

using Line = std::vector<Vec2>;

/// u along the axis, v away from it to the side that is mirrored. An isometry.
class AxisFrame
{
public:
    AxisFrame(const MirrorAxis &axis, bool isLeft)
        : m_axis(axis),
          m_up(isLeft ? perpendicular(axis.direction) : Vec2(-perpendicular(axis.direction)))
    {
    }

    Vec2 toLocal(const Vec2 &p) const
    {
        return {m_axis.direction.dot(p - m_axis.point), m_up.dot(p - m_axis.point)};
    }
    Vec2 toCanvas(const Vec2 &p) const
    {
        return m_axis.point + p.x() * m_axis.direction + p.y() * m_up;
    }
    CubicBezier toCanvas(const CubicBezier &s) const
    {
        return {toCanvas(s.p0), toCanvas(s.p1), toCanvas(s.p2), toCanvas(s.p3)};
    }
    CubicBezier toLocal(const CubicBezier &s) const
    {
        return {toLocal(s.p0), toLocal(s.p1), toLocal(s.p2), toLocal(s.p3)};
    }
    std::vector<CubicBezier> toCanvas(const std::vector<CubicBezier> &chain) const
    {
        std::vector<CubicBezier> result;
        for (const CubicBezier &segment : chain)
            result.push_back(toCanvas(segment));
        return result;
    }

private:
    MirrorAxis m_axis;
    Vec2 m_up;
};

Vec2 acrossAxis(const Vec2 &local)
{
    return {local.x(), -local.y()};
}

std::vector<CubicBezier> acrossAxis(const std::vector<CubicBezier> &chain)
{
    std::vector<CubicBezier> result;
    for (auto s = chain.rbegin(); s != chain.rend(); ++s)
        result.push_back(
            {acrossAxis(s->p3), acrossAxis(s->p2), acrossAxis(s->p1), acrossAxis(s->p0)});
    return result;
}

bool isUsable(const Vec2 &sample)
{
    return sample.allFinite() && sample.cwiseAbs().maxCoeff() <= kMaxCoordinate;
}

/// What the line encloses with the axis, lines from its ends straight down to it. mm².
double areaOverAxis(const Line &line)
{
    double area = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        area += 0.5 * (line[i].y() + line[i + 1].y()) * (line[i].x() - line[i + 1].x());
    return std::abs(area);
}

/// The runs of a line over the axis. Where it crosses, they start and end at v = 0 exactly.
std::vector<Line> runsOverAxis(const Line &line)
{
    std::vector<Line> runs;
    bool isRunning = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool isOver = line[i].y() > 0.0;
        if (isOver != isRunning && i > 0) {
            const Vec2 &a = line[i - 1], &b = line[i];
            const double share = a.y() / (a.y() - b.y());
            const Vec2 crossing(a.x() + share * (b.x() - a.x()), 0.0);
            if (isOver)
                runs.push_back({crossing});
            else
                runs.back().push_back(crossing);
        } else if (isOver && i == 0) {
            runs.emplace_back();
        }
        if (isOver)
            runs.back().push_back(line[i]);
        isRunning = isOver;
    }
    return runs;
}

/// A closed line from its first to its last point along the axis that lies within `band` of it, the
/// way that encloses more.
Line openedAtAxis(const Line &line, double band)
{
    std::optional<std::size_t> first, last;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i].y() > band)
            continue;
        if (!first || line[i].x() < line[*first].x())
            first = i;
        if (!last || line[i].x() > line[*last].x())
            last = i;
    }
    const auto way = [&](std::size_t from, std::size_t to) {
        Line result;
        for (std::size_t i = from; i != to; i = (i + 1) % line.size())
            result.push_back(line[i]);
        result.push_back(line[to]);
        return result;
    };
    Line one = way(*first, *last), two = way(*last, *first);
    return areaOverAxis(one) >= areaOverAxis(two) ? one : two;
}

/// Distance of its ends along the axis.
double extentAlong(const Line &line)
{
    return std::abs(line.front().x() - line.back().x());
}

/// One of the ends of a lies further out along the axis than both of b's, by more than `by`.
bool isWider(const Line &a, const Line &b, double by)
{
    const auto [lowA, highA] = std::minmax(a.front().x(), a.back().x());
    const auto [lowB, highB] = std::minmax(b.front().x(), b.back().x());
    return lowA < lowB - by || highA > highB + by;
}

/// Of a stroke's length, how much a hand curls on beside the axis at an end.
constexpr double kMostCurl = 0.12;

/// The point of the last stretch that is nearest to the axis, if that is within `reach` of it and
/// the end is not any more: what comes after it is a curl of the hand. Else the last one.
std::size_t withoutCurlAtEnd(const Line &line, double reach)
{
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        length += (line[i + 1] - line[i]).norm();
    const std::size_t last = line.size() - 1;
    std::size_t lowest = last;
    double way = 0.0;
    for (std::size_t i = last; i > 0 && way <= kMostCurl * length; --i) {
        if (line[i].y() < line[lowest].y())
            lowest = i;
        way += (line[i] - line[i - 1]).norm();
    }
    const bool isCurl = line[lowest].y() <= reach && line[last].y() > reach;
    return isCurl ? lowest : last;
}

/// A half over the axis without what is curled at its ends.
Line withoutCurls(Line line, double reach)
{
    for (int end = 0; end < 2; ++end) {
        line.resize(withoutCurlAtEnd(line, reach) + 1);
        std::reverse(line.begin(), line.end());
    }
    return line;
}

/// The part of the stroke that is the half, in local coordinates.
struct HalfLine
{
    Line line;
    bool wasCut = false;
};

HalfLine halfLine(Line line, double tolerance, double largest)
{
    const double reach = FitOptions().reach * tolerance;
    // Ends that lie nearer to the axis than to each other are meant to meet that.
    const double gap = (line.front() - line.back()).norm();
    const bool isBesideAxis = gap < std::max(line.front().y(), line.back().y());
    const bool isClosed = gap <= reach || (gap <= kClosingGap * largest && isBesideAxis);
    if (isClosed) {
        const auto under =
            std::find_if(line.begin(), line.end(), [](const Vec2 &p) { return p.y() <= 0.0; });
        const auto lowest = std::min_element(
            line.begin(), line.end(), [](const Vec2 &a, const Vec2 &b) { return a.y() < b.y(); });
        if (under == line.end() && line.size() > 2)
            return {openedAtAxis(line, std::max(reach, kNeckHeight * lowest->y())), false};
        // So that no run is cut apart where the stroke began.
        std::rotate(line.begin(), under, line.end());
        line.push_back(line.front());
    }
    const std::vector<Line> runs = runsOverAxis(withWaists(std::move(line), tolerance, largest));
    const auto best = std::max_element(runs.begin(), runs.end(), [](const Line &a, const Line &b) {
        return areaOverAxis(a) < areaOverAxis(b);
    });
    double dropped = -areaOverAxis(*best);
    for (const Line &run : runs)
        dropped += areaOverAxis(run);
    HalfLine half{isClosed ? *best : withoutCurls(*best, reach), dropped > tolerance * largest};
    if (std::max(half.line.front().y(), half.line.back().y()) <= reach) {
        Line opened = openedAtAxis(half.line, reach);
        if (isWider(opened, half.line, kAlongAxis * reach) ||
            extentAlong(half.line) < 2.0 * tolerance)
            half.line = std::move(opened);
    }
    return half;
}

/// Without hooks after which its ends are further from the axis than before.
Line withoutHooksAtAxis(const Line &line, double tolerance)
{
    const WithoutHooks kept = withoutHooks(line, tolerance);
    const auto height = [&](std::size_t i) { return std::abs(line[i].y()); };
    const std::size_t last = line.size() - 1;
    const std::size_t from = height(kept.from) < height(0) ? kept.from : 0;
    const std::size_t to = height(kept.to) < height(last) ? kept.to : last;
    const auto at = [&](std::size_t i) { return line.begin() + static_cast<std::ptrdiff_t>(i); };
    return from < to ? Line(at(from), at(to + 1)) : line;
}

/// Where the line goes from its first point, over a reach. Unit, zero for a point.
Vec2 directionOver(std::span<const Vec2> line, double reach)
{
    Vec2 way = Vec2::Zero();
    for (const Vec2 &p : line) {
        way = p - line.front();
        if (way.norm() >= reach)
            break;
    }
    return way.norm() > kClipGrid ? Vec2(way.normalized()) : Vec2::Zero();
}

/// Prepares the line's first point for the fit: a tip that stops short is drawn out to the axis.
/// The direction that the fit has to start in, if any. Backwards for the line's end.
std::optional<Vec2> prepareStart(Line &line, double reach)
{
    const Vec2 way = directionOver(line, reach);
    const double angle = std::asin(std::clamp(way.y(), -1.0, 1.0)); // between axis and line
    const double height = line.front().y();
    if (height > 0.0) {
        if (height <= reach && angle >= kLeastTipAngle && angle < kTipAngle)
            line.insert(line.begin(), {line.front().x() - height / way.y() * way.x(), 0.0});
        return {};
    }
    if (angle < kTipAngle)
        return {};
    return Vec2(Vec2::UnitY());
}

/// Of how far the half reaches from the axis, so far at most a join goes on along that: who stops
/// farther away did not mean the rest of a circle.
constexpr double kMostGoingOn = 0.35;

/// From an end of the half that lies off the axis on to it, the way that `heading` (unit) goes.
/// largest: how far the half reaches from the axis
CubicBezier joinToAxis(const Vec2 &end, const Vec2 &heading, double largest)
{
    // A circle whose centre is on the axis, through the end and tangent to the heading, falls by
    // `sine` there and meets the axis after turning until it falls straight.
    const double sine = std::clamp(-heading.y(), -1.0, 1.0);
    const double cosine = std::sqrt(1.0 - sine * sine);
    const double wanted = std::min(end.y() * kLongestJoin, end.y() * (1.0 - sine) / cosine);
    const double most = kMostGoingOn * largest, along = std::min(wanted, most);
    const double sign = heading.x() < 0.0 ? -1.0 : 1.0;
    // Straight down, the quotient is 0 / 0.
    const Vec2 foot(end.x() + (cosine > kSameDirection ? sign * along : 0.0), 0.0);
    const double turn = std::numbers::pi / 2.0 - std::asin(sine);
    const double handle = (foot - end).norm() / (3.0 * std::pow(std::cos(turn / 4.0), 2.0));
    const double leaving = wanted > most ? std::min(handle, most) : handle;
    return {end, end + leaving * heading, foot + handle * Vec2::UnitY(), foot};
}

/// The chain, or the boundary of the largest loop that it makes with the axis. Empty when too
/// little of that is on the axis.
std::vector<CubicBezier> withoutCrossings(const std::vector<CubicBezier> &chain,
                                          double leastContact, bool &wasCrossing)
{
    const Halfplane over;
    std::vector<CubicBezier> closed = chain;
    closed.push_back(CubicBezier::line(chain.back().p3, chain.front().p0));
    const Result<Contour> contour = Contour::fromSegments(closed);
    if (!contour)
        return {};
    const Result<ResolvedContour> resolved = resolveCrossings(*contour);
    if (!resolved)
        return {};
    if (!resolved->wasCrossing && isInside(resolved->contour, over)) {
        if (std::abs(chain.front().p0.x() - chain.back().p3.x()) < leastContact)
            return {};
        return chain;
    }
    wasCrossing = resolved->wasCrossing;
    const Result<std::vector<ClippedPiece>> pieces = clip(resolved->contour, {}, over);
    if (!pieces || pieces->empty())
        return {};
    Contour outer = pieces->front().outer;
    if (outer.signedArea() < 0.0)
        outer = outer.reversed();
    std::optional<int> first, last; // segments that start on the axis, by u
    const auto u = [&](int i) { return outer.segment(i).p0.x(); };
    for (int i = 0; i < outer.segmentCount(); ++i) {
        if (std::abs(outer.segment(i).p0.y()) > kClipSlack)
            continue;
        if (!first || u(i) < u(*first))
            first = i;
        if (!last || u(i) > u(*last))
            last = i;
    }
    if (!first || u(*last) - u(*first) < leastContact)
        return {};
    // Counter-clockwise, the way from the last to the first goes over everything.
    std::vector<CubicBezier> outline;
    for (int i = *last; i != *first; i = (i + 1) % outer.segmentCount())
        outline.push_back(outer.segment(i));
    outline.front().p0.y() = 0.0;
    outline.back().p3.y() = 0.0;
    return outline;
}

/// What of the settled pieces is part of the half, in its coordinates and by its points: those
/// whose samples all are, one after the other, away from the half's ends.
std::vector<FittedPiece> settledIn(const Line &half, const Line &samples, const AxisFrame &frame,
                                   const std::vector<FittedPiece> &settled, double atEnds)
{
    std::vector<FittedPiece> pieces;
    if (settled.empty())
        return pieces;
    // The half goes the stroke's way; its samples are the very same, with others between runs.
    constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> placeOf(samples.size(), kNowhere);
    std::size_t next = 0;
    bool isFound = false;
    for (std::size_t k = 0; k < half.size(); ++k) {
        const std::size_t most = isFound ? kStrangers : samples.size();
        std::size_t i = next, passed = 0;
        for (; passed < most && samples[i] != half[k]; ++passed)
            i = i + 1 < samples.size() ? i + 1 : 0;
        if (passed == most)
            continue; // a place on the axis
        isFound = true;
        placeOf[i] = k;
        next = i + 1 < samples.size() ? i + 1 : 0;
    }
    for (const FittedPiece &piece : settled) {
        const std::size_t from = placeOf[piece.from], to = placeOf[piece.to];
        if (from == kNowhere || to == kNowhere || from + piece.to != to + piece.from ||
            piece.isStartBetween)
            continue;
        pieces.push_back(piece);
        pieces.back().from = from;
        pieces.back().to = to;
        pieces.back().curve = frame.toLocal(piece.curve);
    }
    std::sort(pieces.begin(), pieces.end(),
              [](const FittedPiece &a, const FittedPiece &b) { return a.from < b.from; });
    const PieceRange kept = awayFromEnds(pieces, atEnds);
    const auto at = [&](std::size_t k) { return pieces.begin() + static_cast<std::ptrdiff_t>(k); };
    return kept.isEmpty() ? std::vector<FittedPiece>()
                          : std::vector<FittedPiece>(at(kept.begin), at(kept.end));
}

} // namespace

std::optional<MirroredHalf> mirroredHalf(const std::vector<Vec2> &samples, const MirrorAxis &axis,
                                         const SymmetryVerdict &verdict, double tolerance)
{
    return mirroredHalf(samples, axis, verdict, tolerance, {}, nullptr);
}

std::optional<MirroredHalf> mirroredHalf(const std::vector<Vec2> &samples, const MirrorAxis &axis,
                                         const SymmetryVerdict &verdict, double tolerance,
                                         const std::vector<FittedPiece> &settled, std::size_t *work)
{
    const AxisFrame frame(axis, verdict.isLeft());
    Line line;
    for (const Vec2 &p : samples) {
        if (!isUsable(p))
            continue;
        line.push_back(frame.toLocal(p));
        if (std::abs(line.back().y()) <= kClipGrid)
            line.back().y() = 0.0; // meant to be on it: no join of a few nanometres
    }
    const double largest = std::max(verdict.left, verdict.right);
    if (line.size() < 2 || !(largest > kClipGrid))
        return {};
    // At first, what is over the axis may be no more than a hook.
    const auto isOver = [](const Vec2 &p) { return p.y() > 0.0; };
    const Line kept = withoutHooksAtAxis(line, tolerance);
    if (std::none_of(kept.begin(), kept.end(), isOver))
        return {};
    HalfLine half = halfLine(kept, tolerance, largest);

    FitOptions options;
    options.tolerance = tolerance;
    options.work = work;
    const double reach = options.reach * tolerance;
    options.startDirection = prepareStart(half.line, reach);
    std::reverse(half.line.begin(), half.line.end());
    if (prepareStart(half.line, reach))
        options.endDirection = -Vec2::UnitY();
    std::reverse(half.line.begin(), half.line.end());

    const std::vector<FittedPiece> known =
        settledIn(half.line, line, frame, settled, kEndReaches * reach);
    std::vector<CubicBezier> fitted = fitAround(half.line, known, options);
    if (fitted.empty())
        return {};
    // What looked like a tip over the reach may turn towards the axis at the very end.
    const auto isBlunt = [](const Vec2 &p, const Vec2 &direction) {
        return p.y() == 0.0 && std::abs(direction.y()) >= std::sin(kTipAngle);
    };
    const bool isStartBlunt =
        !options.startDirection && isBlunt(fitted.front().p0, startDirection(fitted.front()));
    const bool isEndBlunt =
        !options.endDirection && isBlunt(fitted.back().p3, endDirection(fitted.back()));
    if (isStartBlunt)
        options.startDirection = Vec2::UnitY();
    if (isEndBlunt)
        options.endDirection = -Vec2::UnitY();
    if (isStartBlunt || isEndBlunt)
        fitted = fitAround(half.line, known, options);
    MirroredHalf result;
    std::vector<CubicBezier> chain;
    if (fitted.front().p0.y() > 0.0) {
        chain.push_back(
            joinToAxis(fitted.front().p0, -startDirection(fitted.front()), largest).reversed());
        result.opening = frame.toCanvas(chain.front());
    }
    chain.insert(chain.end(), fitted.begin(), fitted.end());
    if (fitted.back().p3.y() > 0.0) {
        chain.push_back(joinToAxis(fitted.back().p3, endDirection(fitted.back()), largest));
        result.closing = frame.toCanvas(chain.back());
    }
    const std::vector<CubicBezier> outline =
        withoutCrossings(chain, 2.0 * tolerance, result.wasCrossing);
    if (outline.empty())
        return {};
    result.fitted = frame.toCanvas(fitted);
    result.outline = frame.toCanvas(outline);
    result.mirrored = frame.toCanvas(acrossAxis(outline));
    result.wasCut = half.wasCut;
    return result;
}

} // namespace fff
