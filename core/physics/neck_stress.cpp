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
/// A cut that leans by less is square (1°, its cosine), and it is after so many turns of it.
constexpr double kSquare = 0.9998476951563913;
constexpr int kSquarings = 4;

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

/// How far the nearest force on one side of a cut is from a point, mm; endless without any.
double distanceToForce(const SummedForces &forces, const PlusSitesView &plus, bool isPlus,
                       const Vec2 &point)
{
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](int place) {
        if (forces.isLoaded(place))
            least = std::min(least, (forces.at(place).at - point).norm());
    };
    for (const PlusSites::Near &near : plus.near)
        if ((near.plus.share >= 0.5) == isPlus)
            look(near.place);
    const auto lookAlong = [&](int begin, int end) {
        forces.sites().boxes().walk(
            [&](const Box2 &box, std::size_t first, std::size_t last) {
                const int from = std::max(begin, static_cast<int>(first));
                const int to = std::min(end, static_cast<int>(last));
                return from < to && forces.loaded(from, to) > 0 &&
                       distanceToBox(box, point) < least;
            },
            [&](std::size_t i) {
                const int place = static_cast<int>(i);
                if (begin <= place && place < end && !plus.nearAt(place))
                    look(place);
                return false;
            });
    };
    int from = 0;
    for (const PlusSites::Run &run : plus.runs) {
        isPlus ? lookAlong(run.begin, run.end) : lookAlong(from, run.begin);
        from = run.end;
    }
    if (!isPlus)
        lookAlong(from, forces.sites().size());
    return least;
}

/// A force acts nearer to a neck's middle than it is long, or presses on a slit that is parted.
bool isNearForce(const LoadedPiece &piece, const Neck &neck, const PlusSitesView &sites)
{
    const SummedForces &forces = piece.forces;
    if (std::any_of(sites.near.begin(), sites.near.end(), [&](const PlusSites::Near &near) {
            return near.plus.isPartOfSlit() && forces.isLoaded(near.place);
        }))
        return true;
    const Vec2 middle = neck.middle();
    return forces.sites().boxes().any(
        [&](const Box2 &box) { return distanceToBox(box, middle) < neck.length; },
        [&](std::size_t i) {
            const int place = static_cast<int>(i);
            const AppliedForce &force = forces.at(place);
            return forces.isLoaded(place) &&
                   (force.at - middle).norm() - force.radius < neck.length;
        });
}

/// A force acts beside the holes that the cut crosses.
bool isBesideHoles(const SummedForces &forces, const LineCut &cut, const Neck &neck)
{
    const Vec2 direction = cut.line.direction.cwiseAbs();
    return forces.sites().boxes().any(
        [&](const Box2 &box) {
            const Vec2 half = 0.5 * box.size();
            const double left = cut.line.across(box.min + half);
            const double reach = half.x() * direction.y() + half.y() * direction.x();
            return left - reach < neck.zoneMinus && -left - reach < neck.zonePlus;
        },
        [&](std::size_t i) {
            const int place = static_cast<int>(i);
            const double left = cut.line.across(forces.at(place).at);
            return forces.isLoaded(place) && left < neck.zoneMinus && -left < neck.zonePlus;
        });
}

NeckDoubts doubtsOf(const LoadedPiece &piece, const LineCut &cut, const Neck &neck,
                    const PlusSitesView &sites, const CutForces &forces)
{
    NeckDoubts doubts;
    doubts.isStubby = neck.isStubby;
    doubts.isNearCorner = neck.isNearCorner;
    doubts.isCurved = neck.isCurved;
    doubts.isNarrow = neck.length < kPlateWidths * piece.sheet.thickness;
    doubts.isNearForce = isNearForce(piece, neck, sites);
    doubts.isRedundant = cut.chords.size() > 1 && isBesideHoles(piece.forces, cut, neck);
    // No bar within a piece is longer than twice its size: what would not buckle then is not asked
    // for how long it is.
    if (cut.chords.size() == 1 &&
        isSlenderlyPressed(forces, neck, piece.sheet, 2.0 * piece.shape.size)) {
        double length = 0.0;
        for (const bool isPlus : {true, false})
            length += distanceToForce(piece.forces, sites, isPlus, neck.middle());
        doubts.mayBuckle =
            std::isfinite(length) && isSlenderlyPressed(forces, neck, piece.sheet, length);
    }
    return doubts;
}

/// Through a foot, or a load that is spread, which is wider than the neck: it presses on the tip
/// beyond as much as on what is before, and bends neither.
bool isWithinPatch(const LoadedPiece &piece, const Neck &neck, const PlusSitesView &sites)
{
    return std::any_of(sites.near.begin(), sites.near.end(), [&](const PlusSites::Near &near) {
        const AppliedForce &force = piece.forces.at(near.place);
        const bool isParted = near.plus.share > 0.0 && near.plus.share < 1.0;
        const double least = force.kind == ForceKind::Foot ? piece.sheet.thickness : 0.0;
        return isParted && !near.plus.hasWalls && neck.length < std::max(2.0 * force.radius, least);
    });
}

struct FoundNeck
{
    CutChord cut;
    Neck neck;
};

/// What cuts the member at the line squarely: turned to how the section of the nearest chord runs,
/// until it leans no more. The squarest of these; `reach` mm is how far the first chord may be.
std::optional<FoundNeck> squareNeck(const PieceShape &shape, LineCutter &cutter, CutLine line,
                                    double reach, double length)
{
    std::optional<FoundNeck> best;
    for (int i = 0; i < kSquarings; ++i) {
        auto found = cutter.nearest(line, reach, length);
        if (!found)
            break;
        Neck neck =
            leaningNeck(shape, line, found->cut.chords[static_cast<std::size_t>(found->chord)]);
        if (!counts(neck) || (best && neck.straight <= best->neck.straight))
            break;
        measure(shape, found->cut, found->chord, neck);
        best = FoundNeck{*std::move(found), neck};
        if (neck.straight > kSquare)
            break;
        line = {neck.middle(), neck.across};
    }
    return best;
}

} // namespace

std::vector<PlusSites> onNetCuts(const PieceShape &shape, const ForceSites &sites)
{
    std::vector<PlusSites> plus;
    for (const std::optional<CutChord> &net : shape.netCuts)
        plus.push_back(net ? sites.onPlusSide(net->cut) : PlusSites());
    return plus;
}

std::vector<NetForce> netForces(const PieceShape &shape, const SummedForces &forces,
                                const std::vector<PlusSites> &plus, const Vec3 &arealWeight)
{
    const SectionOutline &outline = shape.outline;
    std::vector<NetForce> nets(shape.slits.size());
    for (std::size_t i = 0; i < nets.size(); ++i) {
        if (!shape.netCuts[i])
            continue;
        const LineCut &cut = shape.netCuts[i]->cut;
        // Without what its own partner does to the slit.
        PlusSites others = plus[i];
        SideForce own;
        const Vec2 root = shape.slits[i].root;
        forces.sites().boxes().any(
            [&root](const Box2 &box) { return distanceToBox(box, root) <= kSameRoot; },
            [&](std::size_t k) {
                const int place = static_cast<int>(k);
                const AppliedForce &f = forces.at(place);
                if (f.kind != ForceKind::Link || (f.at - root).norm() > kSameRoot)
                    return false;
                own += forces.sum(place, place + 1);
                others.setNear(place, {});
                return false;
            });
        nets[i].plus = plusForce(outline, cut, forces, others, arealWeight);
        nets[i].minus -= nets[i].plus;
        nets[i].minus -= own;
    }
    return nets;
}

NeckStress undoubted(const LoadedPiece &piece, const LineCut &cut, int chord, const Neck &neck,
                     SampleKind kind, const PlusSitesView &sites, const SideForce &plus)
{
    const SectionOutline &outline = piece.shape.outline;
    NeckStress result;
    result.kind = kind;
    result.begin = neck.begin;
    result.end = neck.end;
    result.length = neck.length;
    result.forces = forcesOn(outline, cut, chord, neck, plus);
    result.stress = nominalStress(result.forces, neck, piece.sheet, piece.notch);
    if (std::any_of(sites.near.begin(), sites.near.end(),
                    [](const PlusSites::Near &near) { return near.plus.isPartOfSlit(); })) {
        const SideForce tight =
            plusForce(outline, cut, piece.forces, sites, piece.sheet.arealWeight, SlitFit::Tight);
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
    return result;
}

bool isLocal(const LoadedPiece &piece, const Neck &neck, const PlusSitesView &sites,
             const NeckStress &stress)
{
    return isWithinPatch(piece, neck, sites) ||
           (neck.isCap && (stress.kind == SampleKind::Grid || stress.kind == SampleKind::Refined) &&
            isNearForce(piece, neck, sites));
}

void addDoubts(const LoadedPiece &piece, const LineCut &cut, const Neck &neck,
               const PlusSitesView &sites, NeckStress &stress)
{
    stress.doubts = doubtsOf(piece, cut, neck, sites, stress.forces);
    stress.isLocal = isLocal(piece, neck, sites, stress);
}

NeckStress neckStress(const LoadedPiece &piece, const LineCut &cut, int chord, const Neck &neck,
                      SampleKind kind, const PlusSitesView &sites, const SideForce &plus)
{
    NeckStress stress = undoubted(piece, cut, chord, neck, kind, sites, plus);
    addDoubts(piece, cut, neck, sites, stress);
    return stress;
}

/// What leans more when it has been squared (22.5°, its cosine) runs along an edge, round a corner:
/// it cuts off a sliver, and is thinner the nearer it comes to that edge. Whether a line of the
/// grid is near enough to find it is chance.
constexpr double kStillSquare = 0.9238795325112867;

std::optional<NeckStress> refined(const LoadedPiece &piece, const Neck &seed, double spacing)
{
    std::optional<NeckStress> best;
    LineCutter cutter(piece.shape.outline);
    cutter.focus(seed.middle(), 2.0 * spacing + seed.length); // all of the lines to come
    Vec2 across = seed.across; // what is square at one place nearly is at the next
    PlusSites sites;
    const auto use = [&](double shift) {
        const auto found =
            squareNeck(piece.shape, cutter, {seed.middle() + shift * seed.normal(), across},
                       spacing, seed.length);
        if (!found || found->neck.straight < kStillSquare)
            return 0.0;
        across = found->neck.across;
        const LineCut &cut = found->cut.cut;
        piece.forces.sites().onPlusSide(cut, sites);
        const SideForce plus =
            plusForce(piece.shape.outline, cut, piece.forces, sites, piece.sheet.arealWeight);
        NeckStress here =
            undoubted(piece, cut, found->cut.chord, found->neck, SampleKind::Refined, sites, plus);
        if (isLocal(piece, found->neck, sites, here))
            return 0.0;
        if (!best || here.neckUse > best->neckUse) {
            addDoubts(piece, cut, found->neck, sites, here);
            best = here;
        }
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
