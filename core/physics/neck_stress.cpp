#include "core/physics/neck_stress.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fff {

namespace {

/// Plates thinner than this many thicknesses across bend like bars.
constexpr double kPlateWidths = 3.0;
/// Of Euler's load: from there on compression may buckle a leg.
constexpr double kBucklingShare = 1.0 / 3.0;
/// A link whose root is this near to a slit's is in that slit, mm.
constexpr double kSameRoot = 0.1;
/// Steps of golden section: the bracket of two spacings shrinks to a fiftieth.
constexpr int kGoldenSteps = 8;
/// A cut that leans by less is square (1°, radians), and it is after so many turns of it.
constexpr double kSquareLean = 0.017453292519943295;
constexpr int kSquarings = 4;

bool isLoaded(const AppliedForce &force)
{
    return !force.force.isZero(0.0) || !force.moment.isZero(0.0);
}

Neck inShadow(const Neck &neck)
{
    Neck lit = neck;
    lit.begin = neck.shadowBegin;
    lit.end = neck.shadowEnd;
    lit.length = neck.shadowLength;
    return lit;
}

/// What comes around the root of the slit that shadows a neck, as the neck's plus side sees it.
SideForce aroundRoot(const LoadedPiece &piece, const Neck &neck)
{
    const NetForce &net = piece.nets[static_cast<std::size_t>(neck.shadowSlit)];
    // What acts beyond the net section; seen from there the neck's own side is the other one.
    SideForce beyond = neck.isOnNetPlus ? net.minus : net.plus;
    if (!neck.isNetOnPlus) {
        beyond.force = -beyond.force;
        beyond.moment = -beyond.moment;
    }
    return beyond;
}

/// Compression above a share of the load at which a bar buckles that is as long as from the loaded
/// place next to the cut on one side to that on the other, clamped there and free here (Euler).
bool isSlenderlyPressed(const CutForces &forces, const Neck &neck, const SheetMaterial &sheet,
                        double length)
{
    const double l = neck.length, t = sheet.thickness;
    const double second = std::min(l, t) * std::min(l, t) * l * t / 12.0;
    const double euler =
        std::numbers::pi * std::numbers::pi * sheet.modulus * second / (4.0 * length * length);
    return -forces.axial > kBucklingShare * euler;
}

NeckDoubts doubtsOf(const LoadedPiece &piece, const LineCut &cut, const Neck &neck,
                    std::span<const PlusShare> shares, const CutForces &forces)
{
    NeckDoubts doubts;
    doubts.isStubby = neck.isStubby;
    doubts.isNearCorner = neck.isNearCorner;
    doubts.isCurved = neck.isCurved;
    doubts.isNarrow = neck.length < kPlateWidths * piece.sheet.thickness;
    const Vec2 middle = neck.middle();
    constexpr double kNone = std::numeric_limits<double>::infinity();
    double plus = kNone, minus = kNone;
    for (std::size_t i = 0; i < piece.forces.size(); ++i) {
        if (!isLoaded(piece.forces[i]))
            continue;
        const double away = (piece.forces[i].at - middle).norm();
        if (away - piece.forces[i].radius < neck.length || shares[i].isPartOfSlit())
            doubts.isNearForce = true;
        double &side = shares[i].share >= 0.5 ? plus : minus;
        side = std::min(side, away);
        const double left = cut.line.across(piece.forces[i].at);
        if (cut.chords.size() > 1 && left < neck.zoneMinus && -left < neck.zonePlus)
            doubts.isRedundant = true;
    }
    if (cut.chords.size() == 1 && plus < kNone && minus < kNone)
        doubts.mayBuckle = isSlenderlyPressed(forces, neck, piece.sheet, plus + minus);
    return doubts;
}

/// Through a foot, or a load that is spread, which is wider than the neck: it presses on the tip
/// beyond as much as on what is before, and bends neither.
bool isWithinPatch(const LoadedPiece &piece, const Neck &neck, std::span<const PlusShare> shares)
{
    for (std::size_t i = 0; i < piece.forces.size(); ++i) {
        const AppliedForce &force = piece.forces[i];
        const bool isParted = shares[i].share > 0.0 && shares[i].share < 1.0;
        const double least = force.kind == ForceKind::Foot ? piece.sheet.thickness : 0.0;
        if (isParted && !shares[i].hasWalls && neck.length < std::max(2.0 * force.radius, least))
            return true;
    }
    return false;
}

struct FoundNeck
{
    CutChord cut;
    Neck neck;
};

/// What cuts the member at the line squarely: turned to how the section of the nearest chord runs,
/// until it leans no more. The squarest of these; `reach` mm is how far the first chord may be.
std::optional<FoundNeck> squareNeck(const PieceShape &shape, CutLine line, double reach)
{
    std::optional<FoundNeck> best;
    std::vector<LineCut> cuts;
    for (int i = 0; i < kSquarings; ++i) {
        cutsOn(shape.outline, line, 1, cuts);
        const LineCut *cut = nullptr;
        int chord = 0;
        double least = reach;
        for (const LineCut &c : cuts) {
            for (std::size_t k = 0; k < c.chords.size(); ++k) {
                const double away = std::max({0.0, c.chords[k].from, -c.chords[k].to});
                if (away < least) {
                    least = away;
                    cut = &c;
                    chord = static_cast<int>(k);
                }
            }
        }
        if (!cut)
            break;
        const Neck neck = neckOf(shape, *cut, chord);
        if (!counts(neck) || (best && neck.lean >= best->neck.lean))
            break;
        best = FoundNeck{{*cut, chord}, neck};
        if (neck.lean < kSquareLean)
            break;
        line = {neck.middle(), neck.across};
    }
    return best;
}

} // namespace

std::vector<NetForce> netForces(const PieceShape &shape, const std::vector<ForceSite> &sites,
                                const std::vector<AppliedForce> &forces, const Vec3 &arealWeight)
{
    std::vector<NetForce> nets(shape.slits.size());
    std::vector<PlusShare> shares(sites.size());
    for (std::size_t i = 0; i < nets.size(); ++i) {
        if (!shape.netCuts[i])
            continue;
        const LineCut &cut = *shape.netCuts[i];
        SideForce own; // what its own partner does to the slit
        for (std::size_t k = 0; k < sites.size(); ++k) {
            shares[k] = plusShare(cut, sites[k]);
            const AppliedForce &f = forces[k];
            if (f.kind != ForceKind::Link || (f.at - shape.slits[i].root).norm() > kSameRoot)
                continue;
            shares[k] = {};
            own.force += f.force;
            own.moment += SideForce{f.force, f.moment}.momentAbout(shape.outline.base(), f.at);
        }
        nets[i].plus = plusForce(shape.outline, cut, forces, shares, arealWeight);
        nets[i].minus.force = -nets[i].plus.force - own.force;
        nets[i].minus.moment = -nets[i].plus.moment - own.moment;
    }
    return nets;
}

NeckStress neckStress(const LoadedPiece &piece, const LineCut &cut, int chord, const Neck &neck,
                      SampleKind kind, std::span<const PlusShare> shares, const SideForce &plus)
{
    const SectionOutline &outline = piece.shape.outline;
    NeckStress result;
    result.kind = kind;
    result.begin = neck.begin;
    result.end = neck.end;
    result.length = neck.length;
    result.forces = forcesOn(outline, cut, chord, neck, plus);
    result.stress = nominalStress(result.forces, neck, piece.sheet, piece.notch);
    if (std::any_of(shares.begin(), shares.end(),
                    [](const PlusShare &share) { return share.isPartOfSlit(); })) {
        const SideForce tight =
            plusForce(outline, cut, piece.forces, shares, piece.sheet.arealWeight, SlitFit::Tight);
        const CutForces forces = forcesOn(outline, cut, chord, neck, tight);
        const NominalStress stress = nominalStress(forces, neck, piece.sheet, piece.notch);
        if (stress.neck > result.stress.neck) {
            result.forces = forces;
            result.stress = stress;
        }
    }
    if (neck.shadowSlit >= 0) {
        const Neck lit = inShadow(neck);
        const SideForce around = aroundRoot(piece, neck);
        const CutForces forces = forcesOn(outline, cut, chord, lit, around);
        const NominalStress stress = nominalStress(forces, lit, piece.sheet, piece.notch);
        if (stress.neck > result.stress.neck) {
            result.isShadowed = true;
            result.begin = lit.begin;
            result.end = lit.end;
            result.length = lit.length;
            result.forces = forces;
            result.stress = stress;
        }
    }
    const double strength = piece.sheet.strength;
    result.neckUse = strength > 0.0 ? result.stress.neck / strength : 0.0;
    result.cornerUse = strength > 0.0 ? result.stress.corner / strength : 0.0;
    result.doubts = doubtsOf(piece, cut, neck, shares, result.forces);
    result.isLocal = isWithinPatch(piece, neck, shares) ||
                     (neck.isCap && result.doubts.isNearForce &&
                      (kind == SampleKind::Grid || kind == SampleKind::Refined));
    return result;
}

std::optional<NeckStress> refined(const LoadedPiece &piece, const std::vector<ForceSite> &sites,
                                  const Neck &seed, double spacing)
{
    std::vector<PlusShare> shares(sites.size());
    std::optional<NeckStress> best;
    Vec2 across = seed.across; // what is square at one place nearly is at the next
    const auto use = [&](double shift) {
        const auto found =
            squareNeck(piece.shape, {seed.middle() + shift * seed.normal(), across}, spacing);
        if (!found)
            return 0.0;
        across = found->neck.across;
        const LineCut &cut = found->cut.cut;
        std::transform(sites.begin(), sites.end(), shares.begin(),
                       [&cut](const ForceSite &site) { return plusShare(cut, site); });
        const SideForce plus =
            plusForce(piece.shape.outline, cut, piece.forces, shares, piece.sheet.arealWeight);
        const NeckStress here = neckStress(piece, cut, found->cut.chord, found->neck,
                                           SampleKind::Refined, shares, plus);
        if (here.isLocal)
            return 0.0;
        if (!best || here.neckUse > best->neckUse)
            best = here;
        return here.neckUse;
    };
    use(0.0);
    constexpr double kGolden = std::numbers::phi - 1.0;
    double low = -spacing, high = spacing;
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    double atA = use(a), atB = use(b);
    for (int i = 0; i < kGoldenSteps; ++i) {
        if (atA > atB) {
            high = b;
            b = a;
            atB = atA;
            a = high - kGolden * (high - low);
            atA = use(a);
        } else {
            low = a;
            a = b;
            atA = atB;
            b = low + kGolden * (high - low);
            atB = use(b);
        }
    }
    return best;
}

} // namespace fff
