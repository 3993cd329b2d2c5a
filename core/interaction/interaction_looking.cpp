#include "core/interaction/interaction_private.h"

namespace fff {

// For whoever only looks at the model.

void Interaction::setLooksOnly(bool looksOnly)
{
    if (looksOnly == d->looksOnly)
        return;
    d->cancelGesture();
    layDown(d->now);
    d->offer({});
    d->note.reset();
    d->points.clear();
    d->selection.select({});
    d->selection.forget(); // nor does it come back
    d->clicks.forget();
    d->clearOverlay();
    d->hoveredPoint.reset();
    d->hoveredJoint.reset();
    d->hoveredHandle.reset();
    d->isOverMagnet = false;
    d->looksOnly = looksOnly;
    d->hover();
    d->update();
}

bool Interaction::looksOnly() const
{
    return d->looksOnly;
}

/// Sections and problems are no place for the hand: the view's cube is.
void Interaction::Private::hoverViewOnly()
{
    const std::optional<CubePart> part = hovered.cubePart;
    hovering.unmark(hovered);
    hovered.cubePart = part;
}

} // namespace fff
