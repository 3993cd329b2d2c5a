#include "core/analysis/findings/strength_findings.h"

#include "core/analysis/finding_action.h"
#include "core/analysis/findings/pulled_joints.h"
#include "core/analysis/findings/pushed_over.h"
#include "core/analysis/findings/strengthening.h"
#include "core/analysis/findings/thin_necks.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace fff {

namespace {

// --- what is said

const Held &heldOf(const Finding &finding)
{
    return *finding.details<Held>();
}

/// That many times what acts on it, in the words of what that is.
Message amountOf(const Held &held, double kilograms)
{
    if (held.pushes == 0.0)
        return {Text{nullptr, "%1"}, {massOf(kilograms)}};
    const double times = kilograms / held.placed;
    if (held.weights == 0.0)
        return {Text{nullptr, "%1"}, {forceOf(times * held.pushes)}};
    //: %1 is a number such as 2.5, of all weights and pushes
    return {FFF_TEXT("Checks", "%1 times as much"), {Decimal{times, times < 10.0 ? 1 : 0}}};
}

Message placedOf(const Held &held)
{
    if (held.pushes > 0.0 && held.weights > 0.0)
        return {FFF_TEXT("Checks", "its load"), {}};
    return amountOf(held, held.placed);
}

Message holdsTitle(const Finding &finding)
{
    if (heldOf(finding).placed == 0.0)
        return {FFF_TEXT("Checks", "Strong enough"), {}};
    //: %1 is a mass or a force
    return {FFF_TEXT("Checks", "Holds %1"), {placedOf(heldOf(finding))}};
}

Message wouldHoldTitle(const Finding &finding)
{
    if (heldOf(finding).placed == 0.0)
        return {FFF_TEXT("Checks", "Would be strong enough"), {}};
    //: %1 is a mass or a force
    return {FFF_TEXT("Checks", "Would hold %1"), {placedOf(heldOf(finding))}};
}

/// It "holds" nothing from which a corner in it may crack already.
Message barelyTitle(const Finding &finding)
{
    const Held &held = heldOf(finding);
    const bool mayCrack = held.cornerUse > 1.0;
    if (held.placed == 0.0)
        return {mayCrack ? FFF_TEXT("Checks", "May crack")
                         : FFF_TEXT("Checks", "Barely strong enough"),
                {}};
    //: %1 is a mass or a force
    return {mayCrack ? FFF_TEXT("Checks", "May crack under %1")
                     : FFF_TEXT("Checks", "Barely holds %1"),
            {placedOf(held)}};
}

/// It may hold all the same, with less to spare than is wanted.
Message weakTitle(const Finding &finding)
{
    const Held &held = heldOf(finding);
    const bool breaks = held.neckUse > 1.0;
    if (held.placed == 0.0)
        return {breaks ? FFF_TEXT("Checks", "Will break") : FFF_TEXT("Checks", "Too weak"), {}};
    //: %1 is a mass or a force
    return {breaks ? FFF_TEXT("Checks", "Breaks under %1") : FFF_TEXT("Checks", "Too weak for %1"),
            {placedOf(held)}};
}

Message titledSentence(Message title, Message rest)
{
    //: a verdict such as "Holds 350 g" and sentences about it
    return {FFF_TEXT("Checks", "%1. %2"), {std::move(title), std::move(rest)}};
}

/// What gives way first, and under how much.
Message limitsOf(const Held &held, const Model &model)
{
    const BearableMass &bearable = held.bearable;
    const bool isBoth = held.cracks && bearable.cracksFrom && held.breaks && bearable.breaksAt;
    // Where no corner makes it worse it cracks and breaks under the same.
    if (isBoth && held.cracks->section == held.breaks->section &&
        amountOf(held, *bearable.cracksFrom) == amountOf(held, *bearable.breaksAt))
        //: %1 is a section, %2 a place such as "beside its slit for Body", %3 a mass
        return {FFF_TEXT("Checks", "%1 breaks %2 from %3."),
                {nameOf(model, held.cracks->section), spotText(*held.cracks, model),
                 amountOf(held, *bearable.cracksFrom)}};
    if (isBoth) {
        const Message crack{
            //: %1 is a section, %2 a place such as "beside its slit for Body", %3 a mass
            FFF_TEXT("Checks", "%1 may crack %2 from %3;"),
            {nameOf(model, held.cracks->section), spotText(*held.cracks, model),
             amountOf(held, *bearable.cracksFrom)}};
        const bool isSame = held.cracks->section == held.breaks->section;
        const Message breaks =
            isSame ? Message{//: the section that was just named; %1 is a mass
                             FFF_TEXT("Checks", "its neck breaks at %1."),
                             {amountOf(held, *bearable.breaksAt)}}
                   : Message{//: %1 is a section, %2 a mass
                             FFF_TEXT("Checks", "the neck of %1 breaks at %2."),
                             {nameOf(model, held.breaks->section), amountOf(held, *bearable.breaksAt)}};
        return joined(crack, breaks);
    }
    Message cracks;
    if (held.cracks && bearable.cracksFrom)
        cracks = {FFF_TEXT("Checks", "%1 may crack %2 from %3."),
                  {nameOf(model, held.cracks->section), spotText(*held.cracks, model),
                   amountOf(held, *bearable.cracksFrom)}};
    Message falls;
    if (bearable.fallsFrom)
        falls = {bearable.isPulledOut ? FFF_TEXT("Checks", "With %1 a joint is pulled open.")
                                      : FFF_TEXT("Checks", "With %1 it no longer stands."),
                 {amountOf(held, *bearable.fallsFrom)}};
    if (cracks.isEmpty() && falls.isEmpty())
        return {bearable.isFound
                    ? FFF_TEXT("Checks", "It would hold far more.")
                    : FFF_TEXT("Checks", "How much it would hold could not be worked out."),
                {}};
    return cracks.isEmpty() ? falls : joined(cracks, falls);
}

Message ownWeightSentence(const Finding &finding, const Model &model)
{
    const Held &held = heldOf(finding);
    if (!held.weakest)
        return {FFF_TEXT("Checks", "Nothing puts a strain on it."), {}};
    constexpr double kLittle = 0.01;
    if (held.cornerUse < kLittle)
        //: %1 is a section, %2 a place such as "beside its slit for Body"
        return {FFF_TEXT("Checks", "Weakest is %1, %2: less than 1 % of its strength."),
                {nameOf(model, held.weakest->section), spotText(*held.weakest, model)}};
    //: %1 is a section, %2 a place such as "beside its slit for Body", %3 a number of percent
    return {FFF_TEXT("Checks", "Weakest is %1, %2: %3 % of its strength."),
            {nameOf(model, held.weakest->section), spotText(*held.weakest, model),
             percentOf(held.cornerUse)}};
}

/// And how far it gives, where that is worth telling.
Message withBending(Message sentence, const Held &held)
{
    if (held.bends == 0.0)
        return sentence;
    //: %1 is a length
    return joined(std::move(sentence), {FFF_TEXT("Checks", "Bends %1."), {lengthOf(held.bends)}});
}

template <Message (*title)(const Finding &)>
Message firmSentence(const Finding &finding, const Model &model)
{
    return titledSentence(title(finding), heldOf(finding).placed > 0.0
                                              ? limitsOf(heldOf(finding), model)
                                              : ownWeightSentence(finding, model));
}

template <Message (*title)(const Finding &)>
Message heldSentence(const Finding &finding, const Model &model)
{
    return withBending(firmSentence<title>(finding, model), heldOf(finding));
}

Message wouldHoldSentence(const Finding &finding, const Model &model)
{
    const Held &held = heldOf(finding);
    //: %1 is such as "Would hold 350 g", %2 such as "if it held together"
    const Message title{FFF_TEXT("Checks", "%1 %2"),
                        {wouldHoldTitle(finding), Message{held.provided, {}}}};
    return withBending(titledSentence(title, held.placed > 0.0 ? limitsOf(held, model)
                                                               : ownWeightSentence(finding, model)),
                       held);
}

Message weakSentence(const Finding &finding, const Model &model)
{
    const Held &held = heldOf(finding);
    Message sentence = firmSentence<weakTitle>(finding, model);
    if (held.placed == 0.0 && held.breaks)
        sentence = titledSentence(
            weakTitle(finding),
            //: %1 is a section, %2 a number of percent
            {FFF_TEXT("Checks", "The neck of %1 is strained to %2 % of its strength."),
             {nameOf(model, held.breaks->section), percentOf(held.neckUse)}});
    if (held.neckUse > 1.0) // what breaks bends no farther
        return sentence;
    return withBending(joined(std::move(sentence),
                              //: %1 is a number such as 2
                              {FFF_TEXT("Checks", "That leaves less than the safety factor of %1."),
                               {Decimal{held.safety}}}),
                       held);
}

Message notRatedSentence(const Finding &finding, const Model &model)
{
    return {FFF_TEXT("Checks", "Strength unknown. No strength is set for the stock of %1."),
            {namesOf(model, finding.sections)}};
}

Message strengthUnknownSentence(const Finding &finding, const Model &model)
{
    if (finding.sections.empty())
        return {FFF_TEXT("Checks", "Strength unknown. The forces between the sections could not be "
                                   "worked out."),
                {}};
    return {FFF_TEXT("Checks", "Strength unknown. The stress in %1 could not be worked out."),
            {namesOf(model, finding.sections)}};
}

Message movesSentence(const Finding &finding, const Model &model)
{
    if (finding.sections.empty())
        return {FFF_TEXT("Checks",
                         "Slides away. Its feet do not hold it against what pushes it: push "
                         "less, or give it more weight."),
                {}};
    return {FFF_TEXT("Checks",
                     "Comes loose. Nothing keeps %1 in place: glue the joints, or add one "
                     "more."),
            {namesOf(model, finding.sections)}};
}

Message foldsSentence(const Finding &finding, const Model &model)
{
    return {FFF_TEXT("Checks", "Folds. Fingers turn like hinges, and nothing else keeps %1 from "
                               "turning: glue them, or join them to one more section."),
            {namesOf(model, finding.sections)}};
}

Message besideSentence(const Finding &finding, const Model &model)
{
    return {
        FFF_TEXT(
            "Checks",
            "Off the material. A weight on %1 misses its material; the nearest place takes it."),
        {nameAt(finding, model, 0)}};
}

// --- how it is found

std::optional<WeakPlace> placeIn(const Analysis &analysis, const Strength &strength, int body,
                                 std::optional<NeckStress> BodyStrength::*which)
{
    if (body < 0)
        return {};
    const auto &neck = strength.bodies[static_cast<std::size_t>(body)].*which;
    return neck ? std::optional(weakPlaceOf(analysis, body, *neck)) : std::nullopt;
}

std::vector<SectionRef> sectionsWhere(const Analysis &analysis, const Strength &strength,
                                      bool (*is)(const BodyStrength &))
{
    std::set<int> sections;
    for (std::size_t i = 0; i < strength.bodies.size(); ++i)
        if (is(strength.bodies[i]))
            sections.insert(analysis.bodies.sectionOf(static_cast<int>(i)));
    return analysis.model.refs({sections.begin(), sections.end()});
}

/// What moves though it would stand as one piece; whether it stands is said elsewhere.
void findMoving(const Analysis &analysis, const Strength &strength, std::vector<Finding> &found)
{
    for (const ComponentState &state : strength.equilibrium().components) {
        const bool isLoose = state.balance == Balance::Mechanism && state.openLinks.empty();
        if (!isLoose && state.balance != Balance::Slides)
            continue;
        const std::vector<Link> &links = strength.made.structure.links;
        const bool hasFingers =
            std::any_of(state.parts.links.begin(), state.parts.links.end(), [&](int link) {
                return links[static_cast<std::size_t>(link)].kind == LinkKind::Fingers;
            });
        Finding finding =
            makeFinding(isLoose && hasFingers ? kFolds : kMovesWithin, Severity::Error);
        if (isLoose) {
            std::set<int> sections;
            for (const int body : state.offenders)
                sections.insert(analysis.bodies.sectionOf(body));
            finding.sections = analysis.model.refs({sections.begin(), sections.end()});
        }
        found.push_back(std::move(finding));
    }
}

/// One verdict on all of it; none where it does not stand.
void findVerdict(const Analysis &analysis, const Strength &strength, const BearableMass &bearable,
                 const StrengthRules &rules, std::vector<Finding> &found)
{
    const auto held = [&](const FindingKind &kind, Severity severity) {
        Held details{placedMass(strength.made.structure),
                     strength.made.weights,
                     strength.made.pushes,
                     strength.cornerUse,
                     strength.neckUse,
                     rules.safety,
                     placeIn(analysis, strength, strength.worst, &BodyStrength::corner),
                     placeIn(analysis, strength, bearable.cracksIn, &BodyStrength::corner),
                     placeIn(analysis, strength,
                             bearable.breaksIn < 0 ? strength.worstNeck : bearable.breaksIn,
                             &BodyStrength::neck),
                     bearable};
        Finding finding = makeFinding(kind, severity);
        // Of what holds nothing is marked.
        if (details.weakest && severity > Severity::Good) {
            finding.sections = {details.weakest->section};
            finding.at = 0.5 * (details.weakest->from + details.weakest->to);
        }
        finding.setDetails(std::move(details));
        found.push_back(std::move(finding));
    };
    const auto about = [&](const FindingKind &kind, std::vector<SectionRef> sections) {
        Finding finding = makeFinding(kind, Severity::Unknown);
        finding.sections = std::move(sections);
        found.push_back(std::move(finding));
    };
    switch (strength.verdict) {
    case HoldVerdict::Holds:
        return held(kHolds, Severity::Good);
    case HoldVerdict::BarelyHolds:
        return held(kBarelyHolds, Severity::Warning);
    case HoldVerdict::Breaks:
        return held(kTooWeak, Severity::Error);
    case HoldVerdict::NotRated:
        return about(kNotRated, sectionsWhere(analysis, strength, [](const BodyStrength &body) {
                         return !body.strength;
                     }));
    case HoldVerdict::NotWorkedOut: {
        // Of what hangs by nothing it is known.
        const auto isLost = [](const BodyStrength &body) {
            return !body.isWorkedOut && !body.isPinched;
        };
        std::vector<SectionRef> lost = sectionsWhere(analysis, strength, isLost);
        const bool isAnyPinched =
            std::any_of(strength.bodies.begin(), strength.bodies.end(),
                        [](const BodyStrength &body) { return body.isPinched; });
        if (!lost.empty() || !isAnyPinched)
            about(kStrengthUnknown, std::move(lost));
        return;
    }
    case HoldVerdict::PullsOut:
    case HoldVerdict::Unstable:
        return;
    }
}

} // namespace

const FindingKind kHolds{"holds",
                         Subject::Strength,
                         FFF_TEXT("Checks", "Strong enough"),
                         heldSentence<holdsTitle>,
                         nullptr,
                         nullptr,
                         nullptr,
                         nullptr,
                         {},
                         holdsTitle};
const FindingKind kWouldHold{.name = "wouldHold",
                             .subject = Subject::Strength,
                             .title = FFF_TEXT("Checks", "Would be strong enough"),
                             .sentence = wouldHoldSentence,
                             .titled = wouldHoldTitle};
const FindingKind kBarelyHolds{"barelyHolds",
                               Subject::Strength,
                               FFF_TEXT("Checks", "Barely strong enough"),
                               heldSentence<barelyTitle>,
                               strengthen,
                               nullptr,
                               nullptr,
                               nullptr,
                               {},
                               barelyTitle};
const FindingKind kTooWeak{
    "tooWeak",
    Subject::Strength,
    FFF_TEXT("Checks", "Too weak"),
    weakSentence,
    strengthen,
    nullptr,
    nullptr,
    nullptr,
    FFF_TEXT("Checks", "Use thicker stock, make it wider there, or put less on it."),
    weakTitle};
const FindingKind kNotRated{"notRated", Subject::Strength, FFF_TEXT("Checks", "Strength unknown"),
                            notRatedSentence, enterStrength};
const FindingKind kStrengthUnknown{"strengthUnknown", Subject::Strength,
                                   FFF_TEXT("Checks", "Strength unknown"), strengthUnknownSentence};
const FindingKind kMovesWithin{"movesWithin", Subject::Strength, FFF_TEXT("Checks", "Comes loose"),
                               movesSentence};
const FindingKind kFolds{"folds", Subject::Strength, FFF_TEXT("Checks", "Folds"), foldsSentence};
const FindingKind kWeightBeside{
    "weightBeside", Subject::Strength, FFF_TEXT("Checks", "Off the material"),
    besideSentence, nullptr,           nullptr,
    nullptr,        nullptr,           {},
    nullptr,        nullptr,           true};

std::vector<Finding> strengthFindings(const Analysis &analysis, const Strength &strength,
                                      const BearableMass &bearable, const StrengthRules &rules)
{
    std::vector<Finding> found;
    findVerdict(analysis, strength, bearable, rules, found);
    findMoving(analysis, strength, found);
    findPushedOver(strength, found);
    findPulledJoints(analysis, strength, rules, found);
    findThinNecks(analysis, strength, found);
    for (const PlacedLoad &load : strength.made.besideLoads) {
        Finding finding = makeFinding(kWeightBeside, Severity::Note);
        finding.sections = {analysis.model.ref(static_cast<std::size_t>(load.section))};
        found.push_back(std::move(finding));
    }
    return found;
}

void tellBending(std::vector<Finding> &findings, double bends)
{
    for (Finding &finding : findings) {
        if (const Held *held = finding.details<Held>(); held && bends >= kToldBending) {
            Held told = *held;
            told.bends = bends;
            finding.setDetails(std::move(told));
        }
    }
}

} // namespace fff
