#include "core/interaction/interaction_private.h"

namespace fff {

// Handles of the selected operation.

/// Of the operation as it is now: what the overlay has may be of before.
std::optional<OperationHandle> Interaction::Private::operationHandleAt(const Vec2 &position)
{
    if (!marksSelection() || !selection.operation().isValid() || isOnViewMark(sight(), position))
        return std::nullopt;
    const OperationMarks marksNow = operationMarks(host.model(), selection.operation());
    const int index =
        handleAt(marksNow, motion.camera, motion.viewport, position, reachOf(pointer));
    return index < 0 ? std::nullopt
                     : std::optional(marksNow.handles[static_cast<std::size_t>(index)]);
}

void Interaction::Private::hoverOperation()
{
    hoveredHandle.reset();
    const std::optional<Vec2> &at = hovering.position();
    if (!at || motion.animation)
        return;
    hoveredHandle = operationHandleAt(*at);
    if (hoveredHandle)
        hovering.unmark(hovered);
}

void Interaction::Private::markOperation()
{
    if (gesture && gesture->marksOperation())
        return;
    overlay.selected.remove<OperationMarks>();
    if (!marksSelection() || !selection.operation().isValid())
        return;
    OperationMarks shown = operationMarks(host.model(), selection.operation());
    if (shown.handles.empty())
        return;
    for (std::size_t i = 0; hoveredHandle && !gesture && i < shown.handles.size(); ++i)
        if (shown.handles[i].key == hoveredHandle->key)
            shown.hovered = static_cast<int>(i);
    overlay.selected.put(std::move(shown));
}

} // namespace fff
