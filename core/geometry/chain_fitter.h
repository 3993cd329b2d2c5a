// Few cubics along a sampled line. Internal to geometry.
#pragma once

#include "core/geometry/fit_span.h"
#include "core/geometry/sampled_line.h"

#include <optional>
#include <vector>

namespace fff {

/// Fits one stretch of a line after the other, each between two corners.
///
/// Straight runs become true lines; between them, every sample has one joint: where a smooth chain
/// passes it and which way, whatever the segments are. So the longest segments one after the other
/// are the fewest: what a stretch can do, a part of it can do. They are looked for from both ends;
/// the joints then lie half-way between the latest and the earliest place that each can have, which
/// makes them even. Source  M. Plass, M. Stone 1983, Curve-fitting with piecewise parametric
/// cubics, SIGGRAPH,
///         pp. 229-239, for directions that are settled before joints are chosen. They choose by
///         dynamic programming over all pairs; with one joint a sample, walking does the same in
///         O(segments · log samples) fits.
class ChainFitter
{
public:
    struct Stretch
    {
        std::size_t from = 0, to = 0;
        CurveEnd start, end;
        std::size_t lowest = 0, highest = 0;           // samples that directions are judged by
        bool isStartGiven = false, isEndGiven = false; // its direction has to be kept
    };

    /// leastCorner: of two directions that meet; less is none, radians
    ChainFitter(const SampledLine &line, double tolerance, double reach, double leastCorner);

    void fit(const Stretch &stretch);

    /// Makes one direction of the two that meet in a corner that turns by less than `leastCorner`.
    static void smoothen(Stretch &before, Stretch &after, double leastCorner);

    /// A segment of the chain, and the samples of the line that it runs from and to.
    struct Link
    {
        CubicBezier curve;
        std::size_t from = 0, to = 0;
    };

    /// Without segments of no length.
    std::vector<Link> takeLinks();
    std::vector<CubicBezier> takeChain();

    /// What was done so far, for those who count: samples that a cubic was held against.
    std::size_t samplesLookedAt() const { return m_spans.samplesLookedAt(); }

private:
    struct Piece
    {
        std::size_t to = 0; // sample where it ends; of those looked for backwards, where it starts
        CubicBezier curve;
        bool isForced = false; // some curve where none fits
    };

    void fitSmooth(const Stretch &stretch);
    const CurveEnd &joint(std::size_t at);
    std::optional<CubicBezier> piece(std::size_t from, std::size_t to);
    Piece shortest(std::size_t from);
    Piece shortestBefore(std::size_t to);
    Piece furthest(std::size_t from, double tried);
    Piece earliest(std::size_t to, double tried);
    std::vector<Piece> forwards();
    std::vector<Piece> backwards();
    std::optional<std::size_t> firstForced(const std::vector<Piece> &pieces) const;
    void mend(std::vector<Piece> &pieces);
    std::vector<Piece> balanced(const std::vector<Piece> &late, const std::vector<Piece> &early,
                                double share);

    const SampledLine &m_line;
    const double m_tolerance, m_reach, m_leastCorner;
    SpanFitter m_spans;
    std::vector<std::optional<CurveEnd>> m_joints; // that were asked for
    Stretch m_stretch;
    std::vector<Link> m_chain;
};

} // namespace fff
