#include "core/interaction/interaction_private.h"
#include "core/interaction/load_editing.h"
#include "core/interaction/section_editing.h"

namespace fff {

// Edits of whole sections, which come from keys, commands and fields; arrow keys.

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

bool Interaction::nudge(const Vec2 &arrow, double distance, double time)
{
    advance(time);
    if (d->tool && !d->tool->leavesArrows())
        return false; // it has the keys
    if (const std::optional<JointRef> joint = d->selection.joint()) {
        const bool isMoved = d->nudgeMeetingPoints(*joint, arrow, distance);
        d->update();
        return isMoved;
    }
    const Camera &camera = d->motion.camera;
    const Model &model = d->host.model();
    if (d->selection.load().isValid()) {
        const Load *load = model.document.find(d->selection.load());
        const Section *section = load ? model.find(load->section) : nullptr;
        if (!section)
            return false;
        const Vec2 by = distance * arrowAxis(section->frame, camera, arrow);
        carryOut(movedLoad(model, load->id, by), time);
        return true;
    }
    if (!d->points.isEmpty()) {
        const SectionPointer section = editedSection(model, d->selection.sections().front());
        const Vec2 by = distance * arrowAxis(section->frame, camera, arrow);
        carryOut(movedSelection(documentOfPoints(), d->points, by, pointRules()), time);
        return true;
    }
    if (d->selection.sections().empty())
        return false;
    Transform transform;
    transform.way = distance * arrowAxis(camera, arrow);
    carryOut(
        transformed(model, d->selection.sections(), transform, {}, d->settings.takesChildren, true),
        time);
    return true;
}

} // namespace fff
