#include "core/interaction/contour_words.h"
#include "core/interaction/interaction_private.h"

namespace fff {

// Carrying out what gestures answer.

void Interaction::Private::feed(const PointerEvent &event)
{
    GestureContext with = context();
    take(gesture->handle(event, with));
}

void Interaction::Private::take(GestureReply reply)
{
    if (reply.state == GestureReply::State::Running) {
        const std::optional<Document> shown = reply.preview;
        if (!tool || reply.preview) // else the tool's own stays
            showPreview(std::move(reply.preview));
        if (reply.select)
            selection.select(*std::move(reply.select));
        if (reply.selectPoints && shown)
            selectPoints(*std::move(reply.selectPoints), *shown);
        else if (reply.selectPoints)
            selectPoints(*std::move(reply.selectPoints), documentOfPoints());
        return;
    }
    // The gesture goes first: the host's answer to what follows may come back here.
    gesture.reset();
    hasSecondButton = false;
    if (!reply.returnTo && !(cameraBefore == motion.camera))
        motion.history.leave(cameraBefore, ViewHistory::Change::Drag);
    pending.clear();
    clearOverlay();
    carryOut(reply);
    if (!reply.commit && !tool)
        showPreview({});
    clicks.forget();
    hover();
}

/// What replies of gestures and tools have in common.
void Interaction::Private::carryOut(GestureReply &reply)
{
    if (reply.note)
        note = Note{*reply.note, now + kNoteTime};
    if (reply.select)
        selection.select(*std::move(reply.select));
    if (reply.returnTo)
        motion.animate(*reply.returnTo, now, std::min(kReturnTime, settings.turnTime));
    if (reply.settling)
        motion.animate(reply.settling->camera, now, reply.settling->time);
    if (reply.turnTo)
        turn(*reply.turnTo, now, settings.turnTime);
    if (reply.commit) {
        hasPreview = false; // the commit ends it
        document = reply.commit->document;
        if (reply.commit->step.words.text == steps::kDrawSection && !view.isolated.empty())
            view.isolated.insert(document.sections.back()->id); // or it would be a ghost at once
        offer(std::move(reply.offer));
        host.commit(reply.commit->step, std::move(reply.commit->document));
    }
    if (reply.selectOperation) {
        points.clear();
        selection.selectOperation(*reply.selectOperation);
    }
    if (reply.selectLoad) {
        points.clear();
        selection.selectLoad(*reply.selectLoad);
    }
    if (reply.selectPoints)
        selectPoints(*std::move(reply.selectPoints), documentOfPoints());
}

/// Only a preview that a gesture has put up is taken down: others have theirs.
void Interaction::Private::showPreview(std::optional<Document> shown)
{
    const bool hadPreview = std::exchange(hasPreview, shown.has_value());
    if (shown)
        host.preview(std::move(*shown));
    else if (hadPreview)
        host.cancelPreview();
}

bool Interaction::Private::cancelGesture()
{
    if (isToolPressed && !isToolCommitting) {
        isToolPressed = false;
        GestureContext with = context();
        takeFromTool(tool->interrupt(with));
        return true;
    }
    if (!gesture && pending.empty())
        return false;
    pending.clear();
    if (gesture) {
        GestureContext with = context();
        take(gesture->cancel(with));
    }
    return true;
}

/// One step back of the tool; the last one lays it down. False when none is held.
bool Interaction::Private::cancelTool()
{
    if (!tool)
        return false;
    isToolPressed = false;
    GestureContext with = context();
    takeFromTool(tool->cancel(with));
    return true;
}

} // namespace fff
