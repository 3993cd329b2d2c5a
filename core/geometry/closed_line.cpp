#include "core/geometry/closed_line.h"

#include "core/base/tolerances.h"
#include "core/geometry/sampled_line.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A line shorter than this many reaches is too short to tell what it closes.
constexpr double kLeastLength = 5.0;
/// The gap is at most this part of the line's length.
constexpr double kLargestGap = 0.05;
/// What of the line at its ends may lie beside each other.
constexpr double kLargestOverlap = 0.25;
/// Tolerances by which ends that go on in one direction may pass beside each other.
constexpr double kSmoothOffset = 4.0;
/// The gap times the turn over it, in tolerances: an arc stands out from its chord by an eighth.
constexpr double kLargestBulge = 4.0;
/// Ends that turn by less than this, in radians, go on in one direction; by more than that, they
/// meet in a corner.
constexpr double kSmoothTurn = 0.4, kCornerTurn = 0.7;
/// Tolerances between ends that meet in a corner: along the last one, and beside it.
constexpr double kCornerGap = 8.0, kCornerOffset = 3.0;
/// The offset is shared out over so many times its size.
constexpr double kSharing = 16.0;

/// A place on a polyline: on the edge that starts at `index`.
struct Place
{
    std::size_t index = 0;
    double share = 0.0;
    double distance = 0.0; // mm of the point looked for
};

/// Of the line from the vertex `from` on.
Place nearestPlace(const std::vector<Vec2> &line, const Vec2 &p, std::size_t from)
{
    const double first = (p - line[from]).norm();
    Place best = from + 1 < line.size() ? Place{from, 0.0, first} : Place{from - 1, 1.0, first};
    for (std::size_t i = from; i + 1 < line.size(); ++i) {
        const Vec2 way = line[i + 1] - line[i];
        const double u = std::clamp(way.dot(p - line[i]) / way.squaredNorm(), 0.0, 1.0);
        const double distance = (line[i] + u * way - p).norm();
        if (distance < best.distance)
            best = {i, u, distance};
    }
    return best;
}

/// Cuts off what follows the place.
void cutAfter(std::vector<Vec2> &line, const Place &place)
{
    const Vec2 end = line[place.index] + place.share * (line[place.index + 1] - line[place.index]);
    line.resize(place.index + 1);
    if ((end - line.back()).norm() > kClipGrid)
        line.push_back(end);
}

/// Moves the line's end by `offset`, what is before it by less and less over a length.
void lead(std::vector<Vec2> &line, const Vec2 &offset, double over, bool isAtEnd)
{
    double covered = 0.0;
    Vec2 before = isAtEnd ? line.back() : line.front();
    for (std::size_t k = 0; k < line.size(); ++k) {
        Vec2 &p = isAtEnd ? line[line.size() - 1 - k] : line[k];
        covered += (p - before).norm();
        before = p;
        if (covered >= over)
            break;
        const double u = 1.0 - covered / over;
        p += u * u * (3.0 - 2.0 * u) * offset; // without a kink at either end
    }
}

/// A gap that nothing below makes small enough. Saves looking at the line, at most of its samples.
bool isFarFromClosed(const std::vector<Vec2> &samples, double tolerance, double reach,
                     double between)
{
    if (samples.empty() || !samples.front().allFinite() || !samples.back().allFinite())
        return false;
    double drawn = between; // not less than what is measured on the simplified line
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
        drawn += (samples[i + 1] - samples[i]).norm();
    const double cutOff = (kCornerGap + 1.0) * reach + tolerance; // the end, by passing the start
    return (samples.back() - samples.front()).norm() > kLargestGap * drawn + cutOff;
}

} // namespace

std::optional<std::vector<Vec2>> closedLine(const std::vector<Vec2> &samples, double tolerance,
                                            double reach, double between)
{
    if (isFarFromClosed(samples, tolerance, reach, between))
        return {};
    const SampledLine sampled(samples, tolerance, reach);
    if (sampled.size() < 4 || sampled.length() + between < kLeastLength * reach)
        return {};
    const double length = sampled.length() + between;
    std::vector<Vec2> line = SampledLine::usable(samples);

    // Beyond the start, the end runs beside what is there already.
    const double overlap = std::min(kLargestOverlap * length, kCornerGap * reach);
    const std::size_t first = sampled.drawnBefore(sampled.indexAt(sampled.length() - overlap));
    const Place passing = nearestPlace(line, line.front(), first);
    const bool isBeyond = passing.index + 2 < line.size() || passing.share < 1.0;
    if (isBeyond && passing.distance <= kSmoothOffset * tolerance)
        cutAfter(line, passing);
    const SampledLine cut(line, tolerance, reach);
    const std::size_t end = cut.size() - 1;
    if (cut.size() < 4)
        return {};
    const Vec2 out = cut.startJoint(0, end).direction, in = cut.endJoint(0, end).direction;
    const Vec2 gap = line.front() - line.back();
    if (gap.norm() > kLargestGap * length)
        return {};

    const double turned = turnBetween(in, out);
    const Vec2 way = turned < kCornerTurn ? Vec2((in + out).normalized()) : in;
    const Vec2 across = perpendicular(way);
    const double along = way.dot(gap);
    const Vec2 beside = across.dot(gap) * across;
    const double over =
        std::min(std::max(kSharing * beside.norm(), reach), kLargestOverlap * length);
    if (turned < kCornerTurn) {
        if (turned > kSmoothTurn || along < -tolerance ||
            beside.norm() > kSmoothOffset * tolerance || along * turned > kLargestBulge * tolerance)
            return {};
        lead(line, 0.5 * beside, over, true);
        lead(line, -0.5 * beside, over, false);
    } else {
        if (std::abs(along) > kCornerGap * tolerance || beside.norm() > kCornerOffset * tolerance)
            return {};
        lead(line, beside, over, true);
    }
    return line;
}

} // namespace fff
