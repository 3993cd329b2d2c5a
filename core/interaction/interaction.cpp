#include "core/interaction/interaction.h"

#include "core/interaction/click_selection.h"
#include "core/interaction/hovering.h"
#include "core/interaction/routing.h"
#include "core/interaction/tool.h"
#include "core/interaction/view_gestures.h"
#include "core/interaction/view_motion.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace fff {

namespace {

/// Nearer by this factor for each notch of the wheel.
constexpr double kZoomPerNotch = 1.2;
/// How long the view takes to return when a gesture comes to nothing, ms; never longer than a turn.
constexpr double kReturnTime = 400.0;
/// How long a note or a refusal is said, ms, unless a press comes first.
constexpr double kNoteTime = 6000.0;
/// A click on the view cube turns in this time, ms; never longer than a turn.
constexpr double kCubeTime = 400.0;
/// Between the two presses of a double click, ms.
constexpr double kDoubleClickTime = 400.0;

/// Says, as long as it lives, that what changes is a tool's own doing.
class QuietTool
{
public:
    explicit QuietTool(bool &isCommitting) : m_isCommitting(isCommitting), m_was(isCommitting)
    {
        m_isCommitting = true;
    }
    ~QuietTool() { m_isCommitting = m_was; }
    QuietTool(const QuietTool &) = delete;
    QuietTool &operator=(const QuietTool &) = delete;

private:
    bool &m_isCommitting;
    const bool m_was;
};

struct Note
{
    Hint hint;
    double until = 0.0; // ms
};

} // namespace

class Interaction::Private
{
public:
    explicit Private(InteractionHost &h) : host(h), document(h.model().document)
    {
        motion.fitFirst(host.model().bounds());
    }

    GestureContext context()
    {
        return {host.model(), settings, motion.viewport, motion.camera,
                overlay,      view,     selection,       points};
    }
    Sight sight() const { return {host.model(), motion.camera, motion.viewport, view, marks}; }

    void press(const PointerEvent &event);
    void move(const PointerEvent &event);
    void release(const PointerEvent &event);
    void zoom(const PointerEvent &event, double factor);
    void scroll(const PointerEvent &event);
    void leave();

    void beginWithSecondButton(std::unique_ptr<Gesture> next);
    bool toolTakes(const PointerEvent &event);
    bool toolHasUse(const PointerEvent &press);
    void feedTool(const PointerEvent &event);
    void click(const PointerEvent &press);
    void feed(const PointerEvent &event);
    void take(GestureReply reply);
    void takeFromTool(GestureReply reply);
    void carryOut(GestureReply &reply);
    void layToolDown();
    void showPreview(std::optional<Document> shown);
    bool cancelGesture();
    bool cancelTool();

    bool isSecondClick(const PointerEvent &press);
    bool addPointAt(const PointerEvent &press);
    bool clickPoint(const PointerEvent &press);
    void selectPoints(std::vector<PointAddress> addresses, const Document &of);
    void carryOut(PointEdit edit);

    void hover();
    void hoverPoint();
    void markPoints();
    void update();
    void turn(const Camera &to, double start, double duration);
    void stopMotion();
    void feedClick(const PointerEvent &press);

    InteractionHost &host;
    InteractionSettings settings;
    ViewMotion motion;
    ViewState view;
    std::vector<ProblemMark> marks;
    double now = 0.0; // ms, of the last event

    Document document; // committed, as known here
    Selection selection;
    PointSelection points;
    std::optional<PointTarget> hoveredPoint;
    ClickSelection clicks;
    std::optional<PointerEvent> lastClick; // the first of two, maybe

    std::vector<PointerEvent> pending; // a press and its moves, not yet a click or a drag
    std::unique_ptr<Gesture> gesture;
    bool hasSecondButton = false; // turns the view as long as it is pressed
    std::unique_ptr<Tool> tool;
    bool isToolPressed = false;    // the left button, for the tool
    PointerEvent toolPress;        // of it
    bool isToolCommitting = false; // what changes then is its own doing
    bool hasPreview = false;       // of the gesture
    Camera cameraBefore;           // the gesture
    Button pressed = Button::None;
    Hovering hovering;
    Modifiers modifiers;

    Overlay overlay;
    std::optional<Note> note;
    Hint hint;
    Cursor cursor = Cursor::Arrow;
};

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
    if (gesture || !pending.empty())
        return; // a second button during a gesture
    stopMotion();
    motion.history.interrupt();
    note.reset();
    motion.isTouched = true;
    pressed = event.button;
    if (isSecondClick(event) && addPointAt(event))
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
    GestureContext with = context();
    gesture = gestureFor(begin, sight(), with);
    cameraBefore = motion.camera;
    hovering.unmark(overlay);
    overlay = {};
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

void Interaction::Private::zoom(const PointerEvent &event, double factor)
{
    if (gesture || !pending.empty())
        return;
    stopMotion();
    motion.history.leave(motion.camera, ViewHistory::Change::Wheel);
    clicks.forget();
    motion.isTouched = true;
    motion.camera =
        zoomed(sight().cameraAt(event.position), factor, event.position, motion.viewport);
    hover();
}

void Interaction::Private::scroll(const PointerEvent &event)
{
    if (gesture || !pending.empty())
        return;
    stopMotion();
    motion.history.leave(motion.camera, ViewHistory::Change::Wheel);
    clicks.forget();
    motion.isTouched = true;
    motion.camera = panned(sight().cameraAt(event.position), event.position,
                           event.position + event.scroll, motion.viewport);
    hover();
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
    if (const int number = sight().markAt(begin.position); number > 0) {
        host.chooseProblem(number);
        return;
    }
    if (sight().isOnHandle(begin.position))
        return;
    if (tool && tool->takesClicks()) {
        feedClick(begin);
        return;
    }
    lastClick = begin;
    if (clickPoint(begin))
        return;
    points.clear();
    selection.select(clicks.click(host.model(), sight().hitsAt(begin.position), begin.position,
                                  settings.dragThreshold, begin.modifiers.control,
                                  selection.sections()));
}

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
        if (reply.selectPoints)
            selectPoints(*std::move(reply.selectPoints), shown ? *shown : host.model().document);
        return;
    }
    // The gesture goes first: the host's answer to what follows may come back here.
    gesture.reset();
    hasSecondButton = false;
    if (!reply.returnTo && !(cameraBefore == motion.camera))
        motion.history.leave(cameraBefore, ViewHistory::Change::Drag);
    pending.clear();
    overlay = {};
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
    if (reply.turnTo)
        turn(*reply.turnTo, now, settings.turnTime);
    if (reply.commit) {
        hasPreview = false; // the commit ends it
        document = reply.commit->document;
        host.commit(reply.commit->step, std::move(reply.commit->document));
    }
    if (reply.selectPoints)
        selectPoints(*std::move(reply.selectPoints), host.model().document);
}

// Control points.

/// Soon after a click at the same place. The window may know before us, scripts do not say it.
bool Interaction::Private::isSecondClick(const PointerEvent &press)
{
    const std::optional<PointerEvent> first = std::exchange(lastClick, std::nullopt);
    return press.button == Button::Left && first &&
           (press.type == PointerEvent::Type::DoubleClick ||
            press.time - first->time <= kDoubleClickTime) &&
           (press.position - first->position).norm() <= settings.dragThreshold;
}

bool Interaction::Private::addPointAt(const PointerEvent &press)
{
    if (!overlay.points || isOnViewMark(sight(), press.position))
        return false;
    const auto target = pointTargetAt(sight(), overlay.points->section, points, press.position);
    if (!target || target->kind != PointTarget::Kind::Line)
        return false;
    const SectionId id = selection.sections().front().drawn;
    carryOut(withInsertedPoint(host.model().document, id, target->point.boundary,
                               {target->point.index, target->t}, {settings.cutsAtGround}));
    return true;
}

/// True when there is something of the contour's there: the click is none on a section.
bool Interaction::Private::clickPoint(const PointerEvent &press)
{
    if (!overlay.points)
        return false;
    const int index = overlay.points->section;
    const auto target = pointTargetAt(sight(), index, points, press.position);
    if (!target)
        return false;
    const Section &section = *host.model().section(static_cast<std::size_t>(index));
    if (target->kind == PointTarget::Kind::Anchor) {
        if (press.modifiers.control)
            points.toggle(section, target->point);
        else
            points.select(section, {target->point});
    }
    return true;
}

void Interaction::Private::selectPoints(std::vector<PointAddress> addresses, const Document &of)
{
    const std::vector<SectionRef> &sections = selection.sections();
    const Section *section = sections.size() == 1 ? of.find(sections.front().drawn) : nullptr;
    if (section && !addresses.empty())
        points.select(*section, std::move(addresses));
    else
        points.clear();
}

void Interaction::Private::carryOut(PointEdit edit)
{
    cancelGesture();
    if (!edit) {
        note = Note{edit.error(), now + kNoteTime};
        return;
    }
    note.reset();
    if (edit->note)
        note = Note{*edit->note, now + kNoteTime};
    document = edit->document;
    host.commit(edit->step, std::move(edit->document));
    clicks.forget();
    selectPoints(std::move(edit->points), host.model().document);
    hover();
}

// Tools.

bool Interaction::Private::toolHasUse(const PointerEvent &press)
{
    GestureContext with = context();
    return tool->takes(press, with);
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
               dragKind(settings.navigation, event.button, event.modifiers) == DragKind::Edit &&
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
    const bool presses =
        event.type == PointerEvent::Type::Press || event.type == PointerEvent::Type::DoubleClick;
    if (presses) {
        motion.finish();
        motion.history.interrupt();
        note.reset();
        motion.isTouched = true;
        isToolPressed = true;
        toolPress = event;
    } else if (event.type == PointerEvent::Type::Release) {
        isToolPressed = false;
    }
    if (motion.animation)
        return; // the view is still on its way
    hovering.unmark(overlay);
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
    tool.reset();
    isToolPressed = false;
    overlay = {};
    clicks.forget();
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
    GestureContext with = context();
    takeFromTool(tool->cancel(with));
    return true;
}

// What is under the cursor, and what is said about it.

void Interaction::Private::hover()
{
    if (motion.animation || (tool && tool->isAnimating()))
        hovering.unmark(overlay);
    else
        hovering.mark(sight(), now, settings.nameDelay, overlay);
    hoverPoint();
}

/// Points are drawn over the sections, and lie before them for the cursor as well.
void Interaction::Private::hoverPoint()
{
    hoveredPoint.reset();
    const std::optional<Vec2> &at = hovering.position();
    if (!at || motion.animation || tool || overlay.cubePart || overlay.mark > 0 ||
        overlay.isHandleHovered)
        return;
    hoveredPoint = pointTargetAt(sight(), sectionWithPoints(sight(), selection), points, *at);
    if (hoveredPoint)
        hovering.unmark(overlay);
}

/// Not while something is drawn: then they would only be in the way.
void Interaction::Private::markPoints()
{
    overlay.points.reset();
    if (points.section() !=
        (selection.sections().size() == 1 ? selection.sections().front().drawn : SectionId()))
        points.clear();
    const bool isDrawing = tool || overlay.stroke || overlay.slit || overlay.deadZone;
    const int index = isDrawing ? -1 : sectionWithPoints(sight(), selection);
    if (index >= 0)
        overlay.points = Overlay::Points{index, points.points(), hoveredPoint};
}

void Interaction::Private::update()
{
    const bool isOnMark = overlay.cubePart || overlay.mark > 0 || overlay.isHandleHovered;
    if (tool) {
        if (!tool->marksSections() && !isOnMark)
            hovering.unmark(overlay);
        GestureContext with = context();
        tool->mark(with, !gesture && pending.empty() && !isOnMark && !motion.animation &&
                             hovering.isOverView());
    }
    if (gesture)
        std::tie(hint, cursor) = std::pair(gesture->hint(), gesture->cursor());
    else if (tool && !isOnMark)
        std::tie(hint, cursor) = std::pair(tool->hint(), tool->cursor());
    else
        std::tie(hint, cursor) =
            hoveredPoint ? hoverHint(*hoveredPoint) : hoverHint(overlay, host.model());
    markPoints();
    if (modifiers.space && !gesture)
        cursor = Cursor::Hand;

    if (note && now >= note->until)
        note.reset();
    if (note && !gesture && !isToolPressed)
        hint = note->hint;
}

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
    d->motion.viewport = size.cwiseMax(1.0);
    if (!d->motion.isTouched)
        d->motion.fitFirst(d->host.model().bounds());
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
    if (!(view == marked))
        d->cancelGesture(); // what it began on may be gone; red alone disturbs nobody
    d->view = std::move(view);
    d->clicks.forget();
    d->hover();
    d->update();
}

const std::vector<ProblemMark> &Interaction::marks() const
{
    return d->marks;
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
    advance(event.time);
    if (event.type != PointerEvent::Type::Leave)
        d->hovering.moveTo(event.position);
    d->modifiers = event.modifiers;
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
    const bool hadNote = d->note.has_value();
    d->note.reset();
    const bool hadGesture = d->cancelGesture() || d->cancelTool();
    const bool hadPoints = !hadGesture && !d->points.isEmpty();
    const bool hadSelection = !hadGesture && !hadPoints && !d->selection.isEmpty();
    const bool hadView =
        !hadGesture && !hadPoints && !hadSelection && (d->view.clip || !d->view.isolated.empty());
    if (hadPoints)
        d->points.clear();
    if (hadSelection)
        d->selection.select({});
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

bool Interaction::advance(double time)
{
    d->now = std::max(d->now, time);
    if (d->gesture) {
        GestureContext with = d->context();
        d->gesture->advance(d->now, with);
    } else if (d->tool && !d->motion.animation) {
        GestureContext with = d->context();
        d->tool->advance(d->now, with);
    }
    if (d->motion.advance(d->now)) {
        d->hovering.disturb();
        d->hover();
    }
    d->hovering.advance(d->now, d->overlay);
    d->update();
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

void Interaction::pickUp(std::unique_ptr<Tool> tool, double time)
{
    const bool isSame = d->tool && d->tool->command() == tool->command();
    layDown(time);
    if (isSame)
        return;
    d->cancelGesture();
    d->stopMotion();
    d->note.reset();
    d->tool = std::move(tool);
    d->points.clear(); // they are not seen meanwhile
    d->hovering.unmark(d->overlay);
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

const std::vector<SectionRef> &Interaction::selection() const
{
    return d->selection.sections();
}

void Interaction::select(std::vector<SectionRef> selection)
{
    d->selection.select(std::move(selection));
    d->hoverPoint();
    d->update();
}

const PointSelection &Interaction::points() const
{
    return d->points;
}

void Interaction::selectPoints(std::vector<PointAddress> points)
{
    d->selectPoints(std::move(points), d->host.model().document);
    d->hoverPoint();
    d->update();
}

const Section *Interaction::sectionOfPoints() const
{
    const std::vector<SectionRef> &sections = d->selection.sections();
    return sections.size() == 1 ? d->host.model().document.find(sections.front().drawn) : nullptr;
}

std::optional<PointTarget> Interaction::hoveredPoint() const
{
    return d->hoveredPoint;
}

PointRules Interaction::pointRules() const
{
    return {d->settings.cutsAtGround};
}

void Interaction::carryOut(PointEdit edit, double time)
{
    advance(time);
    d->carryOut(std::move(edit));
    d->update();
}

bool Interaction::nudge(const Vec2 &arrow, double distance, double time)
{
    advance(time);
    if (d->tool)
        return false; // it has the keys
    const Camera &camera = d->motion.camera;
    const Document &document = d->host.model().document;
    if (const Section *section = sectionOfPoints(); section && !d->points.isEmpty()) {
        const Vec2 by = distance * arrowAxis(section->frame, camera, arrow);
        carryOut(movedSelection(document, d->points, by, pointRules()), time);
        return true;
    }
    const PointEdit moved =
        movedSections(document, d->selection.sections(), distance * arrowAxis(camera, arrow));
    if (moved)
        carryOut(moved, time);
    return moved.has_value();
}

void Interaction::modelChanged()
{
    const Model &model = d->host.model();
    if (model.document.isSame(d->document))
        return; // a preview came or went
    d->document = model.document;
    d->cancelGesture();
    if (d->tool && !d->isToolCommitting) {
        GestureContext with = d->context();
        d->takeFromTool(d->tool->modelChanged(with));
    }
    d->clicks.forget();
    d->selection.follow(model);
    d->points.follow(model.document);
    if (!d->motion.isTouched)
        d->motion.fitFirst(model.bounds());
    d->hover();
    d->update();
}

const Overlay &Interaction::overlay() const
{
    return d->overlay;
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
