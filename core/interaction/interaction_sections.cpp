#include "core/interaction/interaction_private.h"
#include "core/interaction/section_editing.h"

namespace fff {

// Edits of whole sections, which come from keys, commands and fields.

/// A tool in the hand goes on with what comes of it.
void Interaction::Private::carryOut(SectionEdit edit)
{
    if (!isTaken(edit))
        return;
    if (!edit->document.isSame(document))
        host.commit(edit->step, std::move(edit->document));
    if (edit->select) {
        points.clear();
        selection.select(*std::move(edit->select));
    }
    clicks.forget();
    hover();
}

} // namespace fff
