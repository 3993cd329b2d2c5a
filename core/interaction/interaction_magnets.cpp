#include "core/interaction/interaction_private.h"
#include "core/interaction/magnet_handle.h"
#include "core/interaction/magnet_words.h"

namespace fff {

// How far the selected section pulls templates.

void Interaction::Private::hoverMagnet()
{
    isOverMagnet = false;
    const std::optional<Vec2> &at = hovering.position();
    if (!at || hoveredHandle || hovered.load.isValid() || motion.animation || !marksSelection() ||
        isOnViewMark(sight(), *at))
        return;
    const auto handle = magnetHandle(host.model(), selection, motion.camera);
    isOverMagnet = handle && isOnMagnet(*handle, context(), *at, reachOf(pointer));
    if (isOverMagnet)
        hovering.unmark(hovered);
}

/// A gesture of its own draws what it moves.
void Interaction::Private::markMagnet()
{
    removeMagnetSigns(overlay.selected);
    if (!marksSelection() || (gesture && !gesture->isOfView()))
        return;
    if (const auto handle = magnetHandle(host.model(), selection, motion.camera))
        addMagnetSigns(*handle, false, overlay.selected);
}

Hint Interaction::Private::magnetHint() const
{
    return {hints::kMoveMagnet, {Named{host.model().nameOf(selection.sections().front())}}};
}

} // namespace fff
