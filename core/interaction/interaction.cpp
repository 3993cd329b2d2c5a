#include "core/interaction/interaction_private.h"

namespace fff {

// The camera.

/// The view is about to be moved, or something is done in it as it is.
void Interaction::Private::stopMotion()
{
    motion.finish();
    if (tool && tool->isAnimating()) {
        GestureContext with = context();
        tool->finish(with);
    }
}

/// Somewhere on purpose: the view before it is kept.
void Interaction::Private::turn(const Camera &to, double start, double duration)
{
    motion.history.leave(motion.target(), ViewHistory::Change::Turn);
    clicks.forget();
    motion.animate(to, start, duration);
}

Interaction::Interaction(InteractionHost &host) : d(std::make_unique<Private>(host))
{
    d->update();
}

Interaction::~Interaction() = default;

void Interaction::setViewport(const Vec2 &size)
{
    const Vec2 before = std::exchange(d->motion.viewport, size.cwiseMax(1.0));
    // What is drawn stays under the cursor, though the view's middle moved.
    if (d->gesture || d->isToolPressed)
        d->motion.camera =
            panned(d->motion.camera, 0.5 * d->motion.viewport, 0.5 * before, d->motion.viewport);
    d->followRoom();
}

const Vec2 &Interaction::viewport() const
{
    return d->motion.viewport;
}

InteractionSettings &Interaction::settings()
{
    return d->settings;
}

const InteractionSettings &Interaction::settings() const
{
    return d->settings;
}

const Camera &Interaction::camera() const
{
    return d->motion.camera;
}

const Camera &Interaction::targetCamera() const
{
    return d->motion.target();
}

void Interaction::setCamera(const Camera &camera)
{
    turnTo(camera, d->now, 0.0);
}

void Interaction::turnTo(const Camera &camera, double time, double duration)
{
    d->now = std::max(d->now, time);
    d->cancelGesture();
    d->stopMotion();
    d->turn(camera, time, duration);
    d->hover();
    d->update();
}

void Interaction::setProjection(Projection projection)
{
    d->cancelGesture();
    d->stopMotion();
    Camera &camera = d->motion.camera;
    camera = retargeted(camera, d->sight().middleOf(d->selection.sections()), d->motion.viewport);
    camera.projection = projection;
    d->clicks.forget();
    d->hover();
    d->update();
}

void Interaction::goBack(double time, double duration)
{
    d->now = std::max(d->now, time);
    d->cancelGesture();
    d->stopMotion();
    const std::optional<Camera> before = d->motion.history.takeBack(d->motion.camera);
    if (!before)
        return;
    d->clicks.forget();
    d->motion.animate(*before, time, duration);
    d->hover();
    d->update();
}

bool Interaction::canGoBack() const
{
    return d->motion.history.canGoBack(d->motion.target());
}

void Interaction::forgetViews()
{
    d->motion.history.clear();
    d->selection.forget();
    if (d->tool) { // what it has begun belongs to the document before
        d->layToolDown();
        d->showPreview({});
        d->update();
    }
}

const ViewState &Interaction::view() const
{
    return d->view;
}

void Interaction::setView(ViewState view)
{
    if (view == d->view)
        return;
    ViewState marked = d->view;
    marked.problems = view.problems;
    marked.faulty = view.faulty;
    marked.doubtful = view.doubtful;
    if (!(view == marked))
        d->cancelGesture(); // what it began on may be gone; red alone disturbs nobody
    d->view = std::move(view);
    d->clicks.forget();
    if (!d->gesture && d->pending.empty())
        d->hover();
    d->update();
}

const std::vector<ProblemMark> &Interaction::marks() const
{
    return d->marks;
}

bool Interaction::isHandBusy() const
{
    return d->isHandBusy();
}

void Interaction::setListsJoints(bool lists)
{
    if (std::exchange(d->listsJoints, lists) != lists)
        d->update();
}

void Interaction::setMarks(std::vector<ProblemMark> marks)
{
    if (marks == d->marks)
        return;
    d->marks = std::move(marks);
    if (!d->gesture && d->pending.empty())
        d->hover();
    d->update();
}

void Interaction::handle(const PointerEvent &event)
{
    if (!event.position.allFinite())
        return;
    d->moveOn(event.time);
    if (event.type != PointerEvent::Type::Leave && event.type != PointerEvent::Type::Modifiers)
        d->hovering.moveTo(event.position);
    d->modifiers = event.modifiers;
    d->pointer = event.pointer;
    if (d->toolTakes(event)) {
        d->feedTool(event);
        d->update();
        return;
    }
    switch (event.type) {
    case PointerEvent::Type::Press:
    case PointerEvent::Type::DoubleClick: // the second press of two quick strokes
        d->press(event);
        break;
    case PointerEvent::Type::Move:
        d->move(event);
        break;
    case PointerEvent::Type::Release:
        d->release(event);
        break;
    case PointerEvent::Type::Wheel:
        d->zoom(event, std::pow(kZoomPerNotch, event.wheelSteps));
        break;
    case PointerEvent::Type::Zoom:
        d->zoom(event, event.zoomFactor);
        break;
    case PointerEvent::Type::Twist:
        d->twist(event);
        break;
    case PointerEvent::Type::Scroll:
        d->scroll(event);
        break;
    case PointerEvent::Type::Leave:
        d->leave();
        break;
    case PointerEvent::Type::Modifiers:
        if (d->gesture)
            d->feed(event);
        break;
    }
    d->update();
}

bool Interaction::escape(double time)
{
    advance(time);
    if (d->offered) {
        d->offer({});
        d->update();
        return true;
    }
    const bool hadNote = d->note.has_value();
    d->note.reset();
    // A tool knows best how to go back from what its button does.
    const bool isInTool = d->tool && !d->gesture && d->pending.empty();
    const bool hadGesture = isInTool ? d->cancelTool() : d->cancelGesture();
    const bool hadPoints = !hadGesture && !d->points.isEmpty();
    const bool hadSelection = !hadGesture && !hadPoints && !d->selection.isEmpty();
    const bool hadView =
        !hadGesture && !hadPoints && !hadSelection && (d->view.clip || !d->view.isolated.empty());
    if (hadPoints)
        d->points.clear();
    if (hadSelection && d->selection.joint())
        d->selection.leaveJoint(d->host.model());
    else if (hadSelection)
        d->selection.goBack();
    if (hadPoints || hadSelection)
        d->hover();
    if (hadView) {
        if (d->view.clip)
            d->view.clip.reset();
        else
            d->view.isolated.clear();
        d->hover();
    }
    d->update();
    return hadGesture || hadPoints || hadSelection || hadView || hadNote;
}

/// To where an event finds everything.
void Interaction::Private::moveOn(double time)
{
    now = std::max(now, time);
    if (gesture) {
        GestureContext with = context();
        gesture->advance(now, with);
    } else if (tool && !motion.animation) {
        GestureContext with = context();
        tool->advance(now, with);
    }
    if (motion.advance(now)) {
        hovering.disturb();
        hover();
    }
    hovering.advance(now, hovered);
    update();
}

/// A frame is about to be seen: what a stroke has taken in and not shown yet is shown.
void Interaction::Private::showLate()
{
    const bool isDrawn = gesture ? gesture->isAnimating() : isToolPressed && tool->isAnimating();
    if (overlay.drawn.find<sign::Stroke>() && isDrawn)
        showNow();
}

/// An event that changes nothing shows what has changed meanwhile.
void Interaction::Private::showNow()
{
    if (!hovering.position())
        return;
    PointerEvent event;
    event.type = PointerEvent::Type::Modifiers;
    event.position = *hovering.position();
    event.modifiers = modifiers;
    event.pointer = pointer;
    event.time = now;
    if (gesture)
        feed(event);
    else
        feedTool(event);
    update();
}

bool Interaction::advance(double time)
{
    d->moveOn(time);
    d->showLate();
    return isAnimating();
}

bool Interaction::isAnimating() const
{
    return d->motion.animation.has_value() || (d->gesture && d->gesture->isAnimating()) ||
           (d->tool && d->tool->isAnimating());
}

bool Interaction::hasGesture() const
{
    return d->gesture != nullptr || !d->pending.empty() || d->isToolPressed;
}

std::optional<double> Interaction::wakeTime() const
{
    std::optional<double> time = d->hovering.nameTime();
    if (d->note && (!time || d->note->until < *time))
        time = d->note->until;
    return time;
}

const std::vector<SectionRef> &Interaction::selection() const
{
    return d->selection.sections();
}

void Interaction::select(std::vector<SectionRef> selection)
{
    if (d->looksOnly)
        return;
    d->selection.select(std::move(selection));
    d->hoverMarks();
    d->update();
}

const std::optional<JointRef> &Interaction::selectedJoint() const
{
    return d->selection.joint();
}

void Interaction::selectJoint(const JointRef &joint)
{
    if (d->looksOnly || !hasJoint(d->host.model(), joint))
        return;
    d->points.clear();
    d->selection.selectJoint(joint);
    d->hoverMarks();
    d->update();
}

void Interaction::say(const Hint &hint, double time)
{
    advance(time);
    d->note = Note{hint, d->now + kNoteTime};
    d->update();
}

OperationId Interaction::selectedOperation() const
{
    return d->selection.operation();
}

void Interaction::selectOperation(OperationId id)
{
    if (d->looksOnly || !d->host.model().document.find(id))
        return;
    d->points.clear();
    d->selection.selectOperation(id);
    d->hoverMarks();
    d->update();
}

OperationId Interaction::operationInFocus() const
{
    return fff::operationInFocus(d->selection);
}

std::vector<SectionRef> Interaction::sectionsInFocus() const
{
    return fff::sectionsInFocus(d->host.model(), d->selection);
}

const PointSelection &Interaction::points() const
{
    return d->points;
}

void Interaction::selectPoints(std::vector<PointAddress> points)
{
    if (d->looksOnly)
        return;
    d->selectPoints(std::move(points), d->documentOfPoints());
    d->hoverMarks();
    d->update();
}

SectionPointer Interaction::sectionOfPoints() const
{
    const std::vector<SectionRef> &sections = d->selection.sections();
    if (sections.size() != 1)
        return nullptr;
    return editedSection(d->host.model(), sections.front());
}

Document Interaction::documentOfPoints() const
{
    return d->documentOfPoints();
}

std::optional<PointTarget> Interaction::hoveredPoint() const
{
    return d->hoveredPoint;
}

PointRules Interaction::pointRules() const
{
    return d->rulesOfPoints();
}

void Interaction::carryOut(PointEdit edit, double time)
{
    advance(time);
    d->carryOut(std::move(edit));
    d->update();
}

void Interaction::carryOut(SectionEdit edit, double time)
{
    advance(time);
    d->carryOut(std::move(edit));
    d->update();
}

void Interaction::modelChanged()
{
    const Model &model = d->host.model();
    if (model.document.isSame(d->document))
        return; // a preview came or went
    d->document = model.document;
    d->offer({});
    d->cancelGesture();
    if (d->tool && !d->isToolCommitting) {
        GestureContext with = d->context();
        d->takeFromTool(d->tool->modelChanged(with));
    }
    d->clicks.forget();
    d->selection.follow(model);
    d->points.follow(d->documentOfPoints());
    if (!d->motion.isTouched)
        d->fitFirst();
    d->hover();
    d->update();
}

const Overlay &Interaction::overlay() const
{
    return d->overlay;
}

const Hovered &Interaction::hovered() const
{
    return d->hovered;
}

const Hint &Interaction::hint() const
{
    return d->hint;
}

Cursor Interaction::cursor() const
{
    return d->cursor;
}

} // namespace fff
