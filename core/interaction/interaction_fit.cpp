#include "core/interaction/interaction_private.h"
#include "core/interaction/view_fit.h"

namespace fff {

/// What a document is first seen in: from the front, fitted.
void Interaction::Private::fitFirst()
{
    Camera front;
    front.projection = motion.camera.projection;
    motion.camera = fittedToAll(front, lasting);
    keepFit();
}

void Interaction::Private::keepFit()
{
    motion.fit = motion.target();
    fittedDocument = host.model().document;
}

Camera Interaction::Private::fittedToAll(const Camera &from, std::span<const Box2> beside) const
{
    std::vector<Vec3> seen = outlinePoints(host.model(), view);
    seen.insert(seen.end(), seenBesides.begin(), seenBesides.end());
    return fittedClear(from, seen, motion.viewport, fitMargins(motion.viewport, beside));
}

/// The view has other room: what filled it does again, unless somebody has looked closer or is at
/// work, whose hand would miss what it was over.
void Interaction::Private::followRoom()
{
    if (!motion.isTouched)
        return fitFirst();
    const PenMarks *path = overlay.find<PenMarks>();
    const bool isAtWork =
        gesture || isToolPressed || overlay.hasStroke() || (path && !path->points.empty());
    // What is drawn into an empty view is not to fill it at once.
    const bool isBegun = fittedDocument.sections.empty() && !host.model().document.sections.empty();
    if (isAtWork || isBegun || !motion.isAsFitted())
        return;
    motion.refit(fittedToAll(motion.target(), lasting));
    hover();
    update();
}

void Interaction::fitAll(const Camera &from, double time, double duration)
{
    turnTo(d->fittedToAll(from, d->covered), time, duration);
    d->keepFit();
}

void Interaction::fit(std::span<const Vec3> points, double time, double duration)
{
    const Vec2 &viewport = d->motion.viewport;
    turnTo(fittedClear(targetCamera(), points, viewport, fitMargins(viewport, d->covered)), time,
           duration);
}

void Interaction::setCovered(std::vector<Box2> covered, const std::vector<Box2> &passing)
{
    const auto isSame = [](const Box2 &a, const Box2 &b) {
        return a.min == b.min && a.max == b.max;
    };
    const bool isSameRoom =
        std::equal(covered.begin(), covered.end(), d->lasting.begin(), d->lasting.end(), isSame);
    d->lasting = covered;
    d->covered = std::move(covered);
    d->covered.insert(d->covered.end(), passing.begin(), passing.end());
    // Verdicts have other words after an edit, which is no reason to move the model.
    const bool isEdited =
        d->motion.isTouched && !d->host.model().document.isSame(d->fittedDocument);
    if (!isSameRoom && !isEdited)
        d->followRoom();
}

const std::vector<Box2> &Interaction::covered() const
{
    return d->covered;
}

void Interaction::setSeenBesides(std::vector<Vec3> points)
{
    d->seenBesides = std::move(points);
}

} // namespace fff
