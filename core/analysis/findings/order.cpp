#include "core/analysis/findings/order.h"

#include "core/analysis/findings/joining.h"
#include "core/analysis/findings/moved_planes.h"
#include "core/assembly/cycles.h"
#include "core/base/tolerances.h"
#include "core/fabrication/wholeness.h"

#include <algorithm>

namespace fff {

namespace {

Message canSentence(const Finding &finding, const Model &)
{
    const int steps = finding.details<AssemblyOrder>()->steps;
    if (steps == 1)
        return {FFF_TEXT("Checks", "Can be assembled. Only one part so far."), {}};
    if (const int loose = finding.details<AssemblyOrder>()->loose; loose == 1)
        return {FFF_TEXT("Checks", "Can be assembled. But nothing holds one of the parts."), {}};
    else if (loose > 1)
        return {FFF_TEXT_OF_MANY("Checks", "Can be assembled. But nothing holds %n of the parts."),
                {},
                loose};
    return {FFF_TEXT_OF_MANY("Checks", "Can be assembled. %n steps."), {}, steps};
}

Message couldSentence(const Finding &finding, const Model &)
{
    //: %1 is such as "if nothing fell apart"
    return {FFF_TEXT("Checks", "Could be assembled %1."),
            {Message{finding.details<AssemblyOrder>()->provided, {}}}};
}

Message canOtherwiseSentence(const Finding &finding, const Model &)
{
    const AssemblyOrder &order = *finding.details<AssemblyOrder>();
    if (order.inEachOther == 1)
        return {FFF_TEXT("Checks",
                         "Cannot be assembled yet. It could be if two sections did not overlap."),
                {}};
    return {FFF_TEXT_OF_MANY(
                "Checks",
                "Cannot be assembled yet. It could be if %n pairs of sections did not overlap."),
            {},
            order.inEachOther};
}

constexpr Text kShowText = FFF_TEXT("Checks", "Show the steps");

std::vector<FindingAction> showSteps(const Finding &finding, const Analysis &)
{
    if (finding.details<AssemblyOrder>()->steps < 2)
        return {}; // there is nothing to see
    return {{&kShowSteps}};
}

Message cannotSentence(const Finding &finding, const Model &model)
{
    const Blocked &blocked = *finding.details<Blocked>();
    const NamedSections names = namesOf(model, finding.sections);
    if (blocked.directions > 1)
        return {FFF_TEXT("Checks", "Sections block each other. %1 meet in %2 that slide in %3 "
                                   "different directions."),
                {names, Message{FFF_TEXT_OF_MANY("Checks", "%n joints"), {}, blocked.joints},
                 blocked.directions}};
    if (blocked.distance > 0.0)
        return {
            FFF_TEXT(
                "Checks",
                "Sections block each other. %1 comes only %2 out of its slit before it hits %3."),
            {nameAt(finding, model, 0), lengthOf(blocked.distance), nameAt(finding, model, 1)}};
    return {FFF_TEXT("Checks",
                     "Sections block each other. None of %1 can be removed in a straight line."),
            {names}};
}

ProblemLook cannotLook(const Finding &finding)
{
    ProblemLook look;
    look.links = finding.details<Blocked>()->links;
    return look;
}

constexpr Text kMakeStep = FFF_TEXT("Step", "Make assemblable");
constexpr Text kMakeText = FFF_TEXT("Checks", "Make assemblable");

std::optional<FindingEdit> assemblable(const FindingAction &, const Finding &,
                                       const Analysis &analysis, const Flips *flips)
{
    if (!flips || flips->document.isSame(analysis.model.document))
        return {};
    const Message said =
        flips->count == 1
            ? Message{FFF_TEXT("Checks", "1 joint flipped."), {}}
            : Message{FFF_TEXT_OF_MANY("Checks", "%n joints flipped."), {}, flips->count};
    return FindingEdit{kMakeStep, flips->document, said};
}

std::vector<FindingAction> makeAssemblable(const Finding &finding, const Analysis &analysis)
{
    std::vector<FindingAction> actions{{&kMakeAssemblable}};
    if (finding.sections.size() == 2) // one of them stops the other
        for (const SectionRef &section : finding.sections)
            actions.push_back({&kTrim, section});
    for (const auto &planes : {movedPlanes, otherPlanes})
        for (const FindingAction &action : planes(finding, analysis.model.document))
            actions.push_back(action);
    return actions;
}

Message unknownSentence(const Finding &finding, const Model &)
{
    if (const auto &failure = finding.details<OrderUnknown>()->failure)
        //: %1 is a sentence such as "the solid of "Rib" could not be worked out"
        return {FFF_TEXT("Checks", "Order not found: %1."), {*failure}};
    return {FFF_TEXT("Checks", "Order not found. The search took too long; that says nothing about "
                               "the model."),
            {}};
}

/// Parts that are in their place but are not held there.
int looseParts(const Analysis &analysis, CaptiveCache &captives)
{
    const auto groups = heldGroups(analysis, captives);
    return groups.empty() ? 0 : static_cast<int>(analysis.bodies.size() - groups.front().size());
}

/// Why parts are locked: the ways in which the joints among them slide, and what stops the one that
/// could move.
void explain(const LookedAtPlan &at, const std::vector<int> &sections, Finding &finding)
{
    Blocked blocked;
    std::vector<Vec3> ways;
    const auto isLocked = [&](int section) {
        return std::binary_search(sections.begin(), sections.end(), section);
    };
    const SharedRows<Joint> &rows = at.analysis.assembly.joints.rows();
    for (const int section : sections) {
        for (const Joint &joint : rows[static_cast<std::size_t>(section)]) {
            if (joint.kind == JointKind::None || !isLocked(joint.b))
                continue;
            ++blocked.joints;
            blocked.links.push_back(linkOf(at.analysis.model, joint));
            if (!finding.at)
                finding.at = blocked.links.back().at;
            const Vec3 &way = joint.crossing->axis.direction;
            if (slidesAlongAxis(joint.kind) &&
                std::none_of(ways.begin(), ways.end(),
                             [&](const Vec3 &other) { return areParallel(way, other); }))
                ways.push_back(way);
        }
    }
    blocked.directions = static_cast<int>(ways.size());
    if (const auto &stop = at.plan.stop) {
        const auto sectionOf = [&](int part) { return at.plan.bodies.sectionOf(part); };
        // Who moves is named first.
        finding.sections = at.analysis.model.refs({sectionOf(stop->part), sectionOf(stop->by)});
        finding.joint = JointRef(finding.sections[0], finding.sections[1]);
        blocked.distance = stop->distance;
    }
    blocked.areSlices = areOfCrossingSlices(finding, at.analysis.model.document);
    finding.setDetails(std::move(blocked));
}

Text cannotAdvice(const Finding &finding)
{
    if (finding.details<Blocked>()->areSlices)
        return FFF_TEXT("Checks", "None of the shifts and numbers of planes that were tried lets "
                                  "them slide together. Bake the slices and shorten one of them, "
                                  "or leave it out.");
    return FFF_TEXT("Checks", "Shorten one of them, or turn it so that it slides in the same "
                              "direction as the others.");
}

} // namespace

const ActionKind kShowSteps{plainWords<kShowText>};
const ActionKind kMakeAssemblable{plainWords<kMakeText>, assemblable};

const FindingKind kCanAssemble{"canAssemble", Subject::Assembly,
                               FFF_TEXT("Checks", "Can be assembled"), canSentence, showSteps};
const FindingKind kCouldAssemble{"canAssemble", Subject::Assembly,
                                 FFF_TEXT("Checks", "Could be assembled"), couldSentence,
                                 showSteps};
const FindingKind kCanOtherwiseAssemble{"interference", Subject::Assembly,
                                        FFF_TEXT("Checks", "Cannot be assembled yet"),
                                        canOtherwiseSentence, showSteps};
const FindingKind kCannotAssemble{.name = "cannotAssemble",
                                  .subject = Subject::Assembly,
                                  .title = FFF_TEXT("Checks", "Cannot be assembled"),
                                  .sentence = cannotSentence,
                                  .actions = makeAssemblable,
                                  .look = cannotLook,
                                  .advised = cannotAdvice};
const FindingKind kOrderUnknown{"orderUnknown", Subject::Assembly,
                                FFF_TEXT("Checks", "Order not found"), unknownSentence};

void findOrder(const LookedAtPlan &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    switch (at.plan.plan.verdict) {
    case AssemblyPlan::Verdict::Possible: {
        const AssemblyOrder order{static_cast<int>(at.plan.plan.steps.size()),
                                  static_cast<int>(pairsInEachOther(at.plan, at.rules.touching)),
                                  looseParts(at.analysis, at.caches.captives)};
        const Severity whole = order.loose > 0 ? Severity::Note : Severity::Good;
        found.push_back(order.inEachOther > 0
                            ? makeFinding(kCanOtherwiseAssemble, Severity::Warning, order)
                            : makeFinding(kCanAssemble, whole, order));
        return;
    }
    case AssemblyPlan::Verdict::Impossible: {
        Finding finding = makeFinding(kCannotAssemble, Severity::Error);
        const std::vector<int> sections = sectionsOf(at.plan.plan.locked, at.plan);
        finding.sections = model.refs(sections);
        explain(at, sections, finding);
        found.push_back(std::move(finding));
        return;
    }
    case AssemblyPlan::Verdict::NotFound:
        Finding finding =
            makeFinding(kOrderUnknown, Severity::Unknown, OrderUnknown{at.plan.failure});
        if (at.plan.failure)
            finding.sections = model.refs(sectionsWithoutSolid(at.analysis.bodies));
        found.push_back(std::move(finding));
        return;
    }
}

} // namespace fff
