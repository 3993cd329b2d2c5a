// The stresses on all samples of a piece under one load, and where it is worst between them.
#pragma once

#include "core/physics/neck_stress.h"

namespace fff {

/// In two steps, for those who compare ways to load a piece: of each what its samples say, and of
/// the worst ones what lies between these. What it is made of outlives it.
///
/// How far a neck is to be trusted takes as long to tell as its stress: it is asked of what may be
/// worst, and at the end of what is strained enough to be shown.
class SampleStresses
{
public:
    /// `room`  a list whose memory is used, for those who ask of many pieces
    SampleStresses(const SectionCuts &cuts, const CutShares &shares,
                   const std::vector<AppliedForce> &forces, const SheetMaterial &sheet,
                   const NotchRule &notch, std::vector<NeckStress> room = {});
    SampleStresses(const SampleStresses &) = delete;
    SampleStresses &operator=(const SampleStresses &) = delete;

    /// Of the necks that count so far, 0 without any.
    double worstNeck() { return useOf(result().worstNeck, &NeckStress::neckUse); }
    double worstCorner() { return useOf(result().worstCorner, &NeckStress::cornerUse); }
    /// Moves so many of the worst lines of the grid, each in a bracket of its own, to where it is
    /// worst.
    void refine(int count);
    /// Necks with a `cornerUse` below this, and not the worst, are without doubts, and may be
    /// local though they do not say so.
    const SectionStress &result(double judgedFrom);
    /// The memory of the result, which is none any more.
    std::vector<NeckStress> takeRoom() { return std::move(m_result.necks); }

private:
    const SectionStress &result();
    double useOf(int neck, double NeckStress::*use) const
    {
        return neck < 0 ? 0.0 : m_result.necks[static_cast<std::size_t>(neck)].*use;
    }
    bool counts(std::size_t neck);
    int worst(double NeckStress::*use, std::size_t count, bool isOfGrid);

    const SectionCuts &m_cuts;
    const CutShares &m_shares;
    std::vector<AppliedForce> m_forces;
    SummedForces m_summed;
    LoadedPiece m_piece;
    SectionStress m_result;
    std::vector<char> m_isJudged; // by sample
    bool m_isUsable = false;
    bool m_isFound = false; // the worst ones
};

} // namespace fff
