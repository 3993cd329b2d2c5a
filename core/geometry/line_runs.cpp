// Where a drawn line is straight.
#include "core/base/tolerances.h"
#include "core/geometry/sampled_line.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Of an edge of the simplified line, the middle part that says whether it stands for a straight
/// run: its ends reach into the bends beside it.
constexpr double kCore = 0.7;
/// Tolerances that a straight run may bend over that part. An arc whose chord is an edge of the
/// simplified line bends twice as much.
constexpr double kLargestBend = 0.2;
/// Tolerances that the line may leave a straight run's, on the mean over half a reach.
constexpr double kLeaving = 0.3;
/// Part that a run keeps at least when it is let go on to twice that.
constexpr double kAbruptness = 0.85;
/// Samples that tell a straight run from a quick hand's leaps.
constexpr std::size_t kStraightSamples = 8;

} // namespace

bool SampledLine::isStraight(std::size_t from, std::size_t to, double tolerance) const
{
    const Vec2 chord = m_points[to] - m_points[from];
    const double length = chord.norm();
    if (length <= kClipGrid)
        return false;
    const Vec2 way = chord / length;
    double furthest = 0.0;
    for (std::size_t i = from + 1; i < to; ++i) {
        const Vec2 off = m_points[i] - m_points[from];
        const double along = way.dot(off);
        furthest = std::max(furthest, along);
        const Vec2 foot = std::clamp(along, 0.0, length) * way;
        if ((off - foot).norm() > tolerance || along < furthest - tolerance)
            return false;
    }
    return true;
}

Vec2 SampledLine::meanBetween(std::size_t from, std::size_t to) const
{
    const Sums &a = m_sums[from], &b = m_sums[to + 1];
    return m_points.front() + (b.p - a.p) / (b.w - a.w);
}

/// Both ends as far out as the line stays within `leaving` mm of the run's.
StraightRun SampledLine::extended(StraightRun run, const Vec2 &base, double leaving,
                                  std::size_t lowest, std::size_t highest) const
{
    const Vec2 &way = run.start.direction;
    const auto off = [&](const Vec2 &p) { return std::abs(cross(way, p - base)); };
    const auto isOnLine = [&](std::size_t next, std::size_t a, std::size_t b) {
        return off(m_points[next]) <= m_tolerance && off(meanBetween(a, b)) <= leaving;
    };
    const double ahead = 0.5 * m_reach;
    while (run.to < highest) {
        const std::size_t next = run.to + 1;
        if (!isOnLine(next, next, std::max(indexAt(m_along[run.to] + ahead), next)))
            break;
        run.to = next;
    }
    while (run.from > lowest) {
        const std::size_t next = run.from - 1;
        if (!isOnLine(next, std::min(indexAt(m_along[run.from] - ahead), next), next))
            break;
        run.from = next;
    }
    return run;
}

/// The one that an edge of the simplified line stands for, if it does, within [lowest, highest].
std::optional<StraightRun> SampledLine::straightRun(std::size_t from, std::size_t to,
                                                    std::size_t lowest, std::size_t highest) const
{
    const double cut = 0.5 * (1.0 - kCore) * lengthBetween(from, to);
    const std::size_t first = indexAt(m_along[from] + cut), last = indexAt(m_along[to] - cut);
    const std::size_t middle = indexAt(0.5 * (m_along[first] + m_along[last]));
    if (last < first + 2 || middle <= first || middle >= last)
        return {};
    const Vec2 way = directionBetween(first, last), base = meanBetween(first, last);
    const Parabola fit = parabola(middle, first, last, false);
    const double half = 0.5 * lengthBetween(first, last) / m_reach;
    if (std::abs(cross(way, fit.bend)) * half * half > kLargestBend * m_tolerance)
        return {};
    const auto off = [&](const Vec2 &p) { return std::abs(cross(way, p - base)); };
    for (std::size_t i = first; i <= last; ++i) {
        if (off(m_points[i]) > m_tolerance)
            return {};
    }
    const StraightRun core{first, last, {base, way}, {base, way}};
    StraightRun run = extended(core, base, kLeaving * m_tolerance, lowest, highest);
    const StraightRun more = extended(run, base, 2.0 * kLeaving * m_tolerance, lowest, highest);
    if (lengthBetween(run.from, run.to) < kAbruptness * lengthBetween(more.from, more.to) ||
        drawnBefore(run.to) < drawnBefore(run.from) + kStraightSamples)
        return {};
    const auto joint = [&](std::size_t i) {
        return CurveEnd{base + way.dot(m_points[i] - base) * way, way};
    };
    run.start = joint(run.from);
    run.end = joint(run.to);
    if ((run.end.position - run.start.position).dot(way) < kLeastStraight * m_reach)
        return {};
    return run;
}

std::vector<StraightRun> SampledLine::straightRuns(std::size_t from, std::size_t to) const
{
    std::vector<StraightRun> runs;
    const auto firstVertex = std::upper_bound(m_vertices.begin(), m_vertices.end(), from);
    auto k = static_cast<std::size_t>(firstVertex - m_vertices.begin());
    k = k > 0 ? k - 1 : 0;
    for (; k + 1 < m_vertices.size() && m_vertices[k] < to; ++k) {
        const std::size_t lowest = runs.empty() ? from : runs.back().to;
        const std::size_t a = std::max(m_vertices[k], lowest), b = std::min(m_vertices[k + 1], to);
        if (b <= a || lengthBetween(a, b) < kLeastStraight * m_reach)
            continue;
        if (const auto run = straightRun(a, b, lowest, to))
            runs.push_back(*run);
    }
    return runs;
}

} // namespace fff
