// One cubic along a stretch of a sampled line. Internal to geometry.
#pragma once

#include "core/geometry/bezier.h"
#include "core/geometry/sampled_line.h"

#include <optional>
#include <vector>

namespace fff {

class SpanFitter
{
public:
    SpanFitter(const SampledLine &line, double tolerance);

    /// The cubic from joint to joint, tangent to both, along the samples [from, to], if there is
    /// one: every sample within the tolerance of it and it within the tolerance of the polyline
    /// through them. It turns by no more than kLargestTurn, so it has no loop.
    ///
    /// Two unknowns, the lengths of the handles, by Gauss-Newton steps on the distances measured
    /// across the curve, each sample's parameter moving on to its foot between them; at first for a
    /// few samples, in the end checked for all of them.
    /// Source  P. Schneider 1990, Graphics Gems, pp. 612-626, for the unknowns; W. Wang,
    ///         H. Pottmann, Y. Liu 2006, Fitting B-spline curves to point clouds by curvature-based
    ///         squared distance minimization, ACM TOG 25(2), for measuring across the curve
    ///         (their TDM), which takes 3 or 4 steps where Schneider's takes tens.
    std::optional<CubicBezier> fit(std::size_t from, std::size_t to, const CurveEnd &start,
                                   const CurveEnd &end);
    /// The same, going on to the least error instead of stopping at the first cubic that is near
    /// enough.
    std::optional<CubicBezier> best(std::size_t from, std::size_t to, const CurveEnd &start,
                                    const CurveEnd &end);
    /// For short stretches: handles of a third of the chord or less, as the tolerance allows.
    std::optional<CubicBezier> shortPiece(std::size_t from, std::size_t to, const CurveEnd &start,
                                          const CurveEnd &end);
    /// For the shortest of stretches: the same, and some curve in any case, so that directions at
    /// the joints hold.
    CubicBezier shortestPiece(std::size_t from, std::size_t to, const CurveEnd &start,
                              const CurveEnd &end);

    /// Samples that a cubic was held against so far: what the fits cost.
    std::size_t samplesLookedAt() const { return m_lookedAt; }

    /// Radians. Three cubics go round a circle: with fewer, one sees that they are none.
    static constexpr double kLargestTurn = 2.6;

private:
    struct Foot
    {
        std::size_t sample = 0;
        double u = 0.0; // parameter
    };

    std::optional<CubicBezier> fit(std::size_t from, std::size_t to, const CurveEnd &start,
                                   const CurveEnd &end, bool isFirstEnough);
    void chooseSamples(std::size_t from, std::size_t to);
    bool isWithin(const CubicBezier &curve, std::size_t from, std::size_t to) const;

    const SampledLine &m_line;
    const double m_limit; // mm
    std::vector<Foot> m_feet;
    mutable std::size_t m_lookedAt = 0;
};

} // namespace fff
