#include "core/interaction/interaction_private.h"
#include "core/interaction/weight_tool.h"

namespace fff {

// Weights that hang on sections.

/// Not valid where there is none, or none can be taken hold of.
WeightId Interaction::Private::weightAt(const Vec2 &position)
{
    if (!marksSelection() || isOnViewMark(sight(), position))
        return {};
    return fff::weightAt(position, context());
}

void Interaction::Private::hoverWeight()
{
    const std::optional<Vec2> &at = hovering.position();
    if (!at || hoveredHandle || hoveredJoint || motion.animation)
        return;
    if (const WeightId weight = weightAt(*at); weight.isValid()) {
        hovering.unmark(hovered);
        hovered.weight = weight;
    }
}

WeightId Interaction::selectedWeight() const
{
    return d->selection.weight();
}

void Interaction::selectWeight(WeightId id)
{
    if (!d->host.model().document.find(id))
        return;
    d->points.clear();
    d->selection.selectWeight(id);
    d->hoverMarks();
    d->update();
}

} // namespace fff
