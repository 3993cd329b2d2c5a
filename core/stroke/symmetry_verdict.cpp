#include "core/base/tolerances.h"
#include "core/geometry/polygon.h"
#include "core/stroke/line_ends.h"
#include "core/stroke/symmetry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace fff {

namespace {

/// Rounding of the two distances that are compared, as a part of them.
constexpr double kRatioRounding = 1e-12;
/// What a hand draws past the axis at the stroke's ends before it stops: of the stroke's length,
/// both ends together, and of how far it reaches on the other side, at most.
constexpr double kMostPast = 0.2, kDeepestPast = 0.5;
/// An end that has come back from there by more than this part of how deep it was goes on.
constexpr double kComesBack = 0.3;
/// Of an end that is deep, how much longer than straight it may be.
constexpr double kRoundabout = 2.0;
/// Tolerances by which a hand trembles over the axis, where it reaches so many times as far on its
/// own side.
constexpr double kTremble = 2.5, kOverTremble = 3.0;
/// Tolerances that a hook is long, or a curl wide, at most: what is larger is drawn.
constexpr double kLongestSlip = 10.0;
/// Ends past the axis that come nearer to each other than this part of how far they are apart on
/// it begin to close the outline.
constexpr double kClosesIn = 0.6;

double lengthOf(const std::vector<Vec2> &samples, std::size_t from, std::size_t to)
{
    double length = 0.0;
    for (std::size_t i = from; i < to; ++i)
        length += (samples[i + 1] - samples[i]).norm();
    return length;
}

/// What of the samples lies between hooks of the hand.
WithoutHooks betweenHooks(const std::vector<Vec2> &samples, double tolerance)
{
    WithoutHooks kept = withoutHooks(samples, tolerance);
    if (lengthOf(samples, 0, kept.from) > kLongestSlip * tolerance)
        kept.from = 0;
    if (lengthOf(samples, kept.to, samples.size() - 1) > kLongestSlip * tolerance)
        kept.to = samples.size() - 1;
    return kept;
}

/// A stroke over its axis: how high each of its samples is, on the side that it reaches farther on.
class StrokeOverAxis
{
public:
    /// sign: of that side; largest: how far it reaches there; near: what is as low is near the
    /// axis, slip: what is as small is none of its own, all mm
    StrokeOverAxis(const std::vector<Vec2> &samples, const MirrorAxis &axis, double sign,
                   double largest, double near, double slip)
        : m_samples(samples), m_axis(axis), m_up(sign * perpendicular(axis.direction)),
          m_largest(largest), m_near(near), m_slip(slip)
    {
    }

    double height(std::size_t i) const { return m_up.dot(m_samples[i] - m_axis.point); }
    double along(std::size_t i) const { return m_axis.direction.dot(m_samples[i] - m_axis.point); }

    /// How deep the stroke goes on the other side if what its ends, within `kept`, draw there
    /// counts for nothing; nothing where it counts.
    std::optional<double> depthWithoutEnds(const WithoutHooks &kept) const
    {
        std::size_t first = kept.from, last = kept.to;
        while (first < last && !(height(first) > m_near))
            ++first;
        while (last > first && !(height(last) > m_near))
            --last;
        if (first == last)
            return {};
        // On from there to where it crosses the axis.
        while (first > kept.from && height(first) > 0.0)
            --first;
        while (last < kept.to && height(last) > 0.0)
            ++last;
        const double past =
            lengthOf(m_samples, kept.from, first) + lengthOf(m_samples, last, kept.to);
        if (past > kMostPast * lengthOf(m_samples, kept.from, kept.to) ||
            !isEnd(first, kept.from) || !isEnd(last, kept.to) || doEndsClose(kept, first, last))
            return {};
        double depth = 0.0;
        for (std::size_t i = first + 1; i < last; ++i)
            depth = std::max(depth, -height(i));
        return depth;
    }

private:
    /// Whether what lies between where the stroke crosses the axis and its end is no more than an
    /// end: near the axis, a curl of the hand, or straight, not deep and not on its way back.
    bool isEnd(std::size_t crossing, std::size_t end) const
    {
        Box2 box; // along the axis, and how deep
        const auto [from, to] = std::minmax(crossing, end);
        for (std::size_t i = from; i <= to; ++i)
            box.extend(Vec2(along(i), -height(i)));
        const double depth = box.max.y();
        if (depth <= m_near || box.size().maxCoeff() <= m_slip)
            return true;
        return depth <= kDeepestPast * m_largest && -height(end) >= (1.0 - kComesBack) * depth &&
               lengthOf(m_samples, from, to) <= kRoundabout * depth + m_near;
    }

    bool doEndsClose(const WithoutHooks &kept, std::size_t first, std::size_t last) const
    {
        return (m_samples[kept.from] - m_samples[kept.to]).norm() <
               kClosesIn * std::abs(along(first) - along(last));
    }

    const std::vector<Vec2> &m_samples;
    MirrorAxis m_axis;
    Vec2 m_up;
    double m_largest, m_near, m_slip; // mm
};

} // namespace

SymmetryVerdict judgeSymmetry(const std::vector<Vec2> &samples, const MirrorAxis &axis,
                              double ratio, double tolerance)
{
    SymmetryVerdict verdict;
    const Vec2 normal = perpendicular(axis.direction);
    bool isAllUsable = true;
    for (const Vec2 &p : samples) {
        if (!(p.allFinite() && p.cwiseAbs().maxCoeff() <= kMaxCoordinate)) {
            isAllUsable = false;
            continue;
        }
        const double height = normal.dot(p - axis.point);
        verdict.left = std::max(verdict.left, height);
        verdict.right = std::max(verdict.right, -height);
    }
    const auto isOneSided = [&](double larger, double smaller) {
        return larger > kClipGrid && larger * (1.0 + kRatioRounding) >= ratio * smaller;
    };
    const double larger = std::max(verdict.left, verdict.right);
    double &smaller = verdict.isLeft() ? verdict.right : verdict.left;
    verdict.limit = larger / ratio;
    verdict.isOneSided = isOneSided(larger, smaller);
    if (verdict.isOneSided || !isAllUsable || samples.size() < 4)
        return verdict;
    const double near =
        std::max(verdict.limit, std::min(kTremble * tolerance, larger / kOverTremble));
    const StrokeOverAxis stroke(samples, axis, verdict.isLeft() ? 1.0 : -1.0, larger, near,
                                kLongestSlip * tolerance);
    const auto depth = stroke.depthWithoutEnds(betweenHooks(samples, tolerance));
    if (depth && (*depth <= near || isOneSided(larger, *depth))) {
        smaller = *depth;
        verdict.isOneSided = true;
    }
    return verdict;
}

} // namespace fff
