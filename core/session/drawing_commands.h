// Commands that read drawings of other programs (core/io/document_file.h), with the parameter
// "path"; their errors are in that file, line by line:
//
//   section.importSections   a section for every outline
//   section.importContour    the largest outline in place of the selected section's contour
//   section.importHoles      a hole of the selected section for every outline
//   section.importMarks      all lines on the selected section, as mark.engrave and mark.score say
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

void registerDrawingCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
