#include "core/analysis/check_actions.h"

#include "core/analysis/dropping.h"
#include "core/analysis/joining_move.h"
#include "core/analysis/stretching.h"
#include "core/assembly/found_joint.h"
#include "core/assembly/joint_editing.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <numeric>

namespace fff {

namespace {

using Kind = CheckAction::Kind;

/// So many are tried: a rib that lies beside others is parallel to most of them.
constexpr std::size_t kMostTried = 8;

/// The nearest section that it can be joined with.
std::vector<CheckAction> movesOf(const Check &check, const Analysis &analysis)
{
    std::vector<SectionRef> others = nearestSections(analysis, check.sections, kMostTried);
    if (check.other) { // it is the nearest by more than boxes
        std::erase(others, *check.other);
        others.insert(others.begin(), *check.other);
    }
    for (const SectionRef &other : others)
        if (joiningMove(analysis, check.sections, other))
            return {{Kind::MoveToOther, other}};
    return {};
}

std::optional<CheckEdit> movedTo(const SectionRef &other, const Check &check,
                                 const Analysis &analysis)
{
    const std::optional<JoiningMove> move = joiningMove(analysis, check.sections, other);
    if (!move)
        return {};
    const Model &model = analysis.model;
    CheckEdit edit{{Step::Kind::MoveToSection, {}}, moved(model.document, *move)};
    for (const SectionId id : move->sections)
        edit.step.names.push_back(model.document.find(id)->name);
    const int index = model.indexOf(other);
    edit.step.names.push_back(model.section(static_cast<std::size_t>(index))->name);
    return edit;
}

bool isOneOf(const SectionRef &section, const std::vector<SectionRef> &sections)
{
    return std::find(sections.begin(), sections.end(), section) != sections.end();
}

/// Joints that somebody wanted not to be, of the two that collide, or of what is loose with others.
/// Some may not be there now.
std::vector<JointRef> unwantedJoints(const Check &check, const Document &document)
{
    std::vector<JointRef> joints;
    for (const JointOverridePointer &wanted : document.jointOverrides) {
        const int inside = isOneOf(wanted->a, check.sections) + isOneOf(wanted->b, check.sections);
        if (wanted->kind == JointKind::None && inside == (check.code == CheckCode::NoSlit ? 2 : 1))
            joints.emplace_back(wanted->a, wanted->b);
    }
    return joints;
}

/// As it is when its kind is not wanted.
std::optional<CheckEdit> joinedAgain(const SectionRef &other, const Check &check,
                                     const Model &model)
{
    for (const JointRef &joint : unwantedJoints(check, model.document)) {
        if (joint.a != other && joint.b != other)
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
        Step step{Step::Kind::JoinSections, {model.nameOf(joint.a), model.nameOf(joint.b)}};
        return CheckEdit{std::move(step), *std::move(next)};
    }
    return {};
}

/// Of the check's sections and the one that it names, the first that can be joined so.
std::optional<CheckEdit> joinedWithTabs(const SectionRef &other, const Check &check,
                                        const Model &model)
{
    for (std::size_t i = 0; i < std::min(check.sections.size(), kMostTried); ++i)
        if (auto edit = joinWithTabs(model, JointRef(check.sections[i], other)))
            return CheckEdit{std::move(edit->step), std::move(edit->document)};
    return {};
}

/// Its pair's section, to the other one.
std::optional<CheckEdit> trimmed(const SectionRef &section, const Check &check, const Model &model)
{
    const auto other = std::find_if(check.sections.begin(), check.sections.end(),
                                    [&](const SectionRef &ref) { return ref != section; });
    if (other == check.sections.end())
        return {};
    auto edit = trimTo(model, section, *other);
    if (!edit)
        return {};
    return CheckEdit{std::move(edit->step), std::move(edit->document)};
}

/// What can be done about two sections that are in each other.
std::vector<CheckAction> mendsOf(const Check &check, const Model &model)
{
    if (check.sections.size() != 2)
        return {};
    std::vector<CheckAction> actions{{Kind::JoinWithTabs, check.sections[1]}};
    const JointRef pair(check.sections[0], check.sections[1]);
    if (const auto section = easierTrimmed(model, pair))
        actions.push_back({Kind::Trim, *section});
    return actions;
}

std::optional<CheckEdit> deleted(const Check &check, const Document &document)
{
    CheckEdit edit{{Step::Kind::DeleteSections, {}}, document};
    std::vector<SectionId> ids;
    for (const SectionRef &ref : check.sections) {
        if (const Section *section = document.find(ref.drawn)) {
            ids.push_back(section->id);
            edit.step.names.push_back(section->name);
        }
    }
    Result<Document> next = removeSections(document, ids);
    if (ids.empty() || !next)
        return {};
    edit.document = *std::move(next);
    return edit;
}

std::optional<CheckEdit> assemblable(const Document &document, const Flips *flips)
{
    if (!flips || flips->document.isSame(document))
        return {};
    return CheckEdit{{Step::Kind::MakeAssemblable, {}}, flips->document};
}

std::optional<CheckEdit> onStretchedFeet(const Check &check, const Analysis &analysis)
{
    std::vector<int> group;
    for (const SectionRef &section : check.sections)
        group.push_back(analysis.model.indexOf(section));
    if (group.empty()) { // the whole model
        group.resize(analysis.model.sectionCount());
        std::iota(group.begin(), group.end(), 0);
    }
    std::optional<Document> next = standingOn(analysis, group, check.feet);
    if (!next)
        return {};
    CheckEdit edit{{Step::Kind::StretchToGround, {}}, *std::move(next)};
    for (const HighFoot &foot : check.feet)
        edit.step.names.push_back(analysis.model.nameOf(foot.section));
    return edit;
}

/// From above or from below, as the check has it.
std::optional<CheckEdit> dropped(const Check &check, const Model &model)
{
    const std::optional<double> lowest = lowestPoint(model);
    if (!lowest || (*lowest > 0.0) != (check.code == CheckCode::NoContact))
        return {};
    std::optional<Document> next = droppedToGround(model);
    if (!next)
        return {};
    return CheckEdit{{Step::Kind::DropToGround, {}}, *std::move(next)};
}

/// Where there was to be no joint one is the mildest of all.
std::vector<CheckAction> withJoints(const Check &check, const Document &document,
                                    std::vector<CheckAction> actions)
{
    std::vector<CheckAction> all;
    for (const JointRef &joint : unwantedJoints(check, document))
        all.push_back(
            {Kind::JoinAgain, joint.a == check.sections.front() || !isOneOf(joint.b, check.sections)
                                  ? joint.b
                                  : joint.a});
    all.insert(all.end(), actions.begin(), actions.end());
    return all;
}

std::vector<CheckAction> withDeleted(std::vector<CheckAction> actions)
{
    actions.push_back({Kind::DeleteSections, {}});
    return actions;
}

/// What only touches is held by tabs, which moves nothing.
std::vector<CheckAction> withTabs(const Check &check, std::vector<CheckAction> actions)
{
    if (check.other)
        actions.insert(actions.begin(), {Kind::JoinWithTabs, *check.other});
    return actions;
}

/// Of the check; edits among them may turn out not to be possible.
std::vector<CheckAction> candidates(const Check &check, const Analysis &analysis)
{
    switch (check.code) {
    case CheckCode::NotConnected:
        return withJoints(check, analysis.model.document,
                          withDeleted(withTabs(check, movesOf(check, analysis))));
    case CheckCode::NoSlit:
        return withJoints(check, analysis.model.document, mendsOf(check, analysis.model));
    case CheckCode::Interference:
        return mendsOf(check, analysis.model);
    case CheckCode::CannotAssemble:
        return {{Kind::MakeAssemblable, {}}};
    case CheckCode::Topples:
    case CheckCode::LineSupport:
        return {{Kind::StretchToGround, {}}};
    case CheckCode::NoContact:
    case CheckCode::BelowGround:
        return {{Kind::DropToGround, {}}};
    case CheckCode::CanAssemble:
        if (check.count < 2)
            return {}; // there is nothing to see
        return {{Kind::ShowSteps, {}}};
    case CheckCode::TooLarge:
        return {{Kind::ChooseSheet, {}}};
    case CheckCode::NarrowSlit:
        return {{Kind::WidenSlits, {}}};
    default:
        return {};
    }
}

} // namespace

bool isEdit(Kind kind)
{
    switch (kind) {
    case Kind::JoinAgain:
    case Kind::MoveToOther:
    case Kind::JoinWithTabs:
    case Kind::Trim:
    case Kind::DeleteSections:
    case Kind::MakeAssemblable:
    case Kind::StretchToGround:
    case Kind::DropToGround:
        return true;
    case Kind::ShowSteps:
    case Kind::ChooseSheet:
    case Kind::WidenSlits:
    case Kind::TryAgain:
    case Kind::ShowReport:
        return false;
    }
    return false; // not reached: every kind is above
}

std::vector<CheckAction> actionsOf(const Check &check, const Analysis &analysis, const Flips *flips)
{
    std::vector<CheckAction> actions = candidates(check, analysis);
    std::erase_if(actions, [&](const CheckAction &action) {
        return isEdit(action.kind) && !carriedOut(action, check, analysis, flips);
    });
    return actions;
}

std::optional<CheckEdit> carriedOut(const CheckAction &action, const Check &check,
                                    const Analysis &analysis, const Flips *flips)
{
    switch (action.kind) {
    case Kind::JoinAgain:
        return joinedAgain(action.section, check, analysis.model);
    case Kind::MoveToOther:
        return movedTo(action.section, check, analysis);
    case Kind::JoinWithTabs:
        return joinedWithTabs(action.section, check, analysis.model);
    case Kind::Trim:
        return trimmed(action.section, check, analysis.model);
    case Kind::DeleteSections:
        return deleted(check, analysis.model.document);
    case Kind::MakeAssemblable:
        return assemblable(analysis.model.document, flips);
    case Kind::StretchToGround:
        return onStretchedFeet(check, analysis);
    case Kind::DropToGround:
        return dropped(check, analysis.model);
    case Kind::ShowSteps:
    case Kind::ChooseSheet:
    case Kind::WidenSlits:
    case Kind::TryAgain:
    case Kind::ShowReport:
        break;
    }
    return {};
}

} // namespace fff
