#include "core/interaction/interaction_private.h"

namespace fff {

namespace {

/// Of whoever only looks.
constexpr Text kLookAround = FFF_TEXT("Hint", "Drag to turn the view; the wheel zooms.");

} // namespace

// What the person does.

void Interaction::Private::press(const PointerEvent &event)
{
    if (pressed == Button::Middle && event.button == Button::Left &&
        turnsWithSecondButton(settings.navigation)) {
        beginWithSecondButton(
            std::make_unique<OrbitGesture>(event, sight().pivotAt(event.position)));
        hasSecondButton = true;
        return;
    }
    if (gesture || !pending.empty() || isToolPressed)
        return; // a second button during a gesture
    stopMotion();
    motion.history.interrupt();
    note.reset();
    offer({});
    motion.isTouched = true;
    pressed = event.button;
    if (!looksOnly && isSecondClick(event) && addPointAt(event))
        return;
    pending = {event};
}

void Interaction::Private::move(const PointerEvent &event)
{
    if (pending.empty()) {
        if (gesture)
            feed(event);
        else
            hover();
        return;
    }
    pending.push_back(event);
    const PointerEvent begin = pending.front();
    if ((event.position - begin.position).norm() <= settings.dragThreshold)
        return;
    // A finger, or a script, comes without having been there before.
    if (const JointMark *mark = looksOnly ? nullptr : jointMarkAt(begin.position)) {
        hoveredJoint = *mark;
        markJoints();
    }
    GestureContext with = context();
    gesture = looksOnly ? viewGestureFor(begin, sight(), with) : gestureFor(begin, sight(), with);
    cameraBefore = motion.camera;
    if (tool && tool->givesWay() && !gesture->isOfView())
        while (cancelTool())
            ;
    clearOverlay();
    const std::vector<PointerEvent> moves(pending.begin() + 1, pending.end());
    pending.clear();
    for (const PointerEvent &moved : moves) {
        if (gesture)
            feed(moved);
    }
}

/// Another way to move the view, in the middle of a drag.
void Interaction::Private::beginWithSecondButton(std::unique_ptr<Gesture> next)
{
    if (!gesture)
        cameraBefore = motion.camera;
    pending.clear();
    clearOverlay();
    gesture = std::move(next);
}

void Interaction::Private::release(const PointerEvent &event)
{
    if (event.button == Button::Left && std::exchange(hasSecondButton, false)) {
        // On with moving the view, from where it is now.
        beginWithSecondButton(std::make_unique<PanGesture>(event));
        return;
    }
    if (event.button != pressed)
        return;
    hasSecondButton = false;
    if (!pending.empty())
        move(event); // may find that it was a drag after all
    if (!pending.empty()) {
        const PointerEvent begin = pending.front();
        pending.clear();
        click(begin);
    } else if (gesture) {
        feed(event);
    }
    pressed = Button::None;
    if (!gesture)
        hover();
}

/// Moves the view at once, without a gesture. What `moved` gets has its target at the depth
/// of what is under the cursor.
void Interaction::Private::roll(const PointerEvent &event,
                                const std::function<Camera(const Camera &)> &moved)
{
    if (gesture || !pending.empty() || isToolPressed)
        return;
    stopMotion();
    motion.history.leave(motion.camera, ViewHistory::Change::Wheel);
    clicks.forget();
    motion.isTouched = true;
    motion.camera = moved(sight().cameraAt(event.position));
    hover();
}

void Interaction::Private::zoom(const PointerEvent &event, double factor)
{
    roll(event, [&](const Camera &camera) {
        return zoomed(camera, factor, event.position, motion.viewport);
    });
}

void Interaction::Private::scroll(const PointerEvent &event)
{
    roll(event, [&](const Camera &camera) {
        return panned(camera, event.position, event.position + event.scroll, motion.viewport);
    });
}

/// About the upright through what is under it, as on a turntable.
void Interaction::Private::twist(const PointerEvent &event)
{
    const Vec3 pivot = sight().pivotAt(event.position);
    roll(event, [&](const Camera &camera) {
        const double perRadian = motion.viewport.minCoeff() / std::numbers::pi;
        return orbited(camera, Vec2(-perRadian * event.angle, 0.0), pivot, motion.viewport);
    });
}

void Interaction::Private::leave()
{
    hovering.leave();
    if (!gesture && pending.empty())
        hover();
}

void Interaction::Private::click(const PointerEvent &begin)
{
    if (begin.button != Button::Left || begin.modifiers.space)
        return;
    if (const auto part = sight().cubePartAt(begin.position)) {
        turn(turned(motion.camera, orientationOfPart(*part), sight().middleOf(selection.sections()),
                    motion.viewport),
             now, std::min(kCubeTime, settings.turnTime));
        return;
    }
    if (looksOnly)
        return;
    if (const std::optional<PlacedMark> mark = sight().markAt(begin.position)) {
        const ProblemMark &chosen = marks[chosenBy(*mark, marks)];
        host.chooseProblem(chosen.number, chosen.place);
        return;
    }
    if (sight().isOnHandle(begin.position))
        return;
    if (tool && tool->takesClicks()) {
        feedClick(begin);
        return;
    }
    if (const auto handle = operationHandleAt(begin.position)) {
        host.chooseParameter(handle->operation, handle->key);
        return;
    }
    if (const LoadId load = loadAt(begin.position); load.isValid()) {
        points.clear();
        selection.selectLoad(load);
        return;
    }
    if (const JointMark *mark = jointMarkAt(begin.position)) {
        points.clear();
        selection.selectJoint(mark->joint);
        return;
    }
    lastClick = begin;
    if (clickPoint(begin))
        return;
    points.clear();
    clicks.click(host.model(), sight().hitsAt(begin.position), begin.position,
                 settings.dragThreshold, begin.modifiers.control, selection);
}

// What is under the cursor, and what is said about it.

void Interaction::Private::hover()
{
    if (motion.animation || (tool && tool->isAnimating()))
        hovering.unmark(hovered);
    else
        hovering.mark(sight(), now, settings.nameDelay, hovered);
    if (looksOnly)
        hoverViewOnly();
    sectionUnderCursor = hovered.section;
    hoverMarks();
}

/// What is drawn over the sections lies before them for the cursor as well, handles first.
void Interaction::Private::hoverMarks()
{
    if (looksOnly)
        return; // none is shown
    hoverOperation();
    hoverLoad();
    hoverMagnet();
    hoverJoint();
    hoverPoint();
}

void Interaction::Private::hoverPoint()
{
    hoveredPoint.reset();
    const std::optional<Vec2> &at = hovering.position();
    if (!at || hoveredJoint || hoveredHandle || isOverMagnet || hovered.load.isValid() ||
        motion.animation || tool || hovered.cubePart || hovered.problem > 0 || hovered.isCutHandle)
        return;
    if (const auto section = sectionWithPoints(sight(), selection))
        hoveredPoint = pointTargetAt(sight(), *section, points, *at);
    if (hoveredPoint)
        hovering.unmark(hovered);
}

/// Not while something is drawn: then marks would only be in the way.
bool Interaction::Private::marksSelection() const
{
    return !tool && !overlay.hasStroke();
}

bool Interaction::Private::isHandBusy() const
{
    return tool || overlay.hasStroke() || (gesture && !gesture->isOfView());
}

void Interaction::Private::markPoints()
{
    overlay.selected.remove<sign::Points>();
    const std::vector<SectionRef> &sections = selection.sections();
    const std::optional<Origin> origin =
        sections.size() == 1 ? originOf(host.model(), sections.front()) : std::nullopt;
    if (points.section() != (origin ? origin->section->id : SectionId()))
        points.clear();
    const bool isInWay = gesture && !gesture->isOfView() && !gesture->marksPoints();
    if (const auto ref =
            marksSelection() && !isInWay ? sectionWithPoints(sight(), selection) : std::nullopt)
        overlay.selected.put(sign::Points{
            *ref, points.points(),
            // While it is dragged it is among those that are selected, under a number of its own.
            gesture && gesture->marksPoints() ? std::nullopt : hoveredPoint});
}

void Interaction::Private::clearOverlay()
{
    hovering.unmark(hovered);
    overlay = {};
}

void Interaction::Private::update()
{
    // What a tool holds passes over them.
    const bool isOnMark =
        !isToolPressed && (hovered.cubePart || hovered.problem > 0 || hovered.isCutHandle);
    overlay.held.clear();
    if (tool) {
        if (!tool->marksSections() && !isOnMark)
            hovering.unmark(hovered);
        GestureContext with = context();
        tool->mark(with, !gesture && pending.empty() && !isOnMark && !motion.animation &&
                             hovering.isOverView());
    }
    if (gesture)
        std::tie(hint, cursor) = std::pair(gesture->hint(), gesture->cursor());
    else if (tool && !isOnMark)
        std::tie(hint, cursor) = std::pair(tool->hint(), tool->cursor());
    else if (looksOnly && !hovered.cubePart)
        std::tie(hint, cursor) = std::pair(Hint::ofView(kLookAround), Cursor::Arrow);
    else if (hoveredHandle)
        std::tie(hint, cursor) = hoverHint(*hoveredHandle, host.model());
    else if (isOverMagnet)
        std::tie(hint, cursor) = std::pair(magnetHint(), Cursor::MoveCross);
    else if (hoveredJoint)
        std::tie(hint, cursor) =
            hoverHint(*hoveredJoint, host.model(), selection.joint() == hoveredJoint->joint);
    else
        std::tie(hint, cursor) = hoveredPoint
                                     ? hoverHint(*hoveredPoint)
                                     : hoverHint(hovered, overlay, host.model(), selection);
    markPoints();
    markJoints();
    markOperation();
    markMagnet();
    if (modifiers.space && !gesture)
        cursor = Cursor::Hand;

    if (note && now >= note->until)
        note.reset();
    if (note && !gesture && !isToolPressed)
        hint = note->hint;
}

} // namespace fff
