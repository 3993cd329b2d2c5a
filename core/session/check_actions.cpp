#include "core/session/check_actions.h"

#include "core/assembly/found_joint.h"
#include "core/interaction/joint_editing.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "core/session/dropping.h"
#include "core/session/joining_move.h"
#include "core/session/stretching.h"

#include <algorithm>

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

/// A joint of one of the sections with another one, or with any, that somebody wanted not to be.
std::optional<JointRef> unwantedJoint(const std::vector<SectionRef> &sections,
                                      const std::optional<SectionRef> &with,
                                      const Document &document)
{
    for (const JointOverridePointer &wanted : document.jointOverrides) {
        if (wanted->kind != JointKind::None)
            continue;
        for (const auto &[one, other] :
             {std::pair(&wanted->a, &wanted->b), std::pair(&wanted->b, &wanted->a)})
            if (isOneOf(*one, sections) && (with ? *other == *with : !isOneOf(*other, sections)))
                return JointRef(*one, *other);
    }
    return {};
}

/// As it is by itself.
std::optional<CheckEdit> joinedAgain(const SectionRef &other, const Check &check,
                                     const Model &model)
{
    const auto joint = unwantedJoint(check.sections, other, model.document);
    if (!joint)
        return {};
    JointEdit edit = resetJoint(model, *joint);
    if (!edit)
        return {};
    const Model next = evaluate(edit->document, model);
    const int a = next.indexOf(joint->a), b = next.indexOf(joint->b);
    const auto found =
        a < 0 || b < 0 ? std::nullopt : findJoint(next, std::min(a, b), std::max(a, b));
    if (!found || found->joint.kind == JointKind::None)
        return {};
    return CheckEdit{std::move(edit->step), std::move(edit->document)};
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
    std::optional<Document> next = stretched(analysis, check.feet);
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
std::vector<CheckAction> withJoint(const Check &check, const Document &document,
                                   std::vector<CheckAction> actions)
{
    std::optional<SectionRef> other;
    if (check.code == CheckCode::NoSlit)
        other = check.sections.back();
    if (const auto joint = unwantedJoint(check.sections, other, document)) {
        if (!other)
            other = isOneOf(joint->a, check.sections) ? joint->b : joint->a;
        actions.insert(actions.begin(), {Kind::JoinAgain, *other});
    }
    return actions;
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
        return withJoint(check, analysis.model.document,
                         withDeleted(withTabs(check, movesOf(check, analysis))));
    case CheckCode::NoSlit:
    case CheckCode::Interference:
        return withJoint(check, analysis.model.document, mendsOf(check, analysis.model));
    case CheckCode::CannotAssemble:
        return {{Kind::MakeAssemblable, {}}};
    case CheckCode::Topples:
    case CheckCode::LineSupport:
        return {{Kind::StretchToGround,
                 check.feet.size() == 1 ? check.feet.front().section : SectionRef()}};
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
        break;
    }
    return {};
}

} // namespace fff
