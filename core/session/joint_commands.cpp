#include "core/session/joint_commands.h"

#include "core/interaction/joint_editing.h"
#include "core/session/session_host.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace fff {

namespace {

constexpr std::array<std::pair<std::string_view, JointKind>, 5> kKinds{
    {{"crossLap", JointKind::CrossLap},
     {"extendedCrossLap", JointKind::ExtendedCrossLap},
     {"mortise", JointKind::Mortise},
     {"tabs", JointKind::Tabs},
     {"none", JointKind::None}}};

std::string textOf(const CommandParameters &parameters, const std::string &name)
{
    const auto found = parameters.find(name);
    return found == parameters.end() ? std::string() : found->second;
}

/// By its name, in what is there now; none: no section, or a joint's, has it.
std::optional<SectionRef> sectionNamed(const Model &model, const std::string &name)
{
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        if (model.section(i)->name == name)
            return model.ref(i);
    return {};
}

Result<void> selectJoint(const Session &session, Interaction &interaction,
                         const CommandParameters &parameters)
{
    const Model &model = session.committed();
    std::array<SectionRef, 2> sections;
    for (const auto &[key, ref] : {std::pair("a", &sections[0]), std::pair("b", &sections[1])}) {
        const std::string name = textOf(parameters, key);
        const std::optional<SectionRef> found = sectionNamed(model, name);
        if (!found)
            return failure(ErrorCode::BadValue, key, {name, "the name of a section"});
        *ref = *found;
    }
    const JointRef joint(sections[0], sections[1]);
    if (!hasJoint(model, joint))
        return failure(ErrorCode::BadValue, "b",
                       {textOf(parameters, "b"), "a section that meets the other"});
    interaction.selectJoint(joint);
    return {};
}

/// One step of the history, or why there is none.
Result<void> carryOut(Session &session, Interaction &interaction, JointEdit edit, double time)
{
    if (!edit)
        interaction.say(edit.error(), time);
    else
        session.commit(SessionHost::undoText(edit->step), std::move(edit->document));
    return {};
}

bool isOverridden(const Session &session, const Interaction &interaction)
{
    const std::optional<JointRef> &joint = interaction.selectedJoint();
    return joint && session.committed().document.jointOverride(joint->a, joint->b);
}

} // namespace

void registerJointCommands(CommandRegistry &registry, Session &session, Interaction &interaction)
{
    const auto hasJoint = [&interaction] { return interaction.selectedJoint().has_value(); };
    registry.add("joint.select", {[&](const CommandParameters &parameters, double) {
                                      return selectJoint(session, interaction, parameters);
                                  },
                                  {}});
    registry.add(
        "joint.kind",
        {[&](const CommandParameters &parameters, double time) -> Result<void> {
             const std::string text = textOf(parameters, "kind");
             const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                            [&](const auto &known) { return known.first == text; });
             if (kind == kKinds.end())
                 return failure(ErrorCode::BadValue, "kind", {text, "a kind of joint"});
             return carryOut(
                 session, interaction,
                 setKind(session.committed(), *interaction.selectedJoint(), kind->second), time);
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
    registry.add("joint.reset",
                 {[&](const CommandParameters &, double time) {
                      return carryOut(session, interaction,
                                      resetJoint(session.committed(), *interaction.selectedJoint()),
                                      time);
                  },
                  [&] { return isOverridden(session, interaction); }});
}

} // namespace fff
