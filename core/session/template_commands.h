// template.add, refill, set, remove, toGround, turnUp, suggest and facets: what sections are drawn
// after, and what is made of it at once.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/interaction/section_edit.h"
#include "core/io/template_file.h"
#include "core/session/session.h"

namespace fff {

/// add takes "file", and may be told "size" (mm, of the largest extent), "up" ("y" or "z") and
/// "reference" ("true": its bytes stay where they are). The others take "template" (its name;
/// without it the last one). refill: "file" and "reference", for what it holds. set: "name",
/// "x", "y" and "z" (mm, of its middle), "size", "opacity" (percent), "hidden" and "locked"; of
/// meshes "turnX", "turnY" and "turnZ" (degrees, one after the other); of what is flat "turn"
/// (degrees from upright, counter-clockwise) and "flipped". turnUp lays it so that the other one of
/// the file's y and z is upwards. suggest: "count" and "seed" (whole numbers; 8 and 1). facets:
/// "faces", at most. Session and interaction outlive the registry.
void registerTemplateCommands(CommandRegistry &registry, Session &session,
                              Interaction &interaction);

/// The steps of the history: a template comes, or is another one (of these words, of its name).
/// Errors  those of addTemplate() and setTemplate().
Result<EditedSections> addedTemplate(const Document &document, const io::LoadedTemplate &loaded);
/// The template as it lies, with what another file holds. Errors  BadValue, place = the file's
/// name, for one of another kind; those of setTemplate().
Result<EditedSections> refilledTemplate(const Document &document, TemplateId id,
                                        const io::LoadedTemplate &loaded);
Result<EditedSections> changedTemplate(const Document &document, const Template &changed,
                                       Text step);

} // namespace fff
