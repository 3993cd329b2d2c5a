#include "core/interaction/interaction_private.h"

namespace fff {

// What a stroke was meant to be, while it is drawn and until the next thing is done.

void Interaction::Private::offer(std::optional<ShapeOffer> shape)
{
    offered = std::move(shape);
    overlay.offered = offered ? offered->signs : Signs();
}

bool Interaction::hasOffer() const
{
    return d->offered || (d->gesture && d->gesture->hasOffer());
}

void Interaction::takeOffer(double time)
{
    d->moveOn(time);
    if (d->gesture && d->gesture->hasOffer()) {
        d->gesture->takeOffer();
        d->showNow();
        return;
    }
    if (!d->offered)
        return;
    ShapeOffer taken = *std::move(d->offered);
    d->offer({});
    d->note.reset();
    d->document = taken.document;
    d->host.commit(taken.step, std::move(taken.document));
    d->hover();
    say(taken.done, time);
}

bool Interaction::hasGuide() const
{
    return d->gesture ? d->gesture->hasGuide() : d->tool && d->tool->hasGuide();
}

void Interaction::takeGuide(double time)
{
    d->moveOn(time);
    if (!hasGuide())
        return;
    GestureContext context = d->context();
    GestureReply reply = d->gesture ? d->gesture->takeGuide(context) : d->tool->takeGuide(context);
    const std::optional<Hint> why = reply.note;
    if (d->gesture)
        d->take(std::move(reply));
    else
        d->takeFromTool(std::move(reply));
    if (why) // also while the stroke goes on
        say(*why, time);
    d->update();
}

} // namespace fff
