// When commands can run, as several features have it, and what is said where they cannot.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

#include <string>

namespace fff {

inline constexpr Text kNothingThere = FFF_TEXT("Command", "There is no section yet");
inline constexpr Text kNothingSelected = FFF_TEXT("Command", "No section is selected");

/// Session and interaction outlive all of these.
CommandRule needsSections(const Session &session);
CommandRule needsSelection(const Interaction &interaction);
/// One section, or the tool of this command in the hand.
CommandRule needsOneSection(const Interaction &interaction, std::string command = {});
/// The rule, and a section besides the one that it is about.
CommandRule needsAnother(const Session &session, CommandRule rule);
CommandRule needsJoint(const Interaction &interaction);
/// One in focus, or among the parameters ("operation").
CommandRule needsOperation(const Interaction &interaction);
/// With this reason where something is selected, else that nothing is.
CommandRule needsAmongSelected(const Interaction &interaction, std::function<bool()> can,
                               Text reason);

/// Of a tool's command: in the hand.
std::function<std::optional<bool>()> inHand(const Interaction &interaction, std::string command);

} // namespace fff
