#include "core/physics/sample_stresses.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Lines of the grid nearer than this many spacings are refined to the same place.
constexpr double kSameBracket = 1.5;

/// Of lines of the grid that are strained as much, up to this share, the first one is refined: at
/// symmetrical places rounding would choose.
constexpr double kSameUse = 1e-5;

/// What is left over, as a share of the largest force or, over the size of the piece, moment.
double shareOf(const SectionCuts &cuts, const SideForce &rest,
               const std::vector<AppliedForce> &forces, const Vec3 &arealWeight)
{
    const double size = cuts.shape().size;
    double scale = cuts.shape().outline.total().area * arealWeight.norm();
    for (const AppliedForce &f : forces)
        scale = std::max({scale, f.force.norm(), size > 0.0 ? f.moment.norm() / size : 0.0});
    if (!(scale > 0.0) || !(size > 0.0))
        return 0.0;
    return std::max(rest.force.norm(), rest.moment.norm() / size) / scale;
}

/// Crosses the same member, no more than `reach` mm away.
bool isBeside(const Neck &neck, const Neck &other, double reach)
{
    const Vec2 way = neck.middle() - other.middle();
    return way.squaredNorm() < reach * reach &&
           std::abs(other.across.dot(way)) < 0.5 * other.length;
}

} // namespace

SampleStresses::SampleStresses(const SectionCuts &cuts, const CutShares &shares,
                               const std::vector<AppliedForce> &forces, const SheetMaterial &sheet,
                               const NotchRule &notch, std::vector<NeckStress> room)
    : m_cuts(cuts), m_shares(shares), m_forces(usableForces(forces)),
      m_summed(cuts.shape().outline, shares.sites, m_forces),
      m_piece{cuts.shape(), m_summed, sheet, notch,
              netForces(cuts.shape(), m_summed, shares.nets, sheet.arealWeight)}
{
    m_result.necks = std::move(room);
    m_result.necks.clear();
    const SectionOutline &outline = cuts.shape().outline;
    if (outline.isEmpty() || !isUsableSheet(sheet))
        return;
    m_isUsable = !cuts.isPinched() && std::all_of(forces.begin(), forces.end(), isUsableForce);
    m_result.imbalance = allForce(outline, m_forces, sheet.arealWeight);
    m_result.imbalanceShare = shareOf(cuts, m_result.imbalance, m_forces, sheet.arealWeight);
    m_result.necks.reserve(cuts.samples().size() +
                           static_cast<std::size_t>(StressOptions().refined));
    int last = -1;
    SideForce plus;
    for (const CutSample &sample : cuts.samples()) {
        const auto index = static_cast<std::size_t>(sample.cut);
        const LineCut &cut = cuts.cuts()[index];
        if (sample.cut != last)
            plus = plusForce(outline, cut, m_summed, shares.cuts[index], sheet.arealWeight);
        last = sample.cut;
        m_result.necks.push_back(undoubted(m_piece, cut, sample.chord, sample.neck, sample.kind,
                                           shares.cuts[index], plus));
    }
    m_isJudged.assign(m_result.necks.size(), 0);
}

/// Whether it is local is asked of those alone that this decides.
bool SampleStresses::counts(std::size_t index)
{
    NeckStress &neck = m_result.necks[index];
    if (index < m_isJudged.size() && !m_isJudged[index]) {
        const CutSample &sample = m_cuts.samples()[index];
        const auto cut = static_cast<std::size_t>(sample.cut);
        addDoubts(m_piece, m_cuts.cuts()[cut], sample.neck, m_shares.cuts[cut], neck);
        m_isJudged[index] = 1;
    }
    return neck.counts();
}

/// Of the first `count` necks.
int SampleStresses::worst(double NeckStress::*use, std::size_t count, bool isOfGrid)
{
    const double enough = isOfGrid ? 1.0 + kSameUse : 1.0;
    int worst = -1;
    for (std::size_t i = 0; i < count; ++i) {
        const NeckStress &neck = m_result.necks[i];
        if (neck.isCovered || (isOfGrid && !(neck.kind == SampleKind::Grid && neck.*use > 0.0)))
            continue;
        if ((worst < 0 || neck.*use > enough * useOf(worst, use)) && counts(i))
            worst = static_cast<int>(i);
    }
    return worst;
}

void SampleStresses::refine(int count)
{
    if (m_result.necks.empty())
        return; // of what no sheet is made of
    const std::vector<CutSample> &samples = m_cuts.samples();
    m_isFound = false;
    for (int k = 0; k < count; ++k) {
        const int worstOfGrid = worst(&NeckStress::neckUse, samples.size(), true);
        if (worstOfGrid < 0)
            return;
        const Neck &seed = samples[static_cast<std::size_t>(worstOfGrid)].neck;
        const auto found = refined(m_piece, seed, m_cuts.spacing());
        if (!found)
            return;
        m_result.necks.push_back(*found);
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (samples[i].kind == SampleKind::Grid &&
                isBeside(samples[i].neck, seed, kSameBracket * m_cuts.spacing()))
                m_result.necks[i].isCovered = true;
    }
}

const SectionStress &SampleStresses::result()
{
    if (!m_isFound) {
        m_result.worstNeck = worst(&NeckStress::neckUse, m_result.necks.size(), false);
        m_result.worstCorner = worst(&NeckStress::cornerUse, m_result.necks.size(), false);
        m_result.isWorkedOut = m_isUsable && m_result.worstNeck >= 0;
    }
    m_isFound = true;
    return m_result;
}

const SectionStress &SampleStresses::result(double judgedFrom)
{
    for (std::size_t i = 0; i < m_isJudged.size(); ++i)
        if (m_result.necks[i].cornerUse >= judgedFrom)
            counts(i);
    return result();
}

} // namespace fff
