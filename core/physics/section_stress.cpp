#include "core/physics/section_stress.h"

#include "core/physics/neck_stress.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Lines of the grid nearer than this many spacings are refined to the same place.
constexpr double kSameBracket = 1.5;

/// More N or N·mm than this are no force on a sheet, and too many digits for sums of squares.
constexpr double kLargestForce = 1e15;

bool isUsable(const SheetMaterial &sheet)
{
    return sheet.arealWeight.allFinite() && sheet.thickness > 0.0 && sheet.strength > 0.0 &&
           std::isfinite(sheet.thickness) && std::isfinite(sheet.strength);
}

std::vector<AppliedForce> usable(const std::vector<AppliedForce> &forces)
{
    std::vector<AppliedForce> kept = forces;
    for (AppliedForce &f : kept) {
        if (!isUsableForce(f))
            f = {};
    }
    return kept;
}

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
    return way.norm() < reach && std::abs(other.across.dot(way)) < 0.5 * other.length;
}

/// Moves the worst lines of the grid, each in a bracket of its own, to where it is worst.
void refineWorst(const SectionCuts &cuts, const LoadedPiece &piece, int count,
                 std::vector<NeckStress> &necks)
{
    const std::vector<CutSample> &samples = cuts.samples();
    for (int k = 0; k < count; ++k) {
        int worst = -1;
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (samples[i].kind == SampleKind::Grid && necks[i].counts() &&
                necks[i].neckUse >
                    (worst < 0 ? 0.0 : necks[static_cast<std::size_t>(worst)].neckUse))
                worst = static_cast<int>(i);
        if (worst < 0)
            return;
        const Neck &seed = samples[static_cast<std::size_t>(worst)].neck;
        const auto found = refined(piece, seed, cuts.spacing());
        if (!found)
            return;
        necks.push_back(*found);
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (samples[i].kind == SampleKind::Grid &&
                isBeside(samples[i].neck, seed, kSameBracket * cuts.spacing()))
                necks[i].isCovered = true;
    }
}

void findWorst(SectionStress &stress)
{
    for (std::size_t i = 0; i < stress.necks.size(); ++i) {
        const NeckStress &neck = stress.necks[i];
        if (!neck.counts())
            continue;
        const auto worseThan = [&](int other, double NeckStress::*use) {
            return other < 0 || neck.*use > stress.necks[static_cast<std::size_t>(other)].*use;
        };
        if (worseThan(stress.worstNeck, &NeckStress::neckUse))
            stress.worstNeck = static_cast<int>(i);
        if (worseThan(stress.worstCorner, &NeckStress::cornerUse))
            stress.worstCorner = static_cast<int>(i);
    }
}

} // namespace

bool isUsableForce(const AppliedForce &f)
{
    const auto isForce = [](const Vec3 &a) {
        return a.allFinite() && a.cwiseAbs().maxCoeff() <= kLargestForce;
    };
    return f.at.allFinite() && isForce(f.force) && isForce(f.moment) && std::isfinite(f.radius) &&
           f.slit.root.allFinite() && f.slit.opening.allFinite() && std::isfinite(f.slit.depth) &&
           std::isfinite(f.slit.width);
}

CutShares cutShares(const SectionCuts &cuts, const std::vector<AppliedForce> &given,
                    double thickness)
{
    CutShares result;
    if (cuts.shape().outline.isEmpty())
        return result;
    result.sites = ForceSites(cuts.shape().outline, usable(given), thickness);
    result.cuts.reserve(cuts.cuts().size());
    for (const LineCut &cut : cuts.cuts())
        result.cuts.push_back(result.sites.onPlusSide(cut));
    result.nets = onNetCuts(cuts.shape(), result.sites);
    return result;
}

SectionStress stressOf(const SectionCuts &cuts, const CutShares &shares,
                       const std::vector<AppliedForce> &given, const SheetMaterial &sheet,
                       const StressOptions &options)
{
    SectionStress result;
    if (cuts.shape().outline.isEmpty() || !isUsable(sheet))
        return result;
    const std::vector<AppliedForce> forces = usable(given);
    const PieceShape &shape = cuts.shape();
    const SummedForces summed(shape.outline, shares.sites, forces);
    const LoadedPiece piece{shape, summed, sheet, options.notch,
                            netForces(shape, summed, shares.nets, sheet.arealWeight)};
    result.imbalance = allForce(shape.outline, forces, sheet.arealWeight);
    result.imbalanceShare = shareOf(cuts, result.imbalance, forces, sheet.arealWeight);
    result.necks.reserve(cuts.samples().size() + static_cast<std::size_t>(options.refined));
    int last = -1;
    SideForce plus;
    for (const CutSample &sample : cuts.samples()) {
        const auto index = static_cast<std::size_t>(sample.cut);
        const LineCut &cut = cuts.cuts()[index];
        if (sample.cut != last)
            plus = plusForce(shape.outline, cut, summed, shares.cuts[index], sheet.arealWeight);
        last = sample.cut;
        result.necks.push_back(neckStress(piece, cut, sample.chord, sample.neck, sample.kind,
                                          shares.cuts[index], plus));
    }
    refineWorst(cuts, piece, options.refined, result.necks);
    findWorst(result);
    result.isWorkedOut = result.worstNeck >= 0 && !cuts.isPinched() &&
                         std::all_of(given.begin(), given.end(),
                                     [](const AppliedForce &f) { return isUsableForce(f); });
    return result;
}

SectionStress stressOf(const SectionCuts &cuts, const std::vector<AppliedForce> &forces,
                       const SheetMaterial &sheet, const StressOptions &options)
{
    return stressOf(cuts, cutShares(cuts, forces, sheet.thickness), forces, sheet, options);
}

std::optional<NeckStress> stressOnLine(const PieceShape &shape,
                                       const std::vector<AppliedForce> &given,
                                       const SheetMaterial &sheet, const Vec2 &p0, const Vec2 &p1,
                                       const NotchRule &notch)
{
    const double length = (p1 - p0).norm();
    if (shape.outline.isEmpty() || !(length > 0.0) || !std::isfinite(length) || !isUsable(sheet))
        return std::nullopt;
    const auto found = cutAt(shape.outline, {p0, (p1 - p0) / length}, 0.5 * length, 0.0);
    if (!found)
        return std::nullopt;
    const std::vector<AppliedForce> forces = usable(given);
    const Neck neck = neckOf(shape, found->cut, found->chord);
    const ForceSites sites(shape.outline, forces, sheet.thickness);
    const SummedForces summed(shape.outline, sites, forces);
    const PlusSites onPlus = sites.onPlusSide(found->cut);
    const SideForce plus = plusForce(shape.outline, found->cut, summed, onPlus, sheet.arealWeight);
    const LoadedPiece piece{shape, summed, sheet, notch,
                            netForces(shape, summed, onNetCuts(shape, sites), sheet.arealWeight)};
    return neckStress(piece, found->cut, found->chord, neck, SampleKind::Given, onPlus, plus);
}

} // namespace fff
