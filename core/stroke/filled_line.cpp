#include "core/stroke/filled_line.h"

#include "core/base/tolerances.h"
#include "core/geometry/bezier.h"
#include "core/geometry/sampled_line.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace fff {

namespace {

/// Tolerances from one sample to the next from which on there is a way to be filled, and between
/// the places that fill it.
constexpr double kLeastGap = 1.5, kStep = 2.0;
/// Of a tolerance, what a bend has to stand out to be one.
constexpr double kLeastBulge = 0.1;
/// Turns that are corners, radians: whatever is beside them, beside one, and where nothing is.
constexpr double kSharp = 1.48, kNextToSharp = 0.85, kLonely = 0.65;
/// The tip of an oval: of its turn, what both neighbours turn the same way at least, no corners
/// themselves, and how far it turns at most.
constexpr double kBesideTip = 0.33, kMostTip = 2.0;
/// Of a turn, what its neighbours turn at most where it is lonely.
constexpr double kLoneliness = 0.3;
/// A neighbour nearer than this part of the way is not what the hand's turn shows at.
constexpr double kComparable = 0.2;
/// Over which part of a way among many samples the line before and after it is judged, by how much
/// it turns there on one side at most, radians, and on the other at least, as a part of that.
constexpr double kLedOver = 0.3, kMostLed = 1.2, kAlike = 0.4;
/// Places on one way at most.
constexpr double kMostPlaces = 64.0;
/// Of a loop of few samples: how many there are, tolerances between them on the mean; and in such
/// steps, how near to the start they are there again, and how near the last other one is.
constexpr std::size_t kFewestRound = 5, kMostRound = 48;
constexpr double kLeastStep = 3.0, kThere = 0.5, kNearStart = 1.7;

class Ways
{
public:
    Ways(const std::vector<Vec2> &points) : m_points(points) {}

    std::size_t size() const { return m_points.size(); }
    Vec2 way(std::size_t i) const { return m_points[i + 1] - m_points[i]; }
    bool isInner(std::size_t i) const { return i > 0 && i + 1 < size(); }
    /// Signed; 0 at the ends.
    double turn(std::size_t i) const
    {
        if (!isInner(i))
            return 0.0;
        return signedTurn(way(i - 1), way(i));
    }
    bool isCorner(std::size_t i) const
    {
        const double here = std::abs(turn(i));
        if (here >= kSharp)
            return !isTip(i);
        const double before = i > 0 ? std::abs(turn(i - 1)) : 0.0;
        const double after = std::abs(turn(i + 1));
        if (here >= kNextToSharp && std::max(before, after) >= kSharp)
            return true;
        return here >= kLonely && std::max(before, after) <= kLoneliness * here;
    }
    /// Of a slim oval, whose line bends more and more towards it.
    bool isTip(std::size_t i) const
    {
        const double here = turn(i);
        const auto leadsUp = [&](double beside) {
            return beside * here > 0.0 && std::abs(beside) >= kBesideTip * std::abs(here) &&
                   std::abs(beside) < kNextToSharp;
        };
        return std::abs(here) <= kMostTip && i > 0 && leadsUp(turn(i - 1)) && leadsUp(turn(i + 1));
    }
    /// Which way the line passes a sample, unit; none at a corner and where there is no telling.
    std::optional<Vec2> passing(std::size_t i, double length) const
    {
        if (!isInner(i) || isCorner(i))
            return {};
        const Vec2 in = way(i - 1), out = way(i);
        const double a = in.norm(), b = out.norm();
        if (std::min(a, b) < kComparable * length)
            return {};
        return Vec2((in / (a * a) + out / (b * b)).normalized());
    }

    /// Which way the line comes to a sample, or goes on from it, unit; none where it is not dense
    /// beside a way of this length.
    std::optional<Vec2> dense(std::size_t i, double length, bool isBefore) const
    {
        for (std::size_t k = 1; k < kFillLookAround && (isBefore ? k <= i : i + k < size()); ++k) {
            const std::size_t at = isBefore ? i - k : i + k;
            if (way(isBefore ? at : at - 1).norm() >= kComparable * length)
                return {};
            const Vec2 chord = isBefore ? m_points[i] - m_points[at] : m_points[at] - m_points[i];
            if (chord.norm() >= kLedOver * length)
                return Vec2(chord.normalized());
        }
        return {};
    }
    /// Where it leaves for the way from a sample and comes from it, where that lies among many.
    std::optional<std::pair<Vec2, Vec2>> led(std::size_t i) const
    {
        const Vec2 gap = way(i);
        const std::optional<Vec2> out = dense(i, gap.norm(), true),
                                  in = dense(i + 1, gap.norm(), false);
        if (!out || !in)
            return {};
        const double leaving = signedTurn(*out, gap), coming = signedTurn(gap, *in);
        const double less = std::min(std::abs(leaving), std::abs(coming)),
                     more = std::max(std::abs(leaving), std::abs(coming));
        if (leaving * coming <= 0.0 || less < kAlike * more || more > kMostLed)
            return {};
        return std::pair(*out, *in);
    }

private:
    const std::vector<Vec2> &m_points;
};

/// The same way at the other end of the chord, if the bend is the arc of a circle.
Vec2 acrossChord(const Vec2 &way, const Vec2 &chord)
{
    return 2.0 * chord.dot(way) * chord - way;
}

void addWay(const Ways &ways, const Vec2 &from, std::size_t i, double tolerance,
            std::vector<Vec2> &result)
{
    const Vec2 gap = ways.way(i);
    const double length = gap.norm();
    if (length < kLeastGap * tolerance)
        return;
    const Vec2 chord = gap / length;
    std::optional<Vec2> out, in;
    if (const auto led = ways.led(i))
        std::tie(out, in) = *led;
    else
        std::tie(out, in) = std::pair(ways.passing(i, length), ways.passing(i + 1, length));
    if (!out && !in)
        return;
    if (!out)
        out = acrossChord(*in, chord);
    if (!in)
        in = acrossChord(*out, chord);
    const double leaving = turnBetween(*out, chord), coming = turnBetween(*in, chord);
    if (std::max(leaving, coming) * length < 4.0 * kLeastBulge * tolerance)
        return;
    const double handle = length / (3.0 * std::pow(std::cos(0.25 * (leaving + coming)), 2.0));
    const Vec2 to = from + gap;
    const CubicBezier bend{from, from + handle * *out, to - handle * *in, to};
    const double pieces = std::clamp(std::ceil(length / (kStep * tolerance)), 4.0, kMostPlaces);
    for (double k = 1.0; k < pieces; ++k)
        result.push_back(bend.at(k / pieces));
}

} // namespace

void fill(const std::vector<Vec2> &samples, double tolerance, std::size_t from,
          std::vector<Vec2> &result, std::vector<std::size_t> &places)
{
    const Ways ways(samples);
    places.resize(std::min(from, places.size()));
    result.resize(places.empty() ? 0 : places.back() + 1);
    for (std::size_t i = places.size(); i < samples.size(); ++i) {
        if (i > 0)
            addWay(ways, samples[i - 1], i - 1, tolerance, result);
        if (result.empty() || (samples[i] - result.back()).norm() > kClipGrid)
            result.push_back(samples[i]);
        places.push_back(result.size() - 1);
    }
}

std::optional<std::vector<Vec2>> filledRound(const std::vector<Vec2> &samples, double tolerance)
{
    if (samples.size() < kFewestRound || samples.size() > kMostRound)
        return {};
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
        length += (samples[i + 1] - samples[i]).norm();
    const double step = length / static_cast<double>(samples.size() - 1);
    if (step < kLeastStep * tolerance)
        return {};
    std::vector<Vec2> loop = samples;
    const Vec2 ahead = loop[1] - loop[0];
    // Where the hand is there again, or has just passed it.
    const auto isThere = [&] {
        const Vec2 way = loop.back() - loop[loop.size() - 2], off = loop[0] - loop.back();
        const double back = -way.dot(off) / way.squaredNorm(); // parts of the last way
        return off.norm() < kThere * step ||
               (off.norm() < 1.6 * step && -off.dot(ahead) > 0.5 * off.norm() * ahead.norm()) ||
               (back > 0.1 && back < 1.0 && std::abs(cross(way, off)) < kThere * step * way.norm());
    };
    while (loop.size() > kFewestRound - 1 && isThere())
        loop.pop_back();
    if ((loop.back() - loop[0]).norm() > kNearStart * step)
        return {};
    constexpr std::size_t kAround = 3;
    std::vector<Vec2> round(loop.end() - kAround, loop.end());
    round.insert(round.end(), loop.begin(), loop.end());
    round.insert(round.end(), loop.begin(), loop.begin() + kAround + 1);
    std::vector<Vec2> filled;
    std::vector<std::size_t> places;
    fill(round, tolerance, 0, filled, places);
    return std::vector<Vec2>(filled.begin() + static_cast<std::ptrdiff_t>(places[kAround]),
                             filled.begin() +
                                 static_cast<std::ptrdiff_t>(places[kAround + loop.size()] + 1));
}

} // namespace fff
