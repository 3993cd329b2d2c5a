#include "core/analysis/findings/moving_slits.h"

#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/joining_move.h"
#include "core/assembly/joint_editing.h"
#include "core/geometry/segment_distance.h"
#include "core/model/moving.h"

#include <algorithm>

namespace fff {

namespace {

//: %1 is the name of a section, %2 a length
constexpr Text kMovedByStep = FFF_TEXT("Step", "Move %1 by %2");

/// A slit is wide enough apart by so much more than the web that is wanted, mm.
constexpr double kSpare = 0.05;
/// Of a way across a slit, what at least counts for the web beside it.
constexpr double kLeastShare = 0.25;

std::optional<FindingEdit> movedBy(const Model &model, const SectionRef &ref, const Vec3 &way)
{
    if (!ref.drawn.isValid())
        return {};
    const SectionMove move{ref.drawn, Similarity::moved(way)};
    Result<Document> next = movedSections(model.document, std::span(&move, 1));
    if (!next)
        return {};
    return FindingEdit{Step(kMovedByStep, {nameOf(model, ref), lengthOf(way.norm())}),
                       *std::move(next)};
}

Message moveInWords(const FindingAction &, const Finding &finding, const Model &model)
{
    //: %1 is the name of a section
    return {FFF_TEXT("Checks", "Move %1 in from the edge"), {nameAt(finding, model, 1)}};
}

std::optional<FindingEdit> movedIn(const FindingAction &, const Finding &finding,
                                   const Analysis &analysis, const Flips *)
{
    const Model &model = analysis.model;
    const LooseSlit &loose = finding.details<LooseJoint>()->slit;
    const int host = model.indexOf(finding.sections[0]);
    if (loose.why != NoGrip::OneWall || host < 0)
        return {};
    const Frame &frame = model.section(static_cast<std::size_t>(host))->frame;
    const std::optional<JoiningMove> move =
        moveAlong(analysis, finding.sections[1], finding.sections[0],
                  -frame.directionToWorld(loose.missing).normalized());
    return move ? movedBy(model, finding.sections[1], move->way) : std::nullopt;
}

/// The slit that the web of a finding lies beside, of the host.
struct WebSlit
{
    const Slit *slit = nullptr;
    const Section *host = nullptr;
    double lacks = 0.0; // mm
};

std::optional<WebSlit> slitOf(const Finding &finding, const Analysis &analysis)
{
    const int host = analysis.model.indexOf(finding.sections.front());
    const int guest = analysis.model.indexOf(finding.others.front());
    if (host < 0 || guest < 0 || !finding.at)
        return {};
    const auto index = static_cast<std::size_t>(host);
    WebSlit found;
    found.host = analysis.model.section(index).get();
    found.lacks = analysis.model.stockOf(index).thickness - finding.details<ThinWeb>()->width;
    const Vec2 at = found.host->frame.toLocal(*finding.at);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Slit &slit : analysis.assembly.slits[index]) {
        const double distance = distanceTo(at, Region{slit.outline(), {}});
        if (slit.guest == guest && slit.role == SlitRole::Slit && distance < nearest) {
            nearest = distance;
            found.slit = &slit;
        }
    }
    return found.slit ? std::optional(found) : std::nullopt;
}

Vec2 nearestOn(const Polygon &ring, const Vec2 &p)
{
    Vec2 nearest = ring.back();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 at = nearestOfSegment(p, ring[i == 0 ? ring.size() - 1 : i - 1], ring[i]);
        if ((at - p).squaredNorm() < (nearest - p).squaredNorm())
            nearest = at;
    }
    return nearest;
}

Message moveSlitWords(const FindingAction &, const Finding &finding, const Model &model)
{
    //: %1 is the name of a section
    return {FFF_TEXT("Checks", "Move %1 away"), {nameOf(model, finding.others.front())}};
}

std::optional<FindingEdit> slitMoved(const FindingAction &, const Finding &finding,
                                     const Analysis &analysis, const Flips *)
{
    const std::optional<WebSlit> web = slitOf(finding, analysis);
    if (!web)
        return {};
    const Vec2 across = perpendicular((web->slit->mouth - web->slit->inner).normalized());
    const Vec2 at = web->host->frame.toLocal(*finding.at);
    const double side = across.dot(at - web->slit->inner);
    // What stays runs from the slit to `at`, not always across the slit: then moving the slit makes
    // it wider by less.
    const Vec2 gap = at - nearestOn(web->slit->outline(), at);
    const double share =
        gap.norm() > 0.0 ? std::max(std::abs(across.dot(gap.normalized())), kLeastShare) : 1.0;
    const Vec2 way = (side > 0.0 ? -1.0 : 1.0) * (web->lacks + kSpare) / share * across;
    return movedBy(analysis.model, finding.others.front(), web->host->frame.directionToWorld(way));
}

std::optional<FindingEdit> cutLessDeep(const FindingAction &, const Finding &finding,
                                       const Analysis &analysis, const Flips *)
{
    const std::optional<WebSlit> web = slitOf(finding, analysis);
    if (!web)
        return {};
    return cutLessDeepBy(web->lacks + kSpare, *web->slit, finding.sections.front(),
                         finding.others.front(), analysis);
}

} // namespace

std::optional<FindingEdit> cutLessDeepBy(double by, const Slit &slit, const SectionRef &host,
                                         const SectionRef &guest, const Analysis &analysis)
{
    const Model &model = analysis.model;
    const int own = model.indexOf(host), other = model.indexOf(guest);
    if (own < 0 || other < 0)
        return {};
    const Joint *joint = analysis.assembly.joints.find(std::min(own, other), std::max(own, other));
    if (!joint)
        return {};
    const Vec3 out = model.section(static_cast<std::size_t>(own))
                         ->frame.directionToWorld(slit.mouth - slit.inner);
    const double sign = out.dot(joint->crossing->axis.direction) > 0.0 ? 1.0 : -1.0;
    JointEdit edit = nudgeMeetingPoints(model, JointRef(host, guest), sign * by);
    if (!edit || edit->document.isSame(model.document))
        return {};
    return FindingEdit{std::move(edit->step), std::move(edit->document)};
}

const ActionKind kMoveIn{moveInWords, movedIn};
const ActionKind kMoveSlit{moveSlitWords, slitMoved};
const ActionKind kCutLessDeep{plainWords<kLessDeepText>, cutLessDeep};

} // namespace fff
