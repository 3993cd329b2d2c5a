#include "core/interaction/interaction.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/click_selection.h"
#include "core/interaction/clip_gesture.h"
#include "core/interaction/stroke_gesture.h"
#include "core/interaction/view_gestures.h"
#include "core/interaction/view_motion.h"

#include <algorithm>
#include <cmath>
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
/// A name stays while the cursor is this near to where it was shown, px.
constexpr double kNameReach = 24.0;

struct Note
{
    Hint hint;
    double until = 0.0; // ms
};

bool isSame(const Camera &a, const Camera &b)
{
    return a.target == b.target && a.orientation.coeffs() == b.orientation.coeffs() &&
           a.millimetresPerPixel == b.millimetresPerPixel && a.projection == b.projection;
}

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
        return {host.model(), settings, motion.viewport, motion.camera, overlay, view};
    }
    std::vector<Hit> hitsAt(const Vec2 &position) const;
    const Section &sectionAt(const Hit &hit) const;
    /// Whether the section is seen so much on edge there that points on it are guesses.
    bool isOnEdge(const Hit &hit) const;
    bool isOnHandle(const Vec2 &position) const;
    int markUnder(const Vec2 &position) const;

    void press(const PointerEvent &event);
    void move(const PointerEvent &event);
    void release(const PointerEvent &event);
    void zoom(const PointerEvent &event, double factor);
    void scroll(const PointerEvent &event);
    void leave();

    std::unique_ptr<Gesture> gestureFor(const PointerEvent &press);
    Vec3 middle() const;
    Vec3 pivotAt(const Vec2 &position) const;
    Camera cameraAt(const Vec2 &position) const;
    void click(const PointerEvent &press);
    void feed(const PointerEvent &event);
    void take(GestureReply reply);
    void showPreview(std::optional<Document> shown);
    bool cancelGesture();

    void hover();
    void say(Hint next, Cursor nextCursor);
    void update();
    void turn(const Camera &to, double start, double duration);

    InteractionHost &host;
    InteractionSettings settings;
    ViewMotion motion;
    ViewState view;
    std::vector<ProblemMark> marks;
    double now = 0.0; // ms, of the last event

    Document document; // committed, as known here
    std::vector<SectionRef> selection;
    ClickSelection clicks;

    std::vector<PointerEvent> pending; // a press and its moves, not yet a click or a drag
    std::unique_ptr<Gesture> gesture;
    bool hasPreview = false; // of the gesture
    Camera cameraBefore;     // the gesture
    Button pressed = Button::None;
    std::optional<Vec2> cursorPosition; // none: not over the viewport
    bool cursorRests = false;           // since the hover before this one
    std::optional<double> nameTime;     // ms, when the name of what is hovered is to be shown
    Modifiers modifiers;

    Overlay overlay;
    std::optional<Note> note;
    Hint hint;
    Cursor cursor = Cursor::Arrow;
};

// Routing: which gesture a press begins.

std::vector<Hit> Interaction::Private::hitsAt(const Vec2 &position) const
{
    return pick(host.model(), motion.camera.rayThrough(position, motion.viewport), view);
}

const Section &Interaction::Private::sectionAt(const Hit &hit) const
{
    return *host.model().section(static_cast<std::size_t>(hit.section));
}

bool Interaction::Private::isOnEdge(const Hit &hit) const
{
    const Vec3 eye = motion.camera.towardsEye(hit.point, motion.viewport);
    return std::abs(sectionAt(hit).frame.normal().dot(eye)) < std::sin(kMinDrawAngle);
}

bool Interaction::Private::isOnHandle(const Vec2 &position) const
{
    if (!view.clip)
        return false;
    const Vec3 handle = clipHandle(*view.clip, host.model().bounds());
    return (motion.camera.toScreen(handle, motion.viewport) - position).norm() <= kHandleReach;
}

int Interaction::Private::markUnder(const Vec2 &position) const
{
    return markAt(position, placeMarks(marks, motion.camera, motion.viewport, view));
}

std::unique_ptr<Gesture> Interaction::Private::gestureFor(const PointerEvent &press)
{
    const Vec2 &at = press.position;
    const bool isLeft = press.button == Button::Left;
    if (isLeft && cubePartAt(at, motion.camera.orientation, motion.viewport))
        return std::make_unique<OrbitGesture>(press, middle());
    if (isLeft && markUnder(at) > 0)
        return std::make_unique<OrbitGesture>(press, pivotAt(at));
    if (isLeft && isOnHandle(at))
        return std::make_unique<ClipGesture>(press, context());
    motion.camera = cameraAt(at);
    if (press.button == Button::Middle || (isLeft && press.modifiers.space))
        return std::make_unique<PanGesture>(press);
    if (isLeft && !press.modifiers.control) {
        if (host.model().sectionCount() == 0)
            return std::make_unique<StrokeGesture>(press, context());
        const std::vector<Hit> hits = hitsAt(at);
        if (!hits.empty() && !isOnEdge(hits.front()))
            return std::make_unique<StrokeGesture>(press, hits.front(), context());
    }
    return std::make_unique<OrbitGesture>(press, pivotAt(at));
}

/// The same view; in perspective, pixels count at the depth of what is there.
Camera Interaction::Private::cameraAt(const Vec2 &position) const
{
    return motion.camera.isPerspective()
               ? retargeted(motion.camera, pivotAt(position), motion.viewport)
               : motion.camera;
}

/// Of what is selected and there, else of the model.
Vec3 Interaction::Private::middle() const
{
    const Model &model = host.model();
    Box3 box;
    for (const SectionRef &ref : selection) {
        if (const int index = model.indexOf(ref); index >= 0) {
            const Section &section = *model.section(static_cast<std::size_t>(index));
            box.extend(worldBounds(*section.shape, section.frame));
        }
    }
    if (box.isEmpty())
        box = model.bounds();
    return box.isEmpty() ? Vec3(0.0, kFirstPlaneHeight, 0.0) : box.center();
}

/// What was pressed, else the middle of the model.
Vec3 Interaction::Private::pivotAt(const Vec2 &position) const
{
    if (const std::vector<Hit> hits = hitsAt(position); !hits.empty())
        return hits.front().point;
    const Box3 box = host.model().bounds();
    return box.isEmpty() ? Vec3(0.0, kFirstPlaneHeight, 0.0) : box.center();
}

void Interaction::Private::press(const PointerEvent &event)
{
    if (gesture || !pending.empty())
        return; // a second button during a gesture
    motion.finish();
    motion.history.interrupt();
    note.reset();
    motion.isTouched = true;
    pressed = event.button;
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
    gesture = gestureFor(begin);
    cameraBefore = motion.camera;
    overlay = {}; // what hovering marked
    const std::vector<PointerEvent> moves(pending.begin() + 1, pending.end());
    pending.clear();
    for (const PointerEvent &moved : moves) {
        if (gesture)
            feed(moved);
    }
}

void Interaction::Private::release(const PointerEvent &event)
{
    if (event.button != pressed)
        return;
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
    motion.finish();
    motion.history.leave(motion.camera, ViewHistory::Change::Wheel);
    clicks.forget();
    motion.isTouched = true;
    motion.camera = zoomed(cameraAt(event.position), factor, event.position, motion.viewport);
    hover();
}

void Interaction::Private::scroll(const PointerEvent &event)
{
    if (gesture || !pending.empty())
        return;
    motion.finish();
    motion.history.leave(motion.camera, ViewHistory::Change::Wheel);
    clicks.forget();
    motion.isTouched = true;
    motion.camera = panned(cameraAt(event.position), event.position, event.position + event.scroll,
                           motion.viewport);
    hover();
}

void Interaction::Private::leave()
{
    cursorPosition.reset();
    if (!gesture && pending.empty())
        hover();
}

void Interaction::Private::click(const PointerEvent &begin)
{
    if (begin.button != Button::Left || begin.modifiers.space)
        return;
    if (const auto part = cubePartAt(begin.position, motion.camera.orientation, motion.viewport)) {
        turn(turned(motion.camera, orientationOfPart(*part), middle(), motion.viewport), now,
             std::min(kCubeTime, settings.turnTime));
        return;
    }
    if (const int number = markUnder(begin.position); number > 0) {
        host.chooseProblem(number);
        return;
    }
    if (isOnHandle(begin.position))
        return;
    selection = clicks.click(host.model(), hitsAt(begin.position), begin.position,
                             settings.dragThreshold, begin.modifiers.control, selection);
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
        showPreview(std::move(reply.preview));
        return;
    }
    // The gesture goes first: the host's answer to what follows may come back here.
    gesture.reset();
    if (!reply.returnTo && !isSame(cameraBefore, motion.camera))
        motion.history.leave(cameraBefore, ViewHistory::Change::Drag);
    pending.clear();
    overlay = {};
    if (reply.note)
        note = Note{*reply.note, now + kNoteTime};
    if (reply.returnTo)
        motion.animate(*reply.returnTo, now, std::min(kReturnTime, settings.turnTime));
    if (reply.commit) {
        hasPreview = false; // the commit ends it
        document = reply.commit->document;
        host.commit(reply.commit->step, std::move(reply.commit->document));
    } else {
        showPreview({});
    }
    clicks.forget();
    hover();
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

// What is under the cursor, and what is said about it.

void Interaction::Private::hover()
{
    const int hovered = std::exchange(overlay.hovered, -1);
    overlay.slitStart.reset();
    overlay.cubePart.reset();
    overlay.isHandleHovered = false;
    overlay.mark = 0;
    const std::optional<double> nameDue = std::exchange(nameTime, {});
    const std::optional<Vec2> namePlace = std::exchange(overlay.namePlace, {});
    if (!cursorPosition || motion.animation)
        return;
    overlay.cubePart = cubePartAt(*cursorPosition, motion.camera.orientation, motion.viewport);
    if (overlay.cubePart)
        return;
    overlay.mark = markUnder(*cursorPosition);
    if (overlay.mark > 0)
        return;
    overlay.isHandleHovered = isOnHandle(*cursorPosition);
    if (overlay.isHandleHovered)
        return;
    const std::vector<Hit> hits = hitsAt(*cursorPosition);
    if (hits.empty())
        return;
    overlay.hovered = hits.front().section;
    if (!isOnEdge(hits.front()))
        overlay.slitStart = hits.front().point;
    if (overlay.hovered == hovered && namePlace &&
        (*namePlace - *cursorPosition).norm() <= kNameReach)
        overlay.namePlace = namePlace;
    else if (overlay.hovered == hovered && nameDue && cursorRests)
        nameTime = nameDue;
    else
        nameTime = now + settings.nameDelay;
}

void Interaction::Private::say(Hint next, Cursor nextCursor)
{
    hint = std::move(next);
    cursor = nextCursor;
}

void Interaction::Private::update()
{
    if (gesture)
        say(gesture->hint(), gesture->cursor());
    else if (overlay.cubePart)
        say({Hint::Kind::LookFrom, std::string(nameOfPart(*overlay.cubePart)), false},
            Cursor::Hand);
    else if (overlay.mark > 0)
        say({Hint::Kind::ChooseProblem, std::to_string(overlay.mark), false}, Cursor::Hand);
    else if (overlay.isHandleHovered)
        say({Hint::Kind::MoveCut, {}, false}, Cursor::MoveCross);
    else if (host.model().sectionCount() == 0)
        say({Hint::Kind::DrawFirstSection, {}, false}, Cursor::Pencil);
    else if (overlay.slitStart)
        say({Hint::Kind::DragOutOfSection,
             host.model().section(static_cast<std::size_t>(overlay.hovered))->name, false},
            Cursor::PencilWithSlit);
    else
        say({Hint::Kind::TurnView, {}, false}, Cursor::Arrow);
    if (modifiers.space && !gesture)
        cursor = Cursor::Hand;

    if (note && now >= note->until)
        note.reset();
    if (note && !gesture)
        hint = note->hint;
}

// The camera.

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
    d->motion.finish();
    d->turn(camera, time, duration);
    d->hover();
    d->update();
}

void Interaction::setProjection(Projection projection)
{
    d->cancelGesture();
    d->motion.finish();
    Camera &camera = d->motion.camera;
    camera = retargeted(camera, d->middle(), d->motion.viewport);
    camera.projection = projection;
    d->clicks.forget();
    d->hover();
    d->update();
}

void Interaction::goBack(double time, double duration)
{
    d->now = std::max(d->now, time);
    d->cancelGesture();
    d->motion.finish();
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
    d->cursorRests = event.type != PointerEvent::Type::Leave && d->cursorPosition == event.position;
    if (event.type != PointerEvent::Type::Leave)
        d->cursorPosition = event.position;
    d->modifiers = event.modifiers;
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
    }
    d->update();
}

bool Interaction::escape(double time)
{
    advance(time);
    const bool hadNote = d->note.has_value();
    d->note.reset();
    const bool hadGesture = d->cancelGesture();
    const bool hadSelection = !hadGesture && !d->selection.empty();
    const bool hadView =
        !hadGesture && !hadSelection && (d->view.clip || !d->view.isolated.empty());
    if (hadSelection)
        d->selection.clear();
    if (hadView) {
        if (d->view.clip)
            d->view.clip.reset();
        else
            d->view.isolated.clear();
        d->hover();
    }
    d->update();
    return hadGesture || hadSelection || hadView || hadNote;
}

bool Interaction::advance(double time)
{
    d->now = std::max(d->now, time);
    if (d->gesture) {
        GestureContext with = d->context();
        d->gesture->advance(d->now, with);
    }
    if (d->motion.advance(d->now)) {
        d->cursorRests = false;
        d->hover();
    }
    if (d->nameTime && d->now >= *d->nameTime) {
        d->nameTime.reset();
        d->overlay.namePlace = d->cursorPosition;
    }
    d->update();
    return isAnimating();
}

bool Interaction::isAnimating() const
{
    return d->motion.animation.has_value() || (d->gesture && d->gesture->isAnimating());
}

bool Interaction::hasGesture() const
{
    return d->gesture != nullptr || !d->pending.empty();
}

std::optional<double> Interaction::wakeTime() const
{
    std::optional<double> time = d->nameTime;
    if (d->note && (!time || d->note->until < *time))
        time = d->note->until;
    return time;
}

const std::vector<SectionRef> &Interaction::selection() const
{
    return d->selection;
}

void Interaction::select(std::vector<SectionRef> selection)
{
    d->selection = std::move(selection);
}

void Interaction::modelChanged()
{
    const Model &model = d->host.model();
    if (model.document.isSame(d->document))
        return; // a preview came or went
    d->document = model.document;
    d->cancelGesture();
    d->clicks.forget();
    std::erase_if(d->selection, [&](const SectionRef &ref) { return model.indexOf(ref) < 0; });
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
