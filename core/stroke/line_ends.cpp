#include "core/stroke/line_ends.h"

#include "core/base/tolerances.h"
#include "core/geometry/sampled_line.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff {

namespace {

/// Lengths in tolerances: of the line from which on its ends are looked at, of a hook, of the ways
/// by which its turn is judged, and of what says where an end points.
constexpr double kLeastLength = 12.0, kLongestHook = 40.0, kHookWay = 4.0, kWay = 12.0,
                 kLeastWay = 3.0;
/// Radians by which a hook turns back, at least.
constexpr double kHookTurn = 1.7;
/// Tolerances that it is long at least: less is a tremble.
constexpr double kLeastHook = 1.0;
/// Of the line's length, what is cut off, or comes between the ends, at most.
constexpr double kMostCut = 0.25;
/// Tolerances, and part of the length: ends that are further apart than both are open on purpose.
constexpr double kFarApart = 40.0, kFarApartShare = 0.2;
/// A mm less of a gap is worth so many mm of line.
constexpr double kWorth = 0.1;
/// An end that points at the other within this angle goes on there, radians.
constexpr double kPointsAt = 0.26;
/// Corners: the least turn between ends, that which needs no straight ends, and how much of it
/// their bends may account for. What they may bend over kWay to be straight, radians.
constexpr double kCornerTurn = 0.6, kSharpTurn = 1.2, kBent = 0.22, kStraight = 0.35;
/// How far ends are led on to a corner: in gaps, and in tolerances besides.
constexpr double kLedGaps = 1.6, kLedOn = 8.0;
/// Ends that are within so many tolerances, and turn by less, closedLine() joins as they are.
constexpr double kBeside = 3.5, kSmoothTurn = 0.25;
/// Radians between where ends point and where they have to go, from which on it is a notch.
constexpr double kNotch = 0.5;
/// Steps in tolerances by which ends are cut back until it is none, and part of the length in all.
constexpr double kStepBack = 3.0, kMostBack = 0.1;
/// And no more tolerances, and times what they are beside each other.
constexpr double kBackAnyway = 10.0, kBackBeside = 4.0;
/// Tolerances within which ends are in one place.
constexpr double kTogether = 0.25;
constexpr std::size_t kRun = 24; // edges that have a box in common

/// Samples with how far along the line each is.
class Way
{
public:
    explicit Way(const std::vector<Vec2> &points) : m_points(points), m_along(points.size(), 0.0)
    {
        for (std::size_t i = 1; i < points.size(); ++i)
            m_along[i] = m_along[i - 1] + (points[i] - points[i - 1]).norm();
    }

    double length() const { return m_along.back(); }
    double along(std::size_t i) const { return m_along[i]; }
    const Vec2 &point(std::size_t i) const { return m_points[i]; }
    std::size_t size() const { return m_points.size(); }
    /// The edge that it lies on.
    std::size_t edgeAt(double s) const
    {
        const auto after = std::upper_bound(m_along.begin(), m_along.end(), s);
        const auto i = static_cast<std::size_t>(after - m_along.begin());
        return std::min(i > 0 ? i - 1 : 0, size() - 2);
    }
    Vec2 at(double s) const
    {
        const std::size_t i = edgeAt(s);
        const double edge = m_along[i + 1] - m_along[i];
        const double share = edge > 0.0 ? std::clamp((s - m_along[i]) / edge, 0.0, 1.0) : 0.0;
        return m_points[i] + share * (m_points[i + 1] - m_points[i]);
    }

private:
    const std::vector<Vec2> &m_points;
    std::vector<double> m_along; // mm
};

/// What of the way is kept, by lengths along it.
struct Kept
{
    double from = 0.0, to = 0.0;
    double length() const { return to - from; }
};

/// Where the line points at one of its ends, outwards at the last and inwards at the first; and by
/// how much it bends over a mm, to the left.
struct Pointing
{
    Vec2 way = Vec2::UnitX();
    double bend = 0.0;
};

double signedTurn(const Vec2 &a, const Vec2 &b)
{
    return std::atan2(cross(a, b), a.dot(b));
}

Vec2 turnedBy(const Vec2 &way, double angle)
{
    return std::cos(angle) * way + std::sin(angle) * perpendicular(way);
}

/// Of the circle through the end and two places before it.
Pointing pointingAt(const Way &way, const Kept &kept, bool isEnd, double tolerance)
{
    const double sign = isEnd ? -1.0 : 1.0, end = isEnd ? kept.to : kept.from;
    Pointing result;
    for (double over = std::min(kWay * tolerance, 0.2 * kept.length());;
         over = std::max(0.5 * over, kLeastWay * tolerance)) {
        const Vec2 last = way.at(end), middle = way.at(end + sign * 0.5 * over),
                   first = way.at(end + sign * over);
        const Vec2 near = sign * (middle - last), far = sign * (first - middle);
        if (near.norm() <= kClipGrid || far.norm() <= kClipGrid)
            return result;
        const double turn = isEnd ? signedTurn(far, near) : signedTurn(near, far);
        result.way = turnedBy(near.normalized(), (isEnd ? 0.5 : -0.5) * turn);
        result.bend = turn / (0.5 * over);
        // A corner so near to the end says nothing about it.
        if (std::abs(turn) < kCornerTurn || over <= kLeastWay * tolerance)
            return result;
    }
}

/// Boxes of runs of edges within a stretch of the way.
struct EdgeRun
{
    std::size_t first = 0, end = 0;
    Box2 box;
};

std::vector<EdgeRun> runsWithin(const Way &way, double from, double to)
{
    std::vector<EdgeRun> runs;
    for (std::size_t i = way.edgeAt(from), last = way.edgeAt(to); i <= last; i += kRun) {
        EdgeRun run{i, std::min(i + kRun, last + 1), {}};
        for (std::size_t k = run.first; k <= run.end; ++k)
            run.box.extend(way.point(k));
        runs.push_back(run);
    }
    return runs;
}

/// The place within a stretch that is nearest to a point.
double nearest(const Way &way, double from, double to, const Vec2 &p, double &distance)
{
    double best = from;
    distance = (way.at(from) - p).norm();
    for (std::size_t i = way.edgeAt(from); i <= way.edgeAt(to); ++i) {
        const Vec2 edge = way.point(i + 1) - way.point(i);
        const double squared = edge.squaredNorm();
        const double share =
            squared > 0.0 ? std::clamp(edge.dot(p - way.point(i)) / squared, 0.0, 1.0) : 0.0;
        const double s =
            std::clamp(way.along(i) + share * (way.along(i + 1) - way.along(i)), from, to);
        const double here = (way.at(s) - p).norm();
        if (here < distance) {
            distance = here;
            best = s;
        }
    }
    return best;
}

/// Where the two edges cross, as parts of them. A touch does not count.
std::optional<Vec2> crossing(const Vec2 &a, const Vec2 &b, const Vec2 &c, const Vec2 &d)
{
    const Vec2 one = b - a, two = d - c;
    const double determinant = cross(one, two);
    if (std::abs(determinant) <= kParallelSine * one.norm() * two.norm())
        return {};
    const double u = cross(c - a, two) / determinant, v = cross(c - a, one) / determinant;
    if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0)
        return {};
    return Vec2(u, v);
}

/// Where the last part of the way crosses the first one, so that least is cut off.
std::optional<Kept> crossingOfEnds(const Way &way, const Kept &kept, double budget)
{
    std::optional<Kept> best;
    const auto tail = runsWithin(way, kept.to - budget, kept.to);
    for (const EdgeRun &a : runsWithin(way, kept.from, kept.from + budget)) {
        for (const EdgeRun &b : tail) {
            if (!a.box.intersects(b.box))
                continue;
            for (std::size_t i = a.first; i < a.end; ++i) {
                for (std::size_t k = std::max(b.first, i + 2); k < b.end; ++k) {
                    const auto at =
                        crossing(way.point(i), way.point(i + 1), way.point(k), way.point(k + 1));
                    if (!at)
                        continue;
                    const Kept here{way.along(i) + at->x() * (way.along(i + 1) - way.along(i)),
                                    way.along(k) + at->y() * (way.along(k + 1) - way.along(k))};
                    if (here.from < kept.from || here.to > kept.to ||
                        kept.length() - here.length() > budget)
                        continue;
                    if (!best || here.length() > best->length())
                        best = here;
                }
            }
        }
    }
    return best;
}

/// Where the line turns back near its end, that it goes back from there; none where it does not.
std::optional<double> hookAtEnd(const Way &way, const Kept &kept, double tolerance)
{
    const double longest = std::min(kLongestHook * tolerance, kMostCut * kept.length());
    const double over = kHookWay * tolerance;
    std::optional<double> base;
    double sharpest = kHookTurn;
    for (std::size_t i = way.edgeAt(kept.to) + 1; i-- > 1;) {
        const double s = way.along(i);
        if (s > kept.to || s <= kept.from)
            continue;
        if (kept.to - s > longest)
            break;
        const Vec2 before = way.point(i) - way.at(std::max(s - over, kept.from));
        const Vec2 after = way.at(std::min(s + over, kept.to)) - way.point(i);
        if (after.norm() < kLeastHook * tolerance)
            continue;
        const double turn = turnBetween(before, after);
        if (turn <= sharpest)
            continue;
        sharpest = turn;
        base = s;
    }
    return base;
}

std::optional<double> hookAtStart(const std::vector<Vec2> &points, const Way &way, const Kept &kept,
                                  double tolerance)
{
    const std::vector<Vec2> back(points.rbegin(), points.rend());
    const Way reversed(back);
    const auto base =
        hookAtEnd(reversed, {way.length() - kept.to, way.length() - kept.from}, tolerance);
    if (!base)
        return {};
    return way.length() - *base;
}

class MeetingEnds
{
public:
    MeetingEnds(const std::vector<Vec2> &points, double tolerance)
        : m_points(points), m_way(points), m_tolerance(tolerance), m_kept{0.0, m_way.length()}
    {
    }

    MeantEnds meant()
    {
        const double length = m_way.length();
        if (length >= kLeastLength * m_tolerance) {
            m_budget = kMostCut * length;
            dropHooks();
            if (gap().norm() <= std::max(kFarApart * m_tolerance, kFarApartShare * length) ||
                crossingOfEnds(m_way, m_kept, left())) {
                cutBeyond();
                if (!leadToCorner())
                    cutBack();
            }
        }
        return line();
    }

private:
    double left() const { return m_budget - (m_way.length() - m_kept.length()); }
    Vec2 start() const { return m_way.at(m_kept.from); }
    Vec2 end() const { return m_way.at(m_kept.to); }
    Vec2 gap() const { return start() - end(); }
    Pointing out() const { return pointingAt(m_way, m_kept, true, m_tolerance); }
    Pointing in() const { return pointingAt(m_way, m_kept, false, m_tolerance); }

    /// Those after which the ends are further apart than before.
    void dropHooks()
    {
        if (const auto base = hookAtEnd(m_way, m_kept, m_tolerance))
            if ((m_way.at(*base) - start()).norm() < gap().norm())
                m_kept.to = *base;
        if (const auto base = hookAtStart(m_points, m_way, m_kept, m_tolerance))
            if ((m_way.at(*base) - end()).norm() < gap().norm())
                m_kept.from = *base;
    }

    /// What lies beyond where the ends cross, or come nearest to each other.
    void cutBeyond()
    {
        const double apart = gap().norm();
        if (left() <= 0.0 || apart <= kTogether * m_tolerance)
            return;
        const Vec2 towards = gap() / apart;
        Kept best = m_kept;
        double leastCost = apart;
        const auto consider = [&](const Kept &kept, double distance) {
            const double cost = distance + kWorth * (m_kept.length() - kept.length());
            if (cost < leastCost) {
                leastCost = cost;
                best = kept;
            }
        };
        const auto crossing = crossingOfEnds(m_way, m_kept, left());
        if (crossing)
            consider(*crossing, 0.0);
        // Nearer still beyond what may be cut off is no nearest approach.
        double distance = 0.0;
        if (turnBetween(in().way, towards) > kPointsAt) {
            const double least = m_kept.to - left();
            const double s = nearest(m_way, least, m_kept.to, start(), distance);
            if (s > least + m_tolerance)
                consider({m_kept.from, s}, distance);
        }
        if (turnBetween(out().way, towards) > kPointsAt) {
            const double most = m_kept.from + left();
            const double s = nearest(m_way, m_kept.from, most, end(), distance);
            if (s < most - m_tolerance)
                consider({s, m_kept.to}, distance);
        }
        m_isLoop = crossing && best.length() == crossing->length() &&
                   m_kept.length() - best.length() > kLongestHook * m_tolerance;
        m_kept = best;
    }

    /// Whether ends that point so meet in a corner.
    bool isCorner(const Pointing &a, const Pointing &b, double apart) const
    {
        const double turn = turnBetween(a.way, b.way);
        if (turn < kCornerTurn)
            return false;
        const double bends = 0.5 * (std::abs(a.bend) + std::abs(b.bend));
        if (bends * apart > kBent * turn)
            return false;
        return turn >= kSharpTurn ||
               std::max(std::abs(a.bend), std::abs(b.bend)) * kWay * m_tolerance <= kStraight;
    }

    /// True when the ends are a corner.
    bool leadToCorner()
    {
        const Pointing a = out(), b = in();
        const Vec2 between = gap();
        if (!isCorner(a, b, between.norm()))
            return false;
        if (between.norm() <= kTogether * m_tolerance) {
            m_corner = 0.5 * (start() + end());
            return true;
        }
        const double determinant = cross(a.way, b.way);
        if (std::abs(determinant) < std::sin(0.5 * kPointsAt))
            return true;
        // So far on from the end, and so far back from the start.
        const double on = cross(between, b.way) / determinant,
                     back = cross(a.way, between) / determinant;
        const double most = kLedGaps * between.norm() + kLedOn * m_tolerance;
        if (std::max(std::abs(on), std::abs(back)) > most)
            return true;
        const double cut = std::max(-on, 0.0) + std::max(back, 0.0);
        if (cut > left())
            return true;
        m_isLoop = m_isLoop || cut > kLongestHook * m_tolerance;
        m_corner = end() + on * a.way;
        m_kept.to = std::max(m_kept.to + std::min(on, 0.0), m_kept.from);
        m_kept.from = std::min(m_kept.from - std::min(back, 0.0), m_kept.to);
        return true;
    }

    /// Until what closes the ends goes where they point.
    void cutBack()
    {
        const Vec2 apart = gap();
        const double beside = std::abs(cross(out().way, apart));
        const double most = std::min({kMostBack * m_way.length(), 0.45 * m_kept.length(),
                                      kBackAnyway * m_tolerance + kBackBeside * beside});
        if (apart.norm() <= m_tolerance && turnBetween(out().way, in().way) < kNotch)
            return;
        const Kept before = m_kept;
        for (double back = 0.0; back <= most; back += kStepBack * m_tolerance) {
            m_kept = {before.from + back, before.to - back};
            const Pointing a = out(), b = in();
            const Vec2 between = gap();
            if (turnBetween(a.way, b.way) < kSmoothTurn &&
                std::abs(cross(a.way, between)) <= kBeside * m_tolerance)
                return;
            if (turnBetween(a.way, between) < kNotch && turnBetween(between, b.way) < kNotch)
                return;
        }
        m_kept = before;
    }

    MeantEnds line() const
    {
        MeantEnds result;
        result.isLoop = m_isLoop;
        result.to = m_points.size() - 1;
        while (result.from < result.to && m_way.along(result.from) < m_kept.from)
            ++result.from;
        while (result.to > result.from && m_way.along(result.to) > m_kept.to)
            --result.to;
        const auto add = [&](const Vec2 &p) {
            if (result.line.empty() || (p - result.line.back()).norm() > kClipGrid)
                result.line.push_back(p);
        };
        if (m_corner)
            add(*m_corner);
        if (m_way.along(result.from) > m_kept.from)
            add(start());
        for (std::size_t i = result.from; i <= result.to; ++i) {
            add(m_points[i]);
            if (i == result.from)
                result.place = result.line.size() - 1;
        }
        if (m_way.along(result.to) < m_kept.to)
            add(end());
        if (m_corner)
            add(*m_corner);
        return result;
    }

    const std::vector<Vec2> &m_points;
    Way m_way;
    double m_tolerance; // mm
    Kept m_kept;
    double m_budget = 0.0; // mm that may be cut off in all
    std::optional<Vec2> m_corner;
    bool m_isLoop = false;
};

} // namespace

MeantEnds meantEnds(const std::vector<Vec2> &samples, double tolerance)
{
    if (samples.size() < 4)
        return {samples, 0, samples.empty() ? 0 : samples.size() - 1, 0, false};
    return MeetingEnds(samples, tolerance).meant();
}

WithoutHooks withoutHooks(const std::vector<Vec2> &samples, double tolerance)
{
    WithoutHooks result{0, samples.empty() ? 0 : samples.size() - 1};
    if (samples.size() < 4)
        return result;
    const Way way(samples);
    const Kept all{0.0, way.length()};
    if (way.length() < kLeastLength * tolerance)
        return result;
    if (const auto base = hookAtEnd(way, all, tolerance))
        result.to = way.edgeAt(*base);
    if (const auto base = hookAtStart(samples, way, all, tolerance))
        result.from = std::min(way.edgeAt(*base), result.to);
    return result;
}

} // namespace fff
