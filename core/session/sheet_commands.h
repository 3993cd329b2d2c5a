// Commands of how parts lie on their sheets.
//
//   sheets.place      section, x and y (mm), turn (degrees, 0), sheet (1) among the whole ones of
//                     its stock, or offcut (1) among those, body (1) of the section: the part stays
//                     there; what is not said of one that is pinned already stays
//   sheets.unpin      section, or those that are selected: laid with the others again
//   sheets.unpinAll   the same of all
//   sheets.turning    section, or those that are selected; turning: none, half, quarter, free, or
//                     all: as all others
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

void registerSheetCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
