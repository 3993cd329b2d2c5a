#include "core/session/joint_commands.h"

#include "core/assembly/joint_editing.h"
#include "core/model/joint_kind_names.h"
#include "core/session/command_rules.h"
#include "core/session/message_text.h"
#include "core/session/operation_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace fff {

namespace {

constexpr CommandWords kJointWords[] = {
    {"joint.flip", FFF_TEXT("Command", "Flip the slits of the &joint"),
     FFF_TEXT("Command", "Flip the slits"), "", "joint_flip",
     FFF_TEXT("Command", "Let the slits of the selected joint open to the other side")},
    {"joint.reset", FFF_TEXT("Command", "Restore a&utomatic settings"),
     FFF_TEXT("Command", "Restore automatic"), "", "joint_reset",
     FFF_TEXT(
         "Command",
         "Let the program choose kind, direction and meeting points of the selected joint again")},
};

std::string givenText(const CommandParameters &parameters, const std::string &name)
{
    const auto found = parameters.find(name);
    return found == parameters.end() ? std::string() : found->second;
}

/// By the names of its two sections, whether they meet or not.
Result<JointRef> jointNamed(const Model &model, const CommandParameters &parameters)
{
    std::array<SectionRef, 2> sections;
    for (const auto &[key, ref] : {std::pair("a", &sections[0]), std::pair("b", &sections[1])}) {
        const std::string name = givenText(parameters, key);
        const std::optional<SectionRef> found = sectionNamed(model, name);
        if (!found)
            return failure(ErrorCode::BadValue, key, {name, "the name of a section"});
        *ref = *found;
    }
    return JointRef(sections[0], sections[1]);
}

Result<void> selectJoint(const Session &session, Interaction &interaction,
                         const CommandParameters &parameters)
{
    const Result<JointRef> joint = jointNamed(session.committed(), parameters);
    if (!joint)
        return tl::unexpected(joint.error());
    if (!hasJoint(session.committed(), *joint))
        return failure(ErrorCode::BadValue, "b",
                       {givenText(parameters, "b"), "a section that meets the other"});
    interaction.selectJoint(*joint);
    return {};
}

/// The selected joint's section of that name, or without a name the one that loses less.
Result<JointEdit> trimmedOf(const Model &model, const JointRef &joint,
                            const CommandParameters &parameters)
{
    const std::string name = givenText(parameters, "section");
    std::optional<SectionRef> section = easierTrimmed(model, joint);
    if (!name.empty()) {
        section = sectionNamed(model, name);
        if (!section || (*section != joint.a && *section != joint.b))
            return failure(ErrorCode::BadValue, "section",
                           {name, "the name of one of the joint's sections"});
    }
    const SectionRef trimmed = section.value_or(joint.a);
    return trimTo(model, trimmed, trimmed == joint.a ? joint.b : joint.a);
}

/// One step of the history, or why there is none.
Result<void> carryOut(Session &session, Interaction &interaction, JointEdit edit, double time)
{
    if (!edit)
        interaction.say(edit.error(), time);
    else
        session.commit(messageText(edit->step.words), std::move(edit->document));
    return {};
}

constexpr Text kNothingByHand = FFF_TEXT("Command", "Nothing of this joint is set by hand");

bool isOverridden(const Session &session, const Interaction &interaction)
{
    const std::optional<JointRef> &joint = interaction.selectedJoint();
    return joint && session.committed().document.jointOverride(joint->a, joint->b);
}

} // namespace

void registerJointCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const CommandRule hasJoint = needsJoint(interaction);
    registry.add("joint.select", {[&](const CommandParameters &parameters, double) {
                     return selectJoint(session, interaction, parameters);
                 }});
    registry.add("joint.kind",
                 {[&](const CommandParameters &parameters, double time) -> Result<void> {
                      const std::string text = givenText(parameters, "kind");
                      const std::optional<JointKind> kind = jointKindNamed(text);
                      if (!kind)
                          return failure(ErrorCode::BadValue, "kind", {text, "a kind of joint"});
                      return carryOut(
                          session, interaction,
                          setKind(session.committed(), *interaction.selectedJoint(), *kind), time);
                  },
                  hasJoint});
    registry.add("joint.flip",
                 {[&](const CommandParameters &, double time) {
                      return carryOut(session, interaction,
                                      flipSlits(session.committed(), *interaction.selectedJoint()),
                                      time);
                  },
                  hasJoint});
    registry.add(
        "joint.share",
        {[&](const CommandParameters &parameters, double time) -> Result<void> {
             const auto percent = numberOf(parameters, "percent", 50.0);
             const auto overlap = numberOf(parameters, "overlap", 1.0);
             for (const auto *number : {&percent, &overlap})
                 if (!*number)
                     return tl::unexpected(number->error());
             if (!(*percent >= 100.0 * kLeastShare && *percent <= 100.0 - 100.0 * kLeastShare))
                 return failure(ErrorCode::BadValue, "percent",
                                {std::to_string(*percent), "5 to 95"});
             return carryOut(session, interaction,
                             moveMeetingPoint(session.committed(), *interaction.selectedJoint(),
                                              static_cast<int>(*overlap) - 1,
                                              1.0 - 0.01 * *percent),
                             time);
         },
         hasJoint});
    registry.add(
        "joint.tabs", {[&](const CommandParameters &parameters, double time) -> Result<void> {
            const auto joint = jointNamed(session.committed(), parameters);
            if (!joint)
                return tl::unexpected(joint.error());
            return carryOut(session, interaction, joinWithTabs(session.committed(), *joint), time);
        }});
    registry.add("joint.trim",
                 {[&](const CommandParameters &parameters, double time) {
                      auto edit =
                          trimmedOf(session.committed(), *interaction.selectedJoint(), parameters);
                      return edit ? carryOut(session, interaction, *std::move(edit), time)
                                  : Result<void>(tl::unexpected(edit.error()));
                  },
                  hasJoint});
    registry.add("joint.reset",
                 {[&](const CommandParameters &, double time) {
                      return carryOut(session, interaction,
                                      resetJoint(session.committed(), *interaction.selectedJoint()),
                                      time);
                  },
                  [&session, &interaction, hasJoint](const CommandParameters &parameters) {
                      const WhyNot without = hasJoint(parameters);
                      return without || isOverridden(session, interaction) ? without
                                                                           : WhyNot(kNothingByHand);
                  }});
    registry.offer(kJointWords);
}

} // namespace fff
