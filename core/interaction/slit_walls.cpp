#include "core/interaction/slit_walls.h"

#include "core/analysis/checks.h"
#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/wholeness.h"
#include "core/analysis/joining_move.h"
#include "core/analysis/trial.h"
#include "core/base/tolerances.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

constexpr SectionId kGround{1}, kGuest{2};
/// So many thicknesses a section in the making goes beyond its slit: what a contour round it is at
/// least.
constexpr double kBeyondSlit = 3.0;
/// Where beside the outer half of a slit, the one that is cut, it is looked for walls first.
constexpr double kLooks[] = {0.55, 0.7, 0.85};
/// A slit that was moved in may become so many times as long as it was drawn, and so many
/// thicknesses more: along an edge it would saw the section in two.
constexpr double kSawsAsLong = 2.0, kSawsDeeper = 4.0;
/// What a slit at the wrong place breaks.
constexpr Finder kWholeness[] = {findConnection, findLoosePieces, findJointFaults,
                                 findFailures,   findDivided,     findLooseJoints};

/// The two alone.
Document pairOf(const Document &document, Section ground, Section guest)
{
    Document pair;
    pair.stocks = document.stocks;
    pair.currentStock = document.currentStock;
    pair.nextId = document.nextId;
    for (auto [section, id] : {std::pair(&ground, kGround), std::pair(&guest, kGuest)}) {
        section->id = id;
        section->made = {};
        section->parent.reset();
        section->marks.clear();
        pair.sections.push_back(std::make_shared<const Section>(std::move(*section)));
    }
    return pair;
}

AnalysisPointer analysedPair(const Document &document, const Section &ground, const Section &guest)
{
    AnalysisCaches caches;
    return analyseNext(evaluate(pairOf(document, ground, guest)), caches);
}

/// A rectangle across the slit; none for one that is too short to have a direction.
std::optional<Section> standIn(const Document &document, const Section &ground, const Vec2 &from,
                               const Vec2 &to)
{
    const double length = (to - from).norm();
    const Stock *stock = document.find(document.currentStock);
    if (length < kMinOverlap || !stock)
        return {};
    const double beyond = kBeyondSlit * stock->thickness;
    Section section;
    section.stock = stock->id;
    section.frame = {ground.frame.toWorld(from), ground.frame.directionToWorld(to - from) / length,
                     ground.frame.normal()};
    const Result<Contour> contour = Contour::fromPolygon(
        {{0.0, -beyond}, {length + beyond, -beyond}, {length + beyond, beyond}, {0.0, beyond}});
    const Result<ShapePointer> shape =
        contour ? Shape::make(*contour) : Result<ShapePointer>(tl::unexpected(contour.error()));
    if (!shape)
        return {};
    section.shape = *shape;
    return section;
}

/// Somewhere along what is cut it has both walls.
bool isBetweenWalls(const Document &document, const Interior &interior, const Vec2 &from,
                    const Vec2 &to)
{
    const Stock *stock = document.find(document.currentStock);
    if (!stock)
        return false;
    const Vec2 beside =
        (0.5 * stock->thickness + kGripWall) * perpendicular((to - from).normalized());
    return std::any_of(std::begin(kLooks), std::end(kLooks), [&](double along) {
        const Vec2 at = from + along * (to - from);
        return interior.contains(at + beside) && interior.contains(at - beside);
    });
}

} // namespace

SlitJudged judgedSlit(const Document &document, const Section &ground, const Section &guest)
{
    const AnalysisPointer analysis = analysedPair(document, ground, guest);
    SlitJudged judged;
    if (analysis->assembly.joints.begin() == analysis->assembly.joints.end())
        return judged;
    const JointGrips &grips = analysis->grips.of(*analysis->assembly.joints.begin());
    judged.isHeld = !grips.held.empty();
    if (grips.loose && grips.loose->why == NoGrip::OneWall && grips.loose->isInA)
        judged.missing = ground.frame.directionToWorld(grips.loose->missing).normalized();
    return judged;
}

SlitJudged judgedSlit(const Document &document, const Section &ground, const Interior &interior,
                      const Vec2 &from, const Vec2 &to)
{
    if ((to - from).norm() < kMinOverlap)
        return {};
    if (isBetweenWalls(document, interior, from, to))
        return {true, {}};
    const std::optional<Section> guest = standIn(document, ground, from, to);
    return guest ? judgedSlit(document, ground, *guest) : SlitJudged();
}

std::optional<Parent> movedIn(const Document &document, const Section &ground,
                              const Interior &interior, const Parent &slit, const Vec3 &missing)
{
    const std::optional<Section> guest = standIn(document, ground, slit.slitFrom, slit.slitTo);
    if (!guest)
        return {};
    const AnalysisPointer analysis = analysedPair(document, ground, *guest);
    const std::optional<JoiningMove> move = moveAlong(*analysis, kGuest, kGround, -missing);
    if (!move)
        return {};
    Parent moved = slit;
    const Vec2 way = ground.frame.directionToLocal(move->way);
    moved.slitFrom += way;
    // A contour may be anything but straight: the slit leaves it somewhere else then.
    const Vec2 beyond = moved.slitFrom + 2.0 * (slit.slitTo - slit.slitFrom);
    moved.slitTo = interior.leavingPoint(moved.slitFrom, beyond).value_or(slit.slitTo + way);
    return moved;
}

bool isWellMovedIn(const Document &drawn, const Document &moved, SectionId guest,
                   const Section &ground, double slitLength)
{
    const Section &section = *moved.find(guest);
    const AnalysisPointer pair = analysedPair(moved, ground, section);
    const JointList &joints = pair->assembly.joints;
    if (joints.begin() == joints.end() || pair->grips.of(*joints.begin()).held.empty())
        return false;
    const double most = kSawsAsLong * slitLength + kSawsDeeper * moved.stockOf(section).thickness;
    for (const Slit &slit : pair->assembly.slits[0])
        if ((slit.mouth - slit.inner).norm() > most)
            return false;
    AnalysisCaches analysed; // the two differ in one section
    CheckCaches caches;
    const auto found = [&](const Document &document) {
        return checks(*analyseNext(evaluate(document), analysed), caches, {}, {}, kWholeness);
    };
    const std::vector<Finding> before = found(drawn);
    return isNoWorse(before, found(moved));
}

} // namespace fff
