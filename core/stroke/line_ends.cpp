#include "core/stroke/line_ends.h"

#include "core/base/tolerances.h"
#include "core/geometry/directions.h"
#include "core/stroke/line_way.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff {

namespace {

/// Lengths in tolerances: of the line from which on its ends are looked at, of a hook, and of the
/// ways by which its turn is judged.
constexpr double kLeastLength = 12.0, kLongestHook = 40.0, kHookWay = 4.0;
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
/// their bends may account for. What they may bend over kPointingWay to be straight, radians.
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
/// What a hand does that is put down or lifted: no longer than this, in tolerances, and turned from
/// where the end points by more than that, radians.
constexpr double kNub = 2.5, kNubTurn = 0.7;
/// Tolerances within which ends are in one place.
constexpr double kTogether = 0.25;

/// The sample where the line turns back near its end; none where it does not.
std::optional<std::size_t> hookAtEnd(const LineWay &way, const KeptStretch &kept, double tolerance)
{
    const double longest = std::min(kLongestHook * tolerance, kMostCut * kept.length());
    const double over = kHookWay * tolerance;
    std::optional<std::size_t> base;
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
        base = i;
    }
    return base;
}

std::optional<std::size_t> hookAtStart(const std::vector<Vec2> &points, const LineWay &way,
                                       const KeptStretch &kept, double tolerance)
{
    const std::vector<Vec2> back(points.rbegin(), points.rend());
    const LineWay reversed(back);
    const auto base =
        hookAtEnd(reversed, {way.length() - kept.to, way.length() - kept.from}, tolerance);
    if (!base)
        return {};
    return points.size() - 1 - *base;
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
                if (!leadToCorner()) {
                    cutBack();
                    dropNubs();
                }
            }
        }
        return line();
    }

private:
    double left() const { return m_budget - (m_way.length() - m_kept.length()); }
    Vec2 start() const { return m_way.at(m_kept.from); }
    Vec2 end() const { return m_way.at(m_kept.to); }
    Vec2 gap() const { return start() - end(); }
    EndPointing out() const { return pointingAt(m_way, m_kept, true, m_tolerance, kCornerTurn); }
    EndPointing in() const { return pointingAt(m_way, m_kept, false, m_tolerance, kCornerTurn); }

    /// Those after which the ends are further apart than before.
    void dropHooks()
    {
        if (const auto base = hookAtEnd(m_way, m_kept, m_tolerance))
            if ((m_way.point(*base) - start()).norm() < gap().norm())
                m_kept.to = m_way.along(*base);
        if (const auto base = hookAtStart(m_points, m_way, m_kept, m_tolerance))
            if ((m_way.point(*base) - end()).norm() < gap().norm())
                m_kept.from = m_way.along(*base);
    }

    /// What lies beyond where the ends cross, or come nearest to each other.
    void cutBeyond()
    {
        const double apart = gap().norm();
        if (left() <= 0.0 || apart <= kTogether * m_tolerance)
            return;
        const Vec2 towards = gap() / apart;
        KeptStretch best = m_kept;
        double leastCost = apart;
        const auto consider = [&](const KeptStretch &kept, double distance) {
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
            const double s = nearestAlong(m_way, least, m_kept.to, start(), distance);
            if (s > least + m_tolerance)
                consider({m_kept.from, s}, distance);
        }
        if (turnBetween(out().way, towards) > kPointsAt) {
            const double most = m_kept.from + left();
            const double s = nearestAlong(m_way, m_kept.from, most, end(), distance);
            if (s < most - m_tolerance)
                consider({s, m_kept.to}, distance);
        }
        m_isLoop = crossing && best.length() == crossing->length() &&
                   m_kept.length() - best.length() > kLongestHook * m_tolerance;
        m_kept = best;
    }

    /// Whether ends that point so meet in a corner.
    bool isCorner(const EndPointing &a, const EndPointing &b, double apart) const
    {
        const double turn = turnBetween(a.way, b.way);
        if (turn < kCornerTurn)
            return false;
        const double bends = 0.5 * (std::abs(a.bend) + std::abs(b.bend));
        if (bends * apart > kBent * turn)
            return false;
        return turn >= kSharpTurn ||
               std::max(std::abs(a.bend), std::abs(b.bend)) * kPointingWay * m_tolerance <=
                   kStraight;
    }

    /// True when the ends are a corner.
    bool leadToCorner()
    {
        const EndPointing a = out(), b = in();
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
        const KeptStretch before = m_kept;
        for (double back = 0.0; back <= most; back += kStepBack * m_tolerance) {
            m_kept = {before.from + back, before.to - back};
            const EndPointing a = out(), b = in();
            const Vec2 between = gap();
            if (turnBetween(a.way, b.way) < kSmoothTurn &&
                std::abs(cross(a.way, between)) <= kBeside * m_tolerance)
                return;
            if (turnBetween(a.way, between) < kNotch && turnBetween(between, b.way) < kNotch)
                return;
        }
        m_kept = before;
    }

    /// So that what leads one end to the other sees where they go.
    void dropNubs()
    {
        const Vec2 out = this->out().way, in = this->in().way;
        const double most = std::min(kNub * m_tolerance, 0.1 * m_kept.length());
        const auto nub = [&](double end, double inward, const Vec2 &way) {
            for (double cut = 0.0; cut < most; cut += 0.5 * m_tolerance) {
                const Vec2 tip = m_way.at(end + inward * cut);
                const Vec2 stub = inward * (m_way.at(end + inward * (cut + m_tolerance)) - tip);
                if (stub.norm() > kClipGrid && turnBetween(stub, way) <= kNubTurn)
                    return cut;
            }
            return 0.0; // it goes on so: that is no nub
        };
        m_kept = {m_kept.from + nub(m_kept.from, 1.0, in), m_kept.to - nub(m_kept.to, -1.0, out)};
    }

    MeantEnds line() const
    {
        MeantEnds result;
        result.isLoop = m_isLoop;
        result.isCorner = m_corner.has_value();
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
    LineWay m_way;
    double m_tolerance; // mm
    KeptStretch m_kept;
    double m_budget = 0.0; // mm that may be cut off in all
    std::optional<Vec2> m_corner;
    bool m_isLoop = false;
};

} // namespace

MeantEnds meantEnds(const std::vector<Vec2> &samples, double tolerance)
{
    if (samples.size() < 4)
        return {samples, 0, samples.empty() ? 0 : samples.size() - 1, 0, false, false};
    return MeetingEnds(samples, tolerance).meant();
}

WithoutHooks withoutHooks(const std::vector<Vec2> &samples, double tolerance)
{
    WithoutHooks result{0, samples.empty() ? 0 : samples.size() - 1};
    if (samples.size() < 4)
        return result;
    const LineWay way(samples);
    const KeptStretch all{0.0, way.length()};
    if (way.length() < kLeastLength * tolerance)
        return result;
    if (const auto base = hookAtEnd(way, all, tolerance))
        result.to = *base;
    if (const auto base = hookAtStart(samples, way, all, tolerance))
        result.from = std::min(*base, result.to);
    return result;
}

} // namespace fff
