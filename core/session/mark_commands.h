// Commands of what is drawn on sections.
//
//   section.mark      picks up the tool that draws it
//   mark.engrave      what is drawn next is engraved
//   mark.score        or scored
//   mark.addText      text, height (mm), x, y (mm, frame coordinates), turn (degrees), as
//                     ("engraved", "scored"): words on the selected section
//   mark.change       mark (its number, from 0), and what of the same becomes another
//   mark.delete       mark
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

void registerMarkCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
