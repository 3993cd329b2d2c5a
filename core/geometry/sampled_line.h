// The samples of a hand as a line that can be fitted: how far along it each of them is, where it
// turns a corner, which way it goes. Internal to geometry.
#pragma once

#include "core/geometry/directions.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace fff {

/// A point that a fitted chain passes and the way it passes it.
struct CurveEnd
{
    Vec2 position = Vec2::Zero();
    Vec2 direction = Vec2::UnitX(); // unit
};

/// Samples that lie in a straight line: true lines of what was drawn, not arcs that pass for one.
struct StraightRun
{
    std::size_t from = 0, to = 0;
    CurveEnd start, end; // on the line, both in its direction
};

/// Samples in the order of drawing, repeated ones and those out of range left out, gaps of more
/// than a reach filled on the straight way.
///
/// How far along the line a sample is, is measured on a simplified line that is off the samples by
/// half a tolerance at most: a hand that trembles, halts or slips back draws miles within a
/// millimetre. So distances along the line never decrease and are those that one sees.
class SampledLine
{
public:
    /// tolerance: mm that a fit may be off; reach: mm along the line over which corners and
    /// directions are judged.
    SampledLine(const std::vector<Vec2> &samples, double tolerance, double reach);

    /// What of the samples is looked at.
    static std::vector<Vec2> usable(const std::vector<Vec2> &samples);
    /// How many of these there are, and where the k-th of them is among those that were filled in.
    std::size_t drawnCount() const { return m_drawn.size(); }
    std::size_t indexOfDrawn(std::size_t k) const { return m_drawn[k]; }
    /// The last one that is not after a sample.
    std::size_t drawnBefore(std::size_t i) const;

    std::size_t size() const { return m_points.size(); }
    const Vec2 &point(std::size_t i) const { return m_points[i]; }
    double along(std::size_t i) const { return m_along[i]; } // mm from the first
    double lengthBetween(std::size_t a, std::size_t b) const { return m_along[b] - m_along[a]; }
    double length() const { return m_along.back(); }
    /// The first sample that is at least so far along; the last one when none is.
    std::size_t indexAt(double along) const;

    /// Samples at which the line turns by more than `angle` (radians) all at once: as seen over a
    /// reach and a half, and most of it over half of that, too; and no bend accounts for it. In
    /// order, without the first and the last sample. O(n).
    std::vector<std::size_t> corners(double angle) const;

    /// At a sample between `from` and `to`, with no corner between them: where a parabola through
    /// the samples around it passes and which way. As many samples as a parabola can follow.
    CurveEnd smoothJoint(std::size_t at, std::size_t from, std::size_t to) const;
    /// At the first (the last) sample of a stretch: itself, and which way the line goes on from
    /// (comes to) it.
    CurveEnd startJoint(std::size_t from, std::size_t to) const;
    CurveEnd endJoint(std::size_t from, std::size_t to) const;

    /// The samples between lie within `tolerance` of the chord and the line does not go back by
    /// more than that.
    bool isStraight(std::size_t from, std::size_t to, double tolerance) const;

    /// Straight runs of at least kLeastStraight reaches between two samples, in order,
    /// apart from each other. Where they end the line begins to leave them, all at once: arcs and
    /// inflections leave their chords bit by bit.
    std::vector<StraightRun> straightRuns(std::size_t from, std::size_t to) const;
    static constexpr double kLeastStraight = 8.0;

private:
    /// Sums over the samples before index i, for straight regressions over any of them.
    struct Sums
    {
        double w = 0.0, s = 0.0, ss = 0.0;
        Vec2 p = Vec2::Zero(), sp = Vec2::Zero();
    };
    struct Parabola // position + s * slope + s² * bend, s in reaches
    {
        Vec2 position = Vec2::Zero(), slope = Vec2::Zero(), bend = Vec2::Zero();
        double largestError = 0.0;
    };

    /// A determinant below this part of its diagonal's product is rounding (no unit): the samples
    /// are too few, or lie too near to each other, to tell a parabola from a line.
    static constexpr double kSingular = 1e-9;

    /// Nothing for what goes nowhere.
    static Vec2 unit(const Vec2 &way);
    void fillGaps(const std::vector<Vec2> &drawn);
    void measure();
    void sum();
    Vec2 directionBetween(std::size_t from, std::size_t to) const;
    double turnAt(std::size_t at, double reach) const;
    std::size_t sharpest(std::size_t at, double reach) const;
    Parabola parabola(std::size_t at, std::size_t from, std::size_t to, bool isThroughPoint) const;
    std::vector<std::size_t> withoutSteps(const std::vector<std::size_t> &corners) const;
    bool standsOut(std::size_t at, std::size_t from, std::size_t to, double turn) const;
    template <int Count>
    double meanSquareOff(std::size_t at, std::size_t from, std::size_t to,
                         bool isThroughPoint) const;
    CurveEnd joint(std::size_t at, std::size_t from, std::size_t to, bool isEnd) const;
    Vec2 meanBetween(std::size_t from, std::size_t to) const;
    StraightRun extended(StraightRun run, const Vec2 &base, double leaving, std::size_t lowest,
                         std::size_t highest) const;
    std::optional<StraightRun> straightRun(std::size_t from, std::size_t to, std::size_t lowest,
                                           std::size_t highest) const;

    double m_tolerance = 0.0, m_reach = 0.0;
    std::vector<Vec2> m_points;
    std::vector<std::size_t> m_drawn;    // indices of those that were not filled in
    std::vector<double> m_along;         // mm
    std::vector<double> m_weight;        // mm of the line that the sample stands for
    std::vector<Sums> m_sums;            // size() + 1
    std::vector<std::size_t> m_vertices; // samples that the simplified line goes through
};

} // namespace fff
