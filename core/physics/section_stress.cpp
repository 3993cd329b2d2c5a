#include "core/physics/section_stress.h"

#include "core/physics/neck_stress.h"
#include "core/physics/sample_stresses.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// More N or N·mm than this are no force on a sheet, and too many digits for sums of squares.
constexpr double kLargestForce = 1e15;

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

std::vector<AppliedForce> usableForces(const std::vector<AppliedForce> &forces)
{
    std::vector<AppliedForce> kept = forces;
    for (AppliedForce &f : kept) {
        if (!isUsableForce(f))
            f = {};
    }
    return kept;
}

bool isUsableSheet(const SheetMaterial &sheet)
{
    return sheet.arealWeight.allFinite() && sheet.thickness > 0.0 && sheet.strength > 0.0 &&
           std::isfinite(sheet.thickness) && std::isfinite(sheet.strength);
}

CutShares cutShares(const SectionCuts &cuts, const std::vector<AppliedForce> &given,
                    double thickness)
{
    CutShares result;
    if (cuts.shape().outline.isEmpty())
        return result;
    result.sites = ForceSites(cuts.shape().outline, usableForces(given), thickness);
    PlusSites plus;
    for (const LineCut &cut : cuts.cuts()) {
        result.sites.onPlusSide(cut, plus);
        result.cuts.add(plus);
    }
    result.nets = onNetCuts(cuts.shape(), result.sites);
    return result;
}

SectionStress stressOf(const SectionCuts &cuts, const CutShares &shares,
                       const std::vector<AppliedForce> &given, const SheetMaterial &sheet,
                       const StressOptions &options)
{
    SampleStresses stresses(cuts, shares, given, sheet, options.notch);
    stresses.refine(options.refined);
    return stresses.result(0.0);
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
    if (shape.outline.isEmpty() || !(length > 0.0) || !std::isfinite(length) ||
        !isUsableSheet(sheet))
        return std::nullopt;
    const auto found = cutAt(shape.outline, {p0, (p1 - p0) / length}, 0.5 * length, 0.0);
    if (!found)
        return std::nullopt;
    const std::vector<AppliedForce> forces = usableForces(given);
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
