// template.lay, sizeByLine, align and trace: pictures and drawings that are drawn over.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/interaction/section_edit.h"
#include "core/session/session.h"

namespace fff {

/// All but align take "template" (its name; without it the last one).
///
/// lay         "plane": "ground", "front", "side" or "section" ("section": its name; else the one
///             in focus)
/// sizeByLine  "x1", "y1", "x2", "y2", mm in its plane about its middle, and "length", mm
/// align       "front" and "side", two names; without them the last but one and the last; "by":
///             "drawn", the boxes of what is drawn in them, or "all"
/// trace       "as": "sections", "contour", "holes", "engraved" or "scored"; for all but the first
///             "section" as of lay, else the one that it lies on, else the one in focus. Of a
///             picture "by": "darkness" or "opacity"; "threshold" and "smoothing", percent;
///             "smallest", px²; "inverted", "true" or "false"
///
/// Session and interaction outlive the registry.
void registerFlatTemplateCommands(CommandRegistry &registry, Session &session,
                                  Interaction &interaction);

/// The step of the history: both lie as aligned() has them. Errors  those of aligned() and
/// setTemplate().
Result<EditedSections> alignedTemplates(const Document &document, const Template &front,
                                        const Template &side, bool isByDrawn);

} // namespace fff
