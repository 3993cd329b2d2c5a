// Where a piece is cut to ask for its stresses: a grid of lines, fans from the corners of slits,
// ligaments at re-entrant corners. Geometry alone: made once, kept while only forces change.
#pragma once

#include "core/physics/neck.h"

#include <vector>

namespace fff {

enum class SampleKind {
    Grid,       // a line of the grid
    SlitFan,    // from a corner of a slit's root
    ProngRoot,  // from a corner of a slit's root, square to the slit
    NetSection, // through a slit's root
    Ligament,   // from a corner to the nearest boundary beyond the material
    Refined,    // found between lines of the grid, for certain forces
    Given,      // a line somebody asked about
};

struct CutSample
{
    SampleKind kind = SampleKind::Grid;
    int cut = 0;   // of SectionCuts::cuts
    int chord = 0; // of that cut
    Neck neck;
};

struct SampleOptions
{
    double spacing = 0.0;   // mm between lines; 0: size / 24, between 1 and 10
    double gridShift = 0.5; // where in its spacing the first line lies, 0 … 1
};

/// Cuts and the necks on them that count.
///
/// 8 directions, of each what is about square to a member; at each slit's root rays in steps of
/// 11.25° to 67.5° from both corners, the roots of the two prongs beside it, a ray from its middle,
/// and the line square to it just below; at every re-entrant corner the shortest ligament.
///
/// Source  the product's mechanics, 2.2.
class SectionCuts
{
public:
    explicit SectionCuts(PieceShape shape, const SampleOptions &options = {});

    const PieceShape &shape() const { return m_shape; }
    const std::vector<LineCut> &cuts() const { return m_cuts; }
    const std::vector<CutSample> &samples() const { return m_samples; }
    double spacing() const { return m_spacing; } // mm
    /// Somewhere more than waste hangs on it by less than 0.05 mm, or it touches itself: no cut is
    /// made there.
    bool isPinched() const { return m_isPinched; }
    /// Of the samples away from slits that part it into two pieces worth the name the shortest;
    /// null without one.
    const CutSample *thinnest() const
    {
        return m_thinnest < 0 ? nullptr : &m_samples[static_cast<std::size_t>(m_thinnest)];
    }

private:
    PieceShape m_shape;
    std::vector<LineCut> m_cuts;
    std::vector<CutSample> m_samples;
    double m_spacing = 1.0;
    int m_thinnest = -1;
    bool m_isPinched = false;
};

} // namespace fff
