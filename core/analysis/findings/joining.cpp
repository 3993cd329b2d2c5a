#include "core/analysis/findings/joining.h"

#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/joining_move.h"
#include "core/assembly/found_joint.h"
#include "core/assembly/joint_editing.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"

#include <algorithm>

namespace fff {

namespace {

//: %1 and %2 are the names of two sections
constexpr Text kJoinSections = FFF_TEXT("Step", "Join %1 and %2");
//: %1 is the name of a section, %2 of the one that it comes to
constexpr Text kMoveTo = FFF_TEXT("Step", "Move %1 to %2");
//: %1 is the name of a section
constexpr Text kMoveSeveralTo = FFF_TEXT_OF_MANY("Step", "Move %n sections to %1");

/// So many are tried: a rib that lies beside others is parallel to most of them.
constexpr std::size_t kMostTried = 8;

bool isOneOf(const SectionRef &section, const std::vector<SectionRef> &sections)
{
    return std::find(sections.begin(), sections.end(), section) != sections.end();
}

std::vector<JointRef> unwantedJoints(const Finding &finding, const Document &document)
{
    std::vector<JointRef> joints;
    for (const JointOverridePointer &wanted : document.jointOverrides) {
        const int inside =
            isOneOf(wanted->a, finding.sections) + isOneOf(wanted->b, finding.sections);
        if (wanted->kind == JointKind::None && inside == (finding.is(kNoSlit) ? 2 : 1))
            joints.emplace_back(wanted->a, wanted->b);
    }
    return joints;
}

Message joinAgainWords(const FindingAction &action, const Finding &finding, const Model &model)
{
    if (finding.is(kNoSlit))
        return {FFF_TEXT("Checks", "Join them"), {}};
    return {finding.sections.size() == 1 //: %1 is the name of a section
                ? FFF_TEXT("Checks", "Join it with %1")
                //: %1 is the name of a section
                : FFF_TEXT("Checks", "Join them with %1"),
            {nameOf(model, action.section)}};
}

/// As it is when its kind is not wanted.
std::optional<FindingEdit> joinedAgain(const FindingAction &action, const Finding &finding,
                                       const Analysis &analysis, const Flips *)
{
    const Model &model = analysis.model;
    for (const JointRef &joint : unwantedJoints(finding, model.document)) {
        if (joint.a != action.section && joint.b != action.section)
            continue;
        JointOverride wanted = *model.document.jointOverride(joint.a, joint.b);
        wanted.kind.reset();
        Result<Document> next = setJointOverride(model.document, std::move(wanted));
        if (!next)
            continue;
        const Model tried = evaluate(*next, model);
        const int a = tried.indexOf(joint.a), b = tried.indexOf(joint.b);
        if (a < 0 || b < 0)
            continue;
        const auto found = findJoint(tried, std::min(a, b), std::max(a, b));
        if (!found || found->joint.kind == JointKind::None)
            continue;
        Step step{kJoinSections, {nameOf(model, joint.a), nameOf(model, joint.b)}};
        return FindingEdit{std::move(step), *std::move(next)};
    }
    return {};
}

/// Of the finding's sections and the action's, the first that can be joined so.
std::optional<FindingEdit> joinedWithTabs(const FindingAction &action, const Finding &finding,
                                          const Analysis &analysis, const Flips *)
{
    for (std::size_t i = 0; i < std::min(finding.sections.size(), kMostTried); ++i)
        if (auto edit = joinWithTabs(analysis.model, JointRef(finding.sections[i], action.section)))
            return FindingEdit{std::move(edit->step), std::move(edit->document)};
    return {};
}

Message moveWords(const FindingAction &action, const Finding &finding, const Model &model)
{
    return {finding.sections.size() == 1 //: %1 is the name of a section
                ? FFF_TEXT("Checks", "Move it to %1")
                //: %1 is the name of a section
                : FFF_TEXT("Checks", "Move them to %1"),
            {nameOf(model, action.section)}};
}

std::optional<FindingEdit> movedTo(const FindingAction &action, const Finding &finding,
                                   const Analysis &analysis, const Flips *)
{
    const std::optional<JoiningMove> move = joiningMove(analysis, finding.sections, action.section);
    if (!move)
        return {};
    const Model &model = analysis.model;
    const Named to = nameOf(model, action.section);
    const auto count = static_cast<int>(move->sections.size());
    Step step(Message{kMoveSeveralTo, {to}, count});
    if (count == 1)
        step = {kMoveTo, {Named{model.document.find(move->sections.front())->name}, to}};
    return FindingEdit{std::move(step), moved(model.document, *move)};
}

Message trimWords(const FindingAction &action, const Finding &, const Model &model)
{
    //: %1 is the name of a section
    return {FFF_TEXT("Checks", "Trim %1"), {nameOf(model, action.section)}};
}

std::optional<FindingEdit> trimmed(const FindingAction &action, const Finding &finding,
                                   const Analysis &analysis, const Flips *)
{
    const auto other = std::find_if(finding.sections.begin(), finding.sections.end(),
                                    [&](const SectionRef &ref) { return ref != action.section; });
    if (other == finding.sections.end())
        return {};
    auto edit = trimTo(analysis.model, action.section, *other);
    if (!edit)
        return {};
    return FindingEdit{std::move(edit->step), std::move(edit->document)};
}

constexpr Text kTabsText = FFF_TEXT("Checks", "Join with tabs");

} // namespace

const ActionKind kJoinAgain{joinAgainWords, joinedAgain};
const ActionKind kJoinWithTabs{plainWords<kTabsText>, joinedWithTabs};
const ActionKind kMoveToOther{moveWords, movedTo};
const ActionKind kTrim{trimWords, trimmed};

std::vector<FindingAction> joinAgain(const Finding &finding, const Document &document)
{
    std::vector<FindingAction> all;
    for (const JointRef &joint : unwantedJoints(finding, document)) {
        const bool isWithB =
            joint.a == finding.sections.front() || !isOneOf(joint.b, finding.sections);
        all.push_back({&kJoinAgain, isWithB ? joint.b : joint.a});
    }
    return all;
}

std::optional<FindingAction> moveToNearest(const Finding &finding,
                                           const std::optional<SectionRef> &first,
                                           const Analysis &analysis)
{
    std::vector<SectionRef> others = nearestSections(analysis, finding.sections, kMostTried);
    if (first) { // it is the nearest by more than boxes
        std::erase(others, *first);
        others.insert(others.begin(), *first);
    }
    for (const SectionRef &other : others)
        if (joiningMove(analysis, finding.sections, other))
            return FindingAction{&kMoveToOther, other};
    return {};
}

std::vector<FindingAction> mendsOfPair(const Finding &finding, const Analysis &analysis)
{
    if (finding.sections.size() != 2)
        return {};
    std::vector<FindingAction> actions{{&kJoinWithTabs, finding.sections[1]}};
    const JointRef pair(finding.sections[0], finding.sections[1]);
    if (const auto section = easierTrimmed(analysis.model, pair))
        actions.push_back({&kTrim, *section});
    return actions;
}

} // namespace fff
