#include "core/interaction/interaction.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/camera_animation.h"
#include "core/interaction/click_selection.h"
#include "core/interaction/stroke_gesture.h"
#include "core/interaction/view_gestures.h"

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

struct Note
{
    Hint hint;
    double until = 0.0; // ms
};

/// Whether the section is seen so much on edge that points on it are guesses.
bool isOnEdge(const Section &section, const Camera &camera)
{
    return std::abs(section.frame.normal().dot(camera.forward())) < std::sin(kMinDrawAngle);
}

} // namespace

class Interaction::Private
{
public:
    explicit Private(InteractionHost &h) : host(h), document(h.model().document) { fitFirst(); }

    GestureContext context() { return {host.model(), settings, viewport, camera, overlay}; }
    std::vector<Hit> hitsAt(const Vec2 &position) const;
    const Section &sectionAt(const Hit &hit) const;

    void press(const PointerEvent &event);
    void move(const PointerEvent &event);
    void release(const PointerEvent &event);
    void wheel(const PointerEvent &event);
    void leave();

    std::unique_ptr<Gesture> gestureFor(const PointerEvent &press);
    Vec3 pivotAt(const Vec2 &position) const;
    void click(const PointerEvent &press);
    void feed(const PointerEvent &event);
    void take(GestureReply reply);
    void showPreview(std::optional<Document> shown);
    bool cancelGesture();

    void hover();
    void say(Hint next, Cursor nextCursor);
    void update();
    void fitFirst();
    void animate(const Camera &to, double start, double duration);
    void finishAnimation();

    InteractionHost &host;
    InteractionSettings settings;
    Vec2 viewport{1280.0, 800.0};
    Camera camera;
    bool isCameraTouched = false; // until then it follows the viewport's size
    std::optional<CameraAnimation> animation;
    double now = 0.0; // ms, of the last event

    Document document; // committed, as known here
    std::vector<SectionRef> selection;
    ClickSelection clicks;

    std::vector<PointerEvent> pending; // a press and its moves, not yet a click or a drag
    std::unique_ptr<Gesture> gesture;
    bool hasPreview = false; // of the gesture
    Button pressed = Button::None;
    std::optional<Vec2> cursorPosition; // none: not over the viewport
    Modifiers modifiers;

    Overlay overlay;
    std::optional<Note> note;
    Hint hint;
    Cursor cursor = Cursor::Arrow;
};

// Routing: which gesture a press begins.

std::vector<Hit> Interaction::Private::hitsAt(const Vec2 &position) const
{
    return pick(host.model(), camera.rayThrough(position, viewport));
}

const Section &Interaction::Private::sectionAt(const Hit &hit) const
{
    return *host.model().section(static_cast<std::size_t>(hit.section));
}

std::unique_ptr<Gesture> Interaction::Private::gestureFor(const PointerEvent &press)
{
    const bool pans =
        press.button == Button::Middle || (press.button == Button::Left && press.modifiers.space);
    if (pans)
        return std::make_unique<PanGesture>(press);
    if (press.button == Button::Left && !press.modifiers.control) {
        if (host.model().sectionCount() == 0)
            return std::make_unique<StrokeGesture>(press, context());
        const std::vector<Hit> hits = hitsAt(press.position);
        if (!hits.empty() && !isOnEdge(sectionAt(hits.front()), camera))
            return std::make_unique<StrokeGesture>(press, hits.front(), context());
    }
    return std::make_unique<OrbitGesture>(press, pivotAt(press.position));
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
    finishAnimation();
    note.reset();
    isCameraTouched = true;
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

void Interaction::Private::wheel(const PointerEvent &event)
{
    if (gesture || !pending.empty())
        return;
    finishAnimation();
    clicks.forget();
    isCameraTouched = true;
    camera = zoomed(camera, std::pow(kZoomPerNotch, event.wheelSteps), event.position, viewport);
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
    pending.clear();
    overlay = {};
    if (reply.note)
        note = Note{*reply.note, now + kNoteTime};
    if (reply.returnTo)
        animate(*reply.returnTo, now, std::min(kReturnTime, settings.turnTime));
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
    overlay.hovered = -1;
    overlay.slitStart.reset();
    if (!cursorPosition || animation)
        return;
    const std::vector<Hit> hits = hitsAt(*cursorPosition);
    if (hits.empty())
        return;
    overlay.hovered = hits.front().section;
    if (!isOnEdge(sectionAt(hits.front()), camera))
        overlay.slitStart = hits.front().point;
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

/// What a document is first seen in: from the front, fitted.
void Interaction::Private::fitFirst()
{
    camera = fitted(Camera(), host.model().bounds(), viewport);
}

void Interaction::Private::animate(const Camera &to, double start, double duration)
{
    isCameraTouched = true;
    clicks.forget();
    animation.reset();
    if (duration > 0.0)
        animation = CameraAnimation{camera, to, start, duration};
    else
        camera = to;
}

void Interaction::Private::finishAnimation()
{
    if (!animation)
        return;
    camera = animation->to;
    animation.reset();
}

Interaction::Interaction(InteractionHost &host) : d(std::make_unique<Private>(host))
{
    d->update();
}

Interaction::~Interaction() = default;

void Interaction::setViewport(const Vec2 &size)
{
    d->viewport = size.cwiseMax(1.0);
    if (!d->isCameraTouched)
        d->fitFirst();
}

const Vec2 &Interaction::viewport() const
{
    return d->viewport;
}

InteractionSettings &Interaction::settings()
{
    return d->settings;
}

const Camera &Interaction::camera() const
{
    return d->camera;
}

const Camera &Interaction::targetCamera() const
{
    return d->animation ? d->animation->to : d->camera;
}

void Interaction::setCamera(const Camera &camera)
{
    turnTo(camera, d->now, 0.0);
}

void Interaction::turnTo(const Camera &camera, double time, double duration)
{
    d->now = std::max(d->now, time);
    d->cancelGesture();
    d->finishAnimation();
    d->animate(camera, time, duration);
    d->hover();
    d->update();
}

void Interaction::handle(const PointerEvent &event)
{
    if (!event.position.allFinite())
        return;
    advance(event.time);
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
        d->wheel(event);
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
    if (hadSelection)
        d->selection.clear();
    d->update();
    return hadGesture || hadSelection || hadNote;
}

bool Interaction::advance(double time)
{
    d->now = std::max(d->now, time);
    if (d->gesture) {
        GestureContext with = d->context();
        d->gesture->advance(d->now, with);
    }
    if (d->animation) {
        d->camera = d->animation->at(d->now);
        if (d->animation->isOver(d->now)) {
            d->animation.reset();
            d->hover();
        }
    }
    d->update();
    return isAnimating();
}

bool Interaction::isAnimating() const
{
    return d->animation.has_value() || (d->gesture && d->gesture->isAnimating());
}

bool Interaction::hasGesture() const
{
    return d->gesture != nullptr || !d->pending.empty();
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
    if (!d->isCameraTouched)
        d->fitFirst();
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
