#include "tests/core/physics/reference_comparison.h"
#include "tests/core/physics/reference_section.h"

#include <cmath>
#include <numbers>

namespace fff::test {

namespace {

constexpr double kOnEdge = 0.05;         // mm, of the ends of cuts: files round
constexpr double kSmoothTurn = 0.35;     // radians between edges that stand for a curve
constexpr double kNoticeableLean = 0.03; // radians; sigma changes by a thousandth
constexpr double kBalancedShare = 1e-3;  // of what a solver's file says to so many digits
constexpr int kPlaces = 65;              // along a cut whose middle is in no material

/// The outward normal where a cut ends; nothing in a corner, or where it ends on no edge.
std::optional<Vec2> normalAt(const Region &region, const Vec2 &end)
{
    std::vector<Vec2> normals;
    const auto collect = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &p = ring[i], along = ring[(i + 1) % ring.size()] - p;
            const double length = along.norm();
            if (!(length > 0.0))
                continue;
            const double at = std::clamp((end - p).dot(along) / (length * length), 0.0, 1.0);
            if ((p + at * along - end).norm() < kOnEdge)
                normals.emplace_back(along.y() / length, -along.x() / length);
        }
    };
    collect(region.outer);
    for (const Polygon &hole : region.holes)
        collect(hole);
    if (normals.empty())
        return {};
    Vec2 mean = Vec2::Zero();
    for (const Vec2 &normal : normals) {
        if (std::abs(std::atan2(cross(normals.front(), normal), normals.front().dot(normal))) >
            kSmoothTurn)
            return {};
        mean += normal;
    }
    return mean.normalized();
}

/// sigma_lin of a cut across a member, from the solver's forces on one that leans: the cut's own is
/// the smaller by cos² of the lean, since it is longer than the member is wide. Nothing where the
/// cut does not lean, or the file does not say all forces.
std::optional<double> alongMember(const ReferenceCut &cut, const ReferenceSection &section)
{
    std::optional<Vec2> from, to;
    for (const Region &region : section.regions) {
        from = from ? from : normalAt(region, cut.from);
        to = to ? to : normalAt(region, cut.to);
    }
    if (!from || !to)
        return {};
    const Vec2 chord = cut.to - cut.from, bisector = *to - *from;
    if (!(bisector.norm() > 0.0))
        return {};
    const double lean = std::atan2(cross(chord, bisector), chord.dot(bisector));
    if (std::abs(lean) < kNoticeableLean || std::abs(lean) > 0.25 * std::numbers::pi)
        return {};
    const auto N = cut.said("N"), V = cut.said("V"), Mn = cut.said("Mn"), Mv = cut.said("Mv"),
               T = cut.said("T");
    if (!N || !V || !Mn || !Mv || !T)
        return {};
    // m is the cut's direction v turned by −90°; both turn by the lean.
    const double l = chord.norm() * std::cos(lean), t = section.thickness;
    const double axial = *N * std::cos(lean) + *V * std::sin(lean);
    const double bending = *Mv * std::cos(lean) - *T * std::sin(lean);
    return std::abs(axial) / (l * t) + 6.0 * std::abs(*Mn) / (t * l * l) +
           6.0 * std::abs(bending) / (l * t * t);
}

/// Of the stretch that the cut's middle is in; of a cut across an opening of the largest of all.
std::optional<NeckStress> onCut(const ReferencePiece &piece, const ReferenceCut &cut, bool &isWhole)
{
    for (const PieceShape &shape : piece.shapes) {
        isWhole = true;
        if (auto found = stressOnLine(shape, piece.forces, piece.sheet, cut.from, cut.to))
            return found;
    }
    isWhole = false;
    std::optional<NeckStress> largest;
    for (int i = 0; i + 1 < kPlaces; ++i) {
        const auto at = [&](int k) -> Vec2 {
            return cut.from + static_cast<double>(k) / (kPlaces - 1) * (cut.to - cut.from);
        };
        for (const PieceShape &shape : piece.shapes) {
            const auto found = stressOnLine(shape, piece.forces, piece.sheet, at(i), at(i + 1));
            if (found && (!largest || found->stress.linear() > largest->stress.linear()))
                largest = found;
        }
    }
    return largest;
}

/// What ours says of itself: beams do not reach there.
bool isDoubtful(const NeckStress &neck)
{
    const NeckDoubts &doubts = neck.doubts;
    const bool bendsAcross = neck.stress.plate > neck.stress.axial + neck.stress.inPlane;
    return doubts.isStubby || doubts.isNearForce || doubts.isNearCorner || doubts.isCurved ||
           doubts.isRedundant || (doubts.isNarrow && bendsAcross) || neck.isLocal;
}

Judging judgingOf(const Tolerances &tolerances, const std::string &cut, bool isJudgeable,
                  const NeckStress &ours)
{
    if (!isJudgeable || tolerances.isTold(cut))
        return Judging::Told;
    const auto rule = tolerances.cuts.find(cut);
    const bool isNamed = rule != tolerances.cuts.end() && rule->second.beam;
    return !isNamed && isDoubtful(ours) ? Judging::Flagged : Judging::Judged;
}

void compareCut(const Comparison &comparison, const std::string &kind, const ReferencePiece &piece,
                const ReferenceCut &cut)
{
    const auto &[given, tolerances, report] = comparison;
    const std::optional<double> linear = cut.said("sigma_lin");
    if (!linear)
        return;
    const std::string what = kind + "beam " + cut.name;
    bool isWhole = true;
    const std::optional<NeckStress> ours = onCut(piece, cut, isWhole);
    if (!ours) {
        report.claim(what, "some stress", "no neck", Judging::Told);
        return;
    }
    const std::optional<double> across =
        alongMember(cut, given.sections[static_cast<std::size_t>(cut.section)]);
    report.share(what + (across ? " (leans)" : ""), across.value_or(*linear), ours->stress.linear(),
                 tolerances.beamOf(cut.name),
                 judgingOf(tolerances, cut.name, piece.isClampedOnce && isWhole, *ours));
}

void compareTruth(const Comparison &comparison, const std::string &kind,
                  const ReferenceTruth &truth, const std::optional<Equilibrium> &rigid)
{
    const auto &[given, tolerances, report] = comparison;
    if (truth.cuts.empty())
        return;
    std::optional<ReferenceForces> carried = forcesOf(given, truth);
    const bool isOurs = !carried && isDeterminate(rigid);
    if (isOurs)
        carried = forcesOf(*rigid);
    if (!carried) {
        report.claim(kind + "beam forces", "known", "not told", Judging::Told);
        return;
    }
    for (std::size_t i = 0; i < given.sections.size(); ++i) {
        const ReferencePiece piece = pieceOf(given, static_cast<int>(i), *carried);
        if (piece.shapes.size() == 1 && !piece.forces.empty()) {
            const SectionStress all =
                stressOf(SectionCuts(piece.shapes.front()), piece.forces, piece.sheet);
            report.number(kind + "left over on " + given.sections[i].id, 0.0, all.imbalanceShare,
                          kBalancedShare, isOurs ? Judging::Judged : Judging::Told);
        }
        for (const ReferenceCut &cut : truth.cuts) {
            if (cut.section == static_cast<int>(i))
                compareCut(comparison, kind, piece, cut);
        }
    }
}

} // namespace

void compareBeams(const Comparison &comparison, const std::optional<Equilibrium> &rigid)
{
    const ReferenceCase &given = comparison.given;
    compareTruth(comparison, "", given.truth, rigid);
    compareTruth(comparison, "contact ", given.contact, {});
    compareTruth(comparison, "play ", given.contactWithPlay, {});
}

} // namespace fff::test
