// template.lay, sizeByLine, align and trace: pictures and drawings that are drawn over; and the
// tools that move and size templates in the view.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/interaction/section_edit.h"
#include "core/session/session.h"

#include <vector>

namespace fff {

/// All but align take "template" (its name; without it the last one).
///
/// lay         "plane": "ground", "front", "side" or "section" ("section": its name; else the one
///             in focus)
/// sizeByLine  "x1", "y1", "x2", "y2", mm in its plane about its middle, and "length", mm; without
///             any of these the line is drawn in the view, over a mesh too
/// align       "front" and "side", two names; without them the last but one and the last; "by":
///             "drawn", the boxes of what is drawn in them, or "all"
/// trace       "as": "sections", "contour", "holes", "engraved" or "scored"; for all but the first
///             "section" as of lay, else the one that it lies on, else the one in focus. Of a
///             picture "by": "darkness" or "opacity"; "threshold" and "smoothing", percent;
///             "smallest", px²; "inverted", "true" or "false"
/// transform   moved in the view, with handles (template_tool.h); of a mesh too
///
/// Session and interaction outlive the registry.
void registerFlatTemplateCommands(CommandRegistry &registry, Session &session,
                                  Interaction &interaction);

/// What lines of a drawing are drawn on: the section that it lies on, else the only one in focus.
/// Errors  BadValue, place = "section", where there is none.
Result<SectionRef> sectionToDrawOn(const Model &model, const SectionRef &liesOn,
                                   const std::vector<SectionRef> &inFocus);

/// The step of the history: both lie as aligned() has them. Errors  those of aligned() and
/// setTemplate().
Result<EditedSections> alignedTemplates(const Document &document, const Template &front,
                                        const Template &side, bool isByDrawn);

} // namespace fff
