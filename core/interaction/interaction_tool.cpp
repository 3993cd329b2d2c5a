#include "core/interaction/interaction_private.h"

namespace fff {

// Tools.

bool Interaction::Private::toolHasUse(const PointerEvent &press)
{
    GestureContext with = context();
    const bool edits =
        dragKind(settings.navigation, press.button, press.modifiers) == DragKind::Edit;
    return (edits || tool->takesControl(press, with)) && tool->takes(press, with);
}

/// What lies over the view comes first, and drags that move it are as without a tool.
bool Interaction::Private::toolTakes(const PointerEvent &event)
{
    if (!tool || gesture || !pending.empty())
        return false;
    switch (event.type) {
    case PointerEvent::Type::Press:
    case PointerEvent::Type::DoubleClick:
        return event.button == Button::Left && !isOnViewMark(sight(), event.position) &&
               toolHasUse(event);
    case PointerEvent::Type::Release:
        return isToolPressed && event.button == Button::Left;
    case PointerEvent::Type::Move:
    case PointerEvent::Type::Modifiers:
        return isToolPressed || !isOnViewMark(sight(), event.position);
    default:
        return false;
    }
}

void Interaction::Private::feedTool(const PointerEvent &event)
{
    if (event.isPress()) {
        motion.finish();
        motion.history.interrupt();
        note.reset();
        offer({});
        motion.isTouched = true;
        isToolPressed = true;
        toolPress = event;
    } else if (event.type == PointerEvent::Type::Release) {
        isToolPressed = false;
    }
    if (motion.animation)
        return; // the view is still on its way
    hovering.unmark(hovered);
    GestureContext with = context();
    takeFromTool(tool->handle(event, with));
    if (tool && tool->marksSections())
        hover();
}

/// A click that became none of the view's drags.
void Interaction::Private::feedClick(const PointerEvent &press)
{
    PointerEvent release = press;
    release.type = PointerEvent::Type::Release;
    release.time = now;
    toolPress = press;
    GestureContext with = context();
    takeFromTool(tool->handle(press, with));
    if (!tool)
        return;
    GestureContext after = context();
    takeFromTool(tool->handle(release, after));
}

void Interaction::Private::takeFromTool(GestureReply reply)
{
    const bool isOver = reply.state == GestureReply::State::Over;
    if (isOver)
        layToolDown();
    if (!reply.commit)
        showPreview(std::move(reply.preview));
    if (reply.left)
        motion.history.leave(*reply.left, ViewHistory::Change::Turn);
    const QuietTool quiet(isToolCommitting);
    carryOut(reply);
    if (reply.isClick)
        click(toolPress);
    if (isOver)
        hover();
}

void Interaction::Private::layToolDown()
{
    if (tool) {
        GestureContext with = context();
        tool->end(with);
    }
    tool.reset();
    isToolPressed = false;
    clearOverlay();
    clicks.forget();
}

void Interaction::pickUp(std::unique_ptr<Tool> tool, double time)
{
    const bool isSame = d->tool && d->tool->isSame(*tool);
    layDown(time);
    if (isSame)
        return;
    d->cancelGesture();
    if (d->looksOnly)
        return d->update();
    d->stopMotion();
    d->note.reset();
    d->offer({});
    d->tool = std::move(tool);
    d->points.clear(); // they are not seen meanwhile
    d->hovering.unmark(d->hovered);
    GestureContext with = d->context();
    d->takeFromTool(d->tool->begin(with, d->now));
    d->update();
}

void Interaction::layDown(double time)
{
    advance(time);
    while (d->cancelTool())
        ;
    d->update();
}

const Tool *Interaction::tool() const
{
    return d->tool.get();
}

bool Interaction::wants(ToolKey key) const
{
    return d->tool && d->tool->wants(key);
}

bool Interaction::key(ToolKey key, double time)
{
    advance(time);
    if (!wants(key))
        return false;
    GestureContext with = d->context();
    d->takeFromTool(d->tool->key(key, with));
    d->update();
    return true;
}

bool Interaction::useCanvas(const CanvasChoice &canvas, double time)
{
    if (!d->tool)
        return false;
    advance(time);
    d->cancelGesture();
    d->stopMotion();
    GestureContext with = d->context();
    std::optional<GestureReply> reply = d->tool->useCanvas(canvas, with);
    if (!reply)
        return false;
    d->takeFromTool(*std::move(reply));
    d->update();
    return true;
}

bool Interaction::canUndoInTool() const
{
    return d->tool && d->tool->canUndo();
}

bool Interaction::canRedoInTool() const
{
    return d->tool && d->tool->canRedo();
}

bool Interaction::undoInTool(double time)
{
    if (!canUndoInTool())
        return false;
    advance(time);
    GestureContext with = d->context();
    d->takeFromTool(d->tool->undo(with));
    d->update();
    return true;
}

bool Interaction::redoInTool(double time)
{
    if (!canRedoInTool())
        return false;
    advance(time);
    GestureContext with = d->context();
    d->takeFromTool(d->tool->redo(with));
    d->update();
    return true;
}

std::vector<ToolNumber> Interaction::numbers() const
{
    return d->tool ? d->tool->numbers() : std::vector<ToolNumber>();
}

void Interaction::setNumbers(const std::vector<ToolNumber> &numbers, double time)
{
    advance(time);
    if (!d->tool)
        return;
    GestureContext with = d->context();
    d->takeFromTool(d->tool->setNumbers(numbers, with));
    d->update();
}

void Interaction::dropNumbers(double time)
{
    advance(time);
    if (!d->tool)
        return;
    GestureContext with = d->context();
    d->takeFromTool(d->tool->dropNumbers(with));
    d->update();
}

} // namespace fff
