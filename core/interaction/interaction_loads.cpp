#include "core/interaction/interaction_private.h"
#include "core/interaction/load_marks.h"

namespace fff {

// Loads on sections.

/// Not valid where there is none, or none can be taken hold of.
LoadId Interaction::Private::loadAt(const Vec2 &position)
{
    if (!marksSelection() || isOnViewMark(sight(), position))
        return {};
    const std::optional<LoadAt> at = fff::loadAt(position, context());
    return at ? at->id : LoadId();
}

void Interaction::Private::hoverLoad()
{
    const std::optional<Vec2> &at = hovering.position();
    if (!at || hoveredHandle || motion.animation)
        return;
    if (const LoadId load = loadAt(*at); load.isValid()) {
        hovering.unmark(hovered);
        hovered.load = load;
    }
}

LoadId Interaction::selectedLoad() const
{
    return d->selection.load();
}

void Interaction::selectLoad(LoadId id)
{
    if (d->looksOnly || !d->host.model().document.find(id))
        return;
    d->points.clear();
    d->selection.selectLoad(id);
    d->hoverMarks();
    d->update();
}

} // namespace fff
