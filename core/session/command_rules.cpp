#include "core/session/command_rules.h"

#include "core/interaction/tool.h"

#include <string_view>
#include <utility>

namespace fff {

namespace {

constexpr Text kSelectOne = FFF_TEXT("Command", "Select one section first");
constexpr Text kNoJoint =
    FFF_TEXT("Command", "No joint is selected: select a section, then one of its joints");
constexpr Text kNoOther = FFF_TEXT("Command", "There is no other section");
constexpr Text kNoOperation = FFF_TEXT("Command", "No operation is selected");

bool hasSelection(const Interaction &interaction)
{
    return !interaction.sectionsInFocus().empty();
}

bool isHeld(const Interaction &interaction, std::string_view command)
{
    return interaction.tool() && interaction.tool()->command() == command;
}

} // namespace

CommandRule needsSections(const Session &session)
{
    return needs([&session] { return session.committed().sectionCount() > 0; }, kNothingThere);
}

CommandRule needsSelection(const Interaction &interaction)
{
    return needs([&interaction] { return hasSelection(interaction); }, kNothingSelected);
}

CommandRule needsOneSection(const Interaction &interaction, std::string command)
{
    return needs(
        [&interaction, command = std::move(command)] {
            return interaction.selection().size() == 1 || isHeld(interaction, command);
        },
        kSelectOne);
}

CommandRule needsAnother(const Session &session, CommandRule rule)
{
    return [&session, rule = std::move(rule)](const CommandParameters &parameters) {
        if (const WhyNot why = rule(parameters))
            return why;
        return session.committed().sectionCount() > 1 ? WhyNot() : WhyNot(kNoOther);
    };
}

CommandRule needsJoint(const Interaction &interaction)
{
    return needs([&interaction] { return interaction.selectedJoint().has_value(); }, kNoJoint);
}

CommandRule needsOperation(const Interaction &interaction)
{
    return [&interaction](const CommandParameters &parameters) {
        const bool isThere =
            parameters.contains("operation") || interaction.operationInFocus().isValid();
        return isThere ? WhyNot() : WhyNot(kNoOperation);
    };
}

CommandRule needsAmongSelected(const Interaction &interaction, std::function<bool()> can,
                               Text reason)
{
    return [&interaction, can = std::move(can), reason](const CommandParameters &) {
        if (can())
            return WhyNot();
        return WhyNot(hasSelection(interaction) ? reason : kNothingSelected);
    };
}

std::function<std::optional<bool>()> inHand(const Interaction &interaction, std::string command)
{
    return [&interaction, command = std::move(command)]() -> std::optional<bool> {
        return isHeld(interaction, command);
    };
}

} // namespace fff
