#include "core/analysis/findings/standing.h"

#include "core/analysis/angle_words.h"
#include "core/analysis/dropping.h"
#include "core/analysis/findings/broader_base.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/of_sections.h"
#include "core/analysis/footing.h"
#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

using Group = std::vector<int>; // bodies

/// What leans by less nobody sees (0.1°, radians).
constexpr double kLeastLean = 0.0017453292519943296;

/// What leans as well is told by that: it is seen without a push.
bool rocksAlone(const Footing &footing)
{
    return footing.lean <= kPlainLean && footing.rocking > footing.lean;
}

// --- what can be done

//: %1 is the name of a section
constexpr CountedText kStretchStep{FFF_TEXT("Step", "Stretch %1 to the ground"),
                                   FFF_TEXT_OF_MANY("Step", "Stretch %n sections to the ground")};

Message stretchWords(const FindingAction &, const Finding &finding, const Model &model)
{
    if (finding.helpers.size() != 1)
        return {FFF_TEXT("Checks", "Stretch them to the ground"), {}};
    //: %1 is the name of a section
    return {FFF_TEXT("Checks", "Stretch %1 to the ground"),
            {nameOf(model, finding.helpers.front())}};
}

std::optional<FindingEdit> stretched(const FindingAction &, const Finding &finding,
                                     const Analysis &analysis, const Flips *)
{
    const int section =
        finding.sections.empty() ? 0 : analysis.model.indexOf(finding.sections.front());
    if (section < 0 || analysis.bodies.countOf(section) == 0)
        return {};
    const Group group = groupOf(analysis, section);
    std::optional<Document> next = standingOn(analysis, group, finding.details<Footing>()->feet);
    if (!next)
        return {};
    std::vector<std::string> names;
    for (const SectionRef &foot : finding.helpers)
        names.push_back(analysis.model.nameOf(foot));
    return FindingEdit{ofSections(kStretchStep, names), *std::move(next)};
}

Message dropWords(const FindingAction &, const Finding &finding, const Model &)
{
    return {finding.is(kNoContact) ? FFF_TEXT("Checks", "Drop it to the ground")
                                   : FFF_TEXT("Checks", "Raise it to the ground"),
            {}};
}

/// The whole model, from above or from below as the finding has it.
std::optional<FindingEdit> dropped(const FindingAction &, const Finding &finding,
                                   const Analysis &analysis, const Flips *)
{
    const std::optional<double> lowest = lowestPoint(analysis.model);
    if (!lowest || (*lowest > 0.0) != finding.is(kNoContact))
        return {};
    std::optional<Document> next = droppedToGround(analysis.model);
    if (!next)
        return {};
    return FindingEdit{steps::kDropToGround, *std::move(next)};
}

std::vector<FindingAction> stretch(const Finding &, const Analysis &)
{
    return {{&kStretchToGround}, {&kWidenBase}, {&kAddFoot}};
}

std::vector<FindingAction> level(const Finding &, const Analysis &)
{
    return {{&kStretchToGround}};
}

std::vector<FindingAction> broaden(const Finding &, const Analysis &)
{
    return {{&kWidenBase}, {&kAddFoot}};
}

std::vector<FindingAction> drop(const Finding &, const Analysis &)
{
    return {{&kDropToGround}};
}

// --- what is said and shown

/// With the sections that it is about, where that is not the whole model.
Message ofThese(const Finding &finding, const Model &model, Message sentence)
{
    if (finding.sections.empty())
        return sentence;
    return {kOfSections, {namesOf(model, finding.sections), std::move(sentence)}};
}

Message standsSentence(const Finding &finding, const Model &model)
{
    const Footing &footing = *finding.details<Footing>();
    if (footing.rocking >= kLeastLean && rocksAlone(footing))
        return ofThese(
            finding, model,
            {FFF_TEXT("Checks", "Stands, but rocks by %1. Tips only past %2. Margin %3."),
             {nearestAngleOf(footing.rocking), angleOf(footing.tipAngle),
              lengthOf(footing.margin)}});
    if (footing.lean < kLeastLean)
        return ofThese(finding, model,
                       {FFF_TEXT("Checks", "Stands. Tips only past %1. Margin %2."),
                        {angleOf(footing.tipAngle), lengthOf(footing.margin)}});
    return ofThese(
        finding, model,
        {FFF_TEXT("Checks", "Stands, %1 aslant. Tips only past %2. Margin %3."),
         {nearestAngleOf(footing.lean), angleOf(footing.tipAngle), lengthOf(footing.margin)}});
}

/// What else could be a foot; may be empty.
Message feetSentence(const Finding &finding, const Model &model)
{
    const std::vector<HighFoot> &feet = finding.details<Footing>()->feet;
    if (feet.empty())
        return {};
    double highest = 0.0;
    for (const HighFoot &foot : feet)
        highest = std::max(highest, foot.height);
    return {feet.size() == 1
                ? FFF_TEXT("Checks", "The lowest point of %1 is %2 above the ground.")
                : FFF_TEXT("Checks", "The lowest points of %1 are up to %2 above the ground."),
            {namesOf(model, finding.helpers), lengthOf(highest)}};
}

Text leanOf(Towards side)
{
    switch (side) {
    case Towards::Front:
        return FFF_TEXT("Checks", "Leans %1 forwards");
    case Towards::Back:
        return FFF_TEXT("Checks", "Leans %1 backwards");
    case Towards::Left:
        return FFF_TEXT("Checks", "Leans %1 to its left");
    case Towards::Right:
        return FFF_TEXT("Checks", "Leans %1 to its right");
    }
    return {}; // not reached: every side is above
}

Message leansSentence(const Finding &finding, const Model &model)
{
    const Footing &footing = *finding.details<Footing>();
    if (rocksAlone(footing))
        return ofThese(finding, model,
                       joined({FFF_TEXT("Checks", "Rocks by %1: its lowest points are not all on "
                                                  "the ground. Tips only past %2."),
                               {nearestAngleOf(footing.rocking), angleOf(footing.tipAngle)}},
                              feetSentence(finding, model)));
    return ofThese(
        finding, model,
        joined({FFF_TEXT("Checks", "%1 before it stands: its lowest points are not all on the "
                                   "ground. Tips only past %2."),
                {Message{leanOf(footing.leans), {nearestAngleOf(footing.lean)}},
                 angleOf(footing.tipAngle)}},
               feetSentence(finding, model)));
}

Message wouldStandSentence(const Finding &finding, const Model &model)
{
    const Footing &footing = *finding.details<Footing>();
    return ofThese(
        finding, model,
        //: %1 is such as "if it did not fold"; %2 an angle, %3 a length
        {FFF_TEXT("Checks", "Would stand %1. It would tip only past %2. Margin %3."),
         {Message{footing.provided, {}}, angleOf(footing.tipAngle), lengthOf(footing.margin)}});
}

Message unsteadySentence(const Finding &finding, const Model &model)
{
    const Footing &footing = *finding.details<Footing>();
    const bool falls = finding.severity == Severity::Error;
    return ofThese(
        finding, model,
        {falls ? FFF_TEXT("Checks", "Falls at a touch: tilted by %1 it tips over. Margin %2.")
               : FFF_TEXT("Checks", "Barely stands: tilted by %1 it tips over. Margin %2."),
         {angleOf(footing.tipAngle), lengthOf(footing.margin)}});
}

Message leansTitle(const Finding &finding)
{
    const Footing &footing = *finding.details<Footing>();
    return {rocksAlone(footing) ? FFF_TEXT("Checks", "Rocks") : FFF_TEXT("Checks", "Leans"), {}};
}

Message unsteadyTitle(const Finding &finding)
{
    return {finding.severity == Severity::Error ? FFF_TEXT("Checks", "Falls at a touch")
                                                : FFF_TEXT("Checks", "Tips easily"),
            {}};
}

Text fallOf(Towards side)
{
    switch (side) {
    case Towards::Front:
        return FFF_TEXT("Checks", "Falls over forwards. The centre of mass lies %1 in front of the "
                                  "feet.");
    case Towards::Back:
        return FFF_TEXT("Checks",
                        "Falls over backwards. The centre of mass lies %1 behind the feet.");
    case Towards::Left:
        return FFF_TEXT("Checks",
                        "Falls over to its left. The centre of mass lies %1 outside its feet.");
    case Towards::Right:
        return FFF_TEXT("Checks",
                        "Falls over to its right. The centre of mass lies %1 outside its feet.");
    }
    return {}; // not reached: every side is above
}

Message topplesSentence(const Finding &finding, const Model &model)
{
    const Footing &footing = *finding.details<Footing>();
    return ofThese(
        finding, model,
        joined({fallOf(footing.side), {lengthOf(-footing.margin)}}, feetSentence(finding, model)));
}

Message lineSentence(const Finding &finding, const Model &model)
{
    return ofThese(
        finding, model,
        joined({FFF_TEXT("Checks", "Falls over. Its feet are all on one line, so nothing holds it "
                                   "upright."),
                {}},
               feetSentence(finding, model)));
}

Message noContactSentence(const Finding &finding, const Model &model)
{
    return ofThese(
        finding, model,
        {finding.sections.size() > 1
             ? FFF_TEXT("Checks", "Not on the ground. Their lowest point is %1 above it.")
             : FFF_TEXT("Checks", "Not on the ground. Its lowest point is %1 above it."),
         {lengthOf(finding.details<Footing>()->height)}});
}

Message belowGroundSentence(const Finding &finding, const Model &model)
{
    return {finding.sections.size() == 1
                ? FFF_TEXT("Checks", "In the ground. %1 reaches %2 below it.")
                : FFF_TEXT("Checks", "In the ground. %1 reach up to %2 below it."),
            {namesOf(model, finding.sections), lengthOf(finding.details<Footing>()->height)}};
}

double tipAngleOf(const Finding &finding)
{
    return finding.details<Footing>()->tipAngle;
}

double marginOf(const Finding &finding)
{
    return finding.details<Footing>()->margin;
}

ProblemLook footingLook(const Finding &finding)
{
    const Footing &footing = *finding.details<Footing>();
    ProblemLook look;
    if (!footing.support.empty())
        look.grounds.push_back({footing.support, footing.mass.centre, footing.edge, footing.margin,
                                finding.severity >= Severity::Warning,
                                finding.severity == Severity::Warning});
    for (const HighFoot &foot : footing.feet)
        look.feet.push_back({foot.at, foot.height});
    return look;
}

constexpr Text kFootAdvice =
    FFF_TEXT("Checks", "Give it another foot, or move weight over its feet.");
/// The whole model is dropped by a link.
Text notOnGroundAdvice(const Finding &finding)
{
    return finding.sections.empty()
               ? Text{}
               : FFF_TEXT("Checks", "Join it to what stands, or move it to the ground.");
}

constexpr Text kNotYet = FFF_TEXT("Checks", "Does not stand yet");
constexpr Text kNotOnGroundYet = FFF_TEXT("Checks", "Not on the ground yet");

// --- how it is found

Towards towards(const Vec2 &direction)
{
    if (std::abs(direction.x()) > std::abs(direction.y()))
        return direction.x() > 0.0 ? Towards::Right : Towards::Left;
    return direction.y() >= 0.0 ? Towards::Front : Towards::Back;
}

const FindingKind &kindOf(const Stability &stability)
{
    switch (stability.standing) {
    case Standing::Stands:
        return stability.tipAngle < kSteadyTilt                           ? kUnsteady
               : std::max(stability.lean, stability.rocking) > kPlainLean ? kLeans
                                                                          : kStands;
    case Standing::Topples:
        return kTopples;
    case Standing::LineSupport:
        return kLineSupport;
    case Standing::NoContact:
        return kNoContact;
    case Standing::BelowGround:
        return kBelowGround;
    }
    return kStands; // not reached: every case is above
}

/// The sections of a group that reach below the ground.
std::vector<SectionRef> sunkSections(const Analysis &analysis, Group group)
{
    std::erase_if(group, [&](int body) {
        return analysis.bodies.at(body).contact().lowestMiddle >= -kGroundSunk;
    });
    return analysis.model.refs(sectionsOf(analysis.bodies, group));
}

void addFeet(const Analysis &analysis, const Group &group, Footing &footing, Finding &finding)
{
    footing.feet = feetToStretch(analysis, group);
    for (const HighFoot &foot : footing.feet)
        finding.helpers.push_back(foot.section);
}

Finding standingOf(const Looked &at, const Group &group, CheckCaches::OfStance &stance)
{
    Footing footing;
    footing.mass = loadedMass(at.analysis, group);
    const Stability stability = stabilityOf(at.analysis, group, footing.mass, at.caches, stance);
    footing.margin = stability.margin;
    footing.tipAngle = stability.tipAngle;
    footing.side = towards(stability.fall);
    footing.lean = stability.lean;
    footing.rocking = stability.rocking;
    footing.leans = towards(-Vec2(stability.ground.up.x(), stability.ground.up.z()));
    footing.support = stability.support;
    footing.edge = stability.nearest;
    footing.sections = static_cast<int>(sectionsOf(at.analysis.bodies, group).size());
    const Vec3 &centre = footing.mass.centre;
    Finding finding = makeFinding(kindOf(stability), Severity::Error);
    finding.at = Vec3(centre.x(), 0.0, centre.z());
    switch (stability.standing) {
    case Standing::Stands:
        finding.severity = finding.is(kStands)               ? Severity::Good
                           : stability.tipAngle < kLeastTilt ? Severity::Error
                                                             : Severity::Warning;
        if (finding.is(kLeans))
            addFeet(at.analysis, group, footing, finding);
        break;
    case Standing::NoContact:
    case Standing::BelowGround:
        footing.height = std::abs(stability.height);
        finding.at = stability.lowestPoint;
        break;
    case Standing::Topples:
    case Standing::LineSupport:
        addFeet(at.analysis, group, footing, finding);
        break;
    }
    if (finding.is(kBelowGround))
        finding.sections = sunkSections(at.analysis, group);
    else if (at.groups.size() > 1)
        finding.sections = at.analysis.model.refs(sectionsOf(at.analysis.bodies, group));
    finding.setDetails(std::move(footing));
    return finding;
}

} // namespace

const ActionKind kStretchToGround{stretchWords, stretched};
const ActionKind kDropToGround{dropWords, dropped};

const FindingKind kStands{
    "stands", Subject::Stability, FFF_TEXT("Checks", "Stands"), standsSentence,
    nullptr,  footingLook};
const FindingKind kWouldStand{
    "wouldStand", Subject::Stability, FFF_TEXT("Checks", "Would stand"), wouldStandSentence,
    nullptr,      footingLook};
const FindingKind kUnsteady{.name = "unsteady",
                            .subject = Subject::Stability,
                            .title = FFF_TEXT("Checks", "Tips easily"),
                            .sentence = unsteadySentence,
                            .actions = broaden,
                            .look = footingLook,
                            .advice = kFootAdvice,
                            .titled = unsteadyTitle,
                            .spare = tipAngleOf,
                            .yet = kNotYet};
const FindingKind kLeans{.name = "leans",
                         .subject = Subject::Stability,
                         .title = FFF_TEXT("Checks", "Leans"),
                         .sentence = leansSentence,
                         .actions = level,
                         .look = footingLook,
                         .advice = FFF_TEXT("Checks", "Make all its feet end at the same height."),
                         .titled = leansTitle,
                         .spare = tipAngleOf,
                         .yet = kNotYet};
const FindingKind kTopples{.name = "topples",
                           .subject = Subject::Stability,
                           .title = FFF_TEXT("Checks", "Falls over"),
                           .sentence = topplesSentence,
                           .actions = stretch,
                           .look = footingLook,
                           .advice = kFootAdvice,
                           .spare = marginOf,
                           .yet = kNotYet};
const FindingKind kLineSupport{.name = "lineSupport",
                               .subject = Subject::Stability,
                               .title = FFF_TEXT("Checks", "Falls over"),
                               .sentence = lineSentence,
                               .actions = stretch,
                               .look = footingLook,
                               .advice = kFootAdvice,
                               .spare = marginOf,
                               .yet = kNotYet};
const FindingKind kNoContact{.name = "noContact",
                             .subject = Subject::Stability,
                             .title = FFF_TEXT("Checks", "Not on the ground"),
                             .sentence = noContactSentence,
                             .actions = drop,
                             .look = footingLook,
                             .hidesOthers = true,
                             .yet = kNotOnGroundYet,
                             .advised = notOnGroundAdvice};
const FindingKind kBelowGround{.name = "belowGround",
                               .subject = Subject::Stability,
                               .title = FFF_TEXT("Checks", "In the ground"),
                               .sentence = belowGroundSentence,
                               .actions = drop,
                               .look = footingLook,
                               .hidesOthers = true,
                               .yet = kNotOnGroundYet};

void findStanding(const Looked &at, std::vector<Finding> &found)
{
    at.caches.stances.resize(at.groups.size());
    std::optional<Finding> first; // of all groups that stand, the one that falls first
    std::vector<Finding> bad;
    int standing = 0;
    for (std::size_t g = 0; g < at.groups.size(); ++g) {
        if (g > 0 && isLoosePiece(at.analysis.bodies, at.groups[g]))
            continue; // whether it stands is not what is wrong with it
        Finding finding = standingOf(at, at.groups[g], at.caches.stances[g]);
        if (finding.is(kStands) || finding.is(kLeans) || finding.is(kUnsteady)) {
            const Footing &footing = *finding.details<Footing>();
            standing += footing.sections;
            if (!first || footing.tipAngle < first->details<Footing>()->tipAngle)
                first = std::move(finding);
        } else if (g == 0 || !finding.is(kNoContact)) {
            bad.push_back(std::move(finding));
        }
    }
    if (!bad.empty()) {
        std::move(bad.begin(), bad.end(), std::back_inserter(found));
    } else if (first) {
        Footing footing = *first->details<Footing>();
        footing.sections = standing;
        first->setDetails(std::move(footing));
        found.push_back(*std::move(first));
    }
}

} // namespace fff
