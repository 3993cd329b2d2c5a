#include "core/interaction/stroke_gesture.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/offer_words.h"
#include "core/interaction/pick.h"
#include "core/interaction/slit_walls.h"
#include "core/interaction/snapping.h"
#include "core/interaction/stroke_words.h"
#include "core/model/ground.h"
#include "core/stroke/twitch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fff {

namespace {

/// Of 15° and 45°, the cosine and the sine: a view that is turned from an axis by less is along it,
/// one that looks down by more looks down.
constexpr double kAlongAxis = 0.9659258262890683, kSteep = 0.7071067811865476;

/// What showing a contour costs besides its fit, in samples that are looked at.
constexpr std::size_t kLeastPrice = 2000;
/// So many radii of the dead zone a hand may stray that waits for the turn.
constexpr double kSlip = 1.5;
/// Largest part of the viewport's width that the view moves in a turn's time to make room.
constexpr double kRoomPerTurn = 0.5;

/// The canvas will lie at the target's depth (see CanvasTurn), so pixels count there.
Stroke::Options strokeOptions(const GestureContext &context, std::optional<MirrorAxis> axis,
                              bool mirrors)
{
    const double scale = context.camera.millimetresPerPixel;
    Stroke::Options options;
    options.turnTime = context.settings.turnTime;
    options.deadZoneRadius = context.settings.deadZoneFraction * context.viewport.x() * scale;
    options.contour.tolerance = context.settings.fitTolerance * scale;
    options.contour.axis = std::move(axis);
    options.contour.isSymmetryOn = mirrors;
    return options;
}

/// The direction on a canvas that is most upwards; on a level one, upwards as it is seen.
Vec2 upOn(const Frame &canvas, const Camera &camera)
{
    if (const std::optional<Halfplane> above = groundLine(canvas))
        return above->inward;
    return canvas.directionToLocal(camera.up()).normalized();
}

Hint refusalOf(const StrokeContour &contour)
{
    switch (contour.refusal) {
    case StrokeContour::Refusal::NoArea:
        return Hint::refusal(hints::kNoArea);
    case StrokeContour::Refusal::CrossesWithoutLoop:
        return Hint::refusal(hints::kCrossesWithoutLoop);
    case StrokeContour::Refusal::Twitch:
        return Hint::refusal(hints::kTwitch, {lengthOf(kTwitch)});
    case StrokeContour::Refusal::None:
    case StrokeContour::Refusal::TooShort:
        break;
    }
    return Hint::refusal(hints::kTooShort);
}

} // namespace

Frame firstCanvas(const Camera &camera)
{
    Vec3 right = camera.right();
    if (std::abs(right.y()) > kSteep) // rolled over
        return {Vec3(0.0, kFirstPlaneHeight, 0.0), camera.right(), camera.up()};
    right.y() = 0.0;
    for (const Vec3 &axis : {Vec3::UnitX().eval(), Vec3::UnitZ().eval()})
        if (const double along = axis.dot(right.normalized()); std::abs(along) > kAlongAxis)
            right = along > 0.0 ? axis : Vec3(-axis);
    right.normalize();
    const double facing = camera.backward().y();
    const Vec3 above(0.0, facing > 0.0 ? 1.0 : -1.0, 0.0);
    return {Vec3(0.0, kFirstPlaneHeight, 0.0), right,
            std::abs(facing) < kSteep ? Vec3(Vec3::UnitY()) : Vec3(above.cross(right))};
}

StrokeGesture::StrokeGesture(const PointerEvent &press, ContourTarget target,
                             const GestureContext &context)
    : m_stroke({}), m_target(std::move(target)), m_before(context.camera), m_cursor(press.position),
      m_now(press.time), m_credit(kFirstCredit)
{
    const Vec2 start = pointAt(press.position, context)
                           .value_or(Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
    std::optional<MirrorAxis> axis = slitAxis(m_target, context.model.document);
    m_isAxisSlit = axis.has_value();
    m_mirrors = axis ? context.settings.mirrors : context.settings.mirrorsFirst;
    if (!axis && m_target.purpose == ContourTarget::Purpose::NewSection)
        axis = MirrorAxis{start, upOn(m_target.canvas, context.camera)};
    m_stroke = Stroke(strokeOptions(context, axis, m_mirrors != press.modifiers.shift));
    followTemplates(context);
    m_stroke.beginOnCanvas({press.time, start});
}

StrokeGesture::StrokeGesture(const PointerEvent &press, const Hit &hit,
                             const GestureContext &context)
    : m_stroke(strokeOptions(context, MirrorAxis(), context.settings.mirrors)),
      m_mirrors(context.settings.mirrors), m_before(context.camera), m_cursor(press.position),
      m_now(press.time), m_credit(kFirstCredit)
{
    const auto index = static_cast<std::size_t>(hit.section);
    m_ground = Ground{context.model.ref(index), context.model.section(index)};
    m_stroke.beginInSection(m_ground->section->shape, {press.time, hit.local});
    m_guides.emplace(context.model, m_ground->section, hit.local, context.camera.orientation);
}

std::optional<Vec2> StrokeGesture::pointAt(const Vec2 &screen, const GestureContext &context) const
{
    return pointOnPlane(view(context), context.viewport, plane(), screen);
}

Camera StrokeGesture::view(const GestureContext &context) const
{
    return m_quick ? m_quick->ended(context.viewport) : context.camera;
}

const Frame &StrokeGesture::plane() const
{
    return m_stroke.state() == Stroke::State::Slit ? m_ground->section->frame : m_target.canvas;
}

GestureReply StrokeGesture::handle(const PointerEvent &event, GestureContext &context)
{
    // A turn that ended before this event ended with the cursor where it was then.
    advance(event.time, context);
    m_cursor = event.position;
    m_stroke.setSymmetryOn(m_mirrors != event.modifiers.shift);
    m_stroke.setFree(event.modifiers.control);
    if (event.type != PointerEvent::Type::Modifiers) {
        if (m_stroke.state() == Stroke::State::Turn)
            followHand(event, context);
        else
            moveTo(event, context);
        advance(event.time, context);
    }
    if (m_stroke.state() == Stroke::State::Slit) {
        leadSlit(event, context);
        lookAtWalls(context);
        lookAtTemplates(context);
    }
    if (event.type == PointerEvent::Type::Release)
        m_stroke.release();
    else if (m_stroke.state() == Stroke::State::Contour && !isToShow(event)) {
        // A sample; what they make together is shown by the last move of a burst, or later.
        m_isBehind = m_isBehind || m_stroke.revision() != m_drawnRevision ||
                     event.type == PointerEvent::Type::Modifiers;
        followSamples(context);
        return running();
    }
    return reply(context);
}

void StrokeGesture::moveTo(const PointerEvent &event, GestureContext &context)
{
    const bool wasInSection = m_stroke.state() == Stroke::State::Slit;
    if (const std::optional<Vec2> at = pointAt(event.position, context))
        m_stroke.move({event.time, *at});
    if (!wasInSection || m_stroke.state() != Stroke::State::Turn)
        return;
    leadSlit(event, context);
    beginTurn(event, context);
}

/// Ctrl leaves it free.
void StrokeGesture::leadSlit(const PointerEvent &event, const GestureContext &context)
{
    m_guide = m_guides->lead(m_stroke, context.settings.snaps && !event.modifiers.control);
}

void StrokeGesture::lookAtWalls(const GestureContext &context)
{
    m_missing = judgedSlit(context.model.document, *m_ground->section, m_stroke.interior(),
                           m_stroke.slitFrom(), m_stroke.slitTo())
                    .missing;
}

/// A move shows what it is paid for, a frame what it has time for.
bool StrokeGesture::isToShow(const PointerEvent &event)
{
    if (event.type == PointerEvent::Type::Move) {
        m_sampled = event.time;
        return !event.isFollowed && canShow();
    }
    return !isDear() || event.time >= m_sampled + kRest;
}

/// Pays for what there is to show.
bool StrokeGesture::canShow()
{
    m_credit = std::min(m_credit + kCreditOfMove, kFirstCredit);
    if (m_stroke.revision() == m_drawnRevision)
        return true;
    if (m_price > m_credit || isDear())
        return false;
    m_credit -= std::min(m_stroke.contour().work + kLeastPrice, m_credit);
    return true;
}

void StrokeGesture::advance(double time, GestureContext &context)
{
    if (m_stroke.state() == Stroke::State::Turn)
        turnView(time, context);
    if (m_quick) {
        context.camera = m_quick->at(time, context.viewport);
        m_now = std::min(time, m_quick->end());
        if (time >= m_quick->end())
            m_quick.reset();
        else if (m_stroke.state() == Stroke::State::DeadZone)
            updateOverlay(context);
    }
    if (m_stroke.state() == Stroke::State::DeadZone && !m_quick)
        makeRoom(time, context);
    m_now = std::max(m_now, time);
}

void StrokeGesture::turnView(double time, GestureContext &context)
{
    const double end = m_stroke.turnEnd();
    if (time >= end && m_hand->isUnderWay(end)) {
        goOn(end, context);
        return;
    }
    m_stroke.advance(time);
    context.camera = m_turn->at(m_stroke.turnProgress(time), m_cursor, context.viewport);
    m_now = std::min(time, end);
    updateOverlay(context);
}

bool StrokeGesture::isAnimating() const
{
    return m_stroke.state() == Stroke::State::Turn || m_quick || m_isMovingToRoom || m_isBehind;
}

void StrokeGesture::beginTurn(const PointerEvent &event, GestureContext &context)
{
    m_turn.emplace(context.camera, m_ground->section->frame, m_stroke.slitFrom(), m_stroke.slitTo(),
                   context.settings.turnAngle, context.viewport);
    m_target = ContourTarget::newSection(
        m_turn->canvas(), Parent{m_ground->ref, m_stroke.slitFrom(), m_stroke.slitTo()});
    m_target.right = m_turn->right();
    m_stroke.reachSlit(context.model.document.stockOf(*m_ground->section).thickness);
    followTemplates(context);
    lookAtWalls(context);
    if (m_missing) {
        const Document &document = context.model.document;
        if (std::optional<Parent> slit = movedIn(document, *m_ground->section, m_stroke.interior(),
                                                 *m_target.parent, *m_missing)) {
            m_movedIn = m_target;
            m_movedIn->canvas.origin = m_ground->section->frame.toWorld(slit->slitFrom);
            m_movedIn->parent = std::move(slit);
        }
    }
    const double turnTime = context.settings.turnTime;
    m_room = RoomPan{m_target.canvas, m_stroke.slitLength(), m_stroke.deadZoneRadius(),
                     turnTime > 0.0 ? kRoomPerTurn * context.viewport.x() / turnTime
                                    : std::numeric_limits<double>::infinity()};
    m_hand.emplace(HandInTurn::Sample{event.time, event.position},
                   kSlip * context.settings.deadZoneFraction * context.viewport.x());
    if (m_turn->isTurning())
        return;
    context.camera = m_turn->view();
    m_stroke.endTurn();
    moveTo(event, context);
}

/// The hand in the turn: seen from its end, it may have begun to draw.
void StrokeGesture::followHand(const PointerEvent &event, GestureContext &context)
{
    m_hand->follow({event.time, event.position});
    if (m_hand->isDrawing())
        goOn(event.time, context);
}

/// It did not wait: what it drew since it left the section counts.
void StrokeGesture::goOn(double time, GestureContext &context)
{
    const std::vector<HandInTurn::Sample> &way = m_hand->way();
    m_quick = QuickTurn{
        *m_turn, m_stroke.turnProgress(time),           way.back().place, way.front().place,
        time,    kQuickTurn * context.settings.turnTime};
    m_stroke.endTurn();
    for (const HandInTurn::Sample &sample : way)
        if (const std::optional<Vec2> at = pointAt(sample.place, context))
            m_stroke.move({sample.time, *at});
}

/// While the cursor rests in the dead zone, or moves in it, the slit comes away from the edge.
void StrokeGesture::makeRoom(double time, GestureContext &context)
{
    context.camera = m_room->after(time - m_now, context.camera, m_cursor, context.viewport);
    // Whether the next frame would move it: this one may have come in the same millisecond.
    constexpr double kNextFrame = 1.0; // ms
    const Camera next = m_room->after(kNextFrame, context.camera, m_cursor, context.viewport);
    m_isMovingToRoom = (next.target - context.camera.target).norm() > kClipGrid;
    if (const std::optional<Vec2> at = pointAt(m_cursor, context))
        m_stroke.viewMoved(*at);
    updateOverlay(context);
}

GestureReply StrokeGesture::reply(GestureContext &context)
{
    m_isBehind = false;
    if (m_stroke.state() != Stroke::State::DeadZone)
        m_isMovingToRoom = false;
    switch (m_stroke.state()) {
    case Stroke::State::Contour:
        updateDrawn(context);
        break;
    case Stroke::State::Done:
        updateDrawn(context);
        keepMovedIn(context);
        updateOffer(context);
        return done(context);
    case Stroke::State::Cancelled:
        return over();
    default:
        break;
    }
    updateOverlay(context);
    return running();
}

GestureReply StrokeGesture::running() const
{
    GestureReply reply;
    if (m_drawn && *m_drawn)
        reply.preview = (*m_drawn)->document;
    return reply;
}

/// Each time from the committed document; kept while no sample is added, so that the release
/// commits the very section that was shown.
void StrokeGesture::updateDrawn(const GestureContext &context)
{
    const StrokeContour &contour = m_stroke.contour();
    if (m_stroke.revision() == m_drawnRevision && contour.isMirrored == m_drawnMirrored &&
        m_isMovedIn == m_drawnMovedIn && contour.beside.has_value() == m_drawnBeside)
        return;
    m_drawnRevision = m_stroke.revision();
    m_drawnMirrored = contour.isMirrored;
    m_drawnMovedIn = m_isMovedIn;
    m_drawnBeside = contour.beside.has_value();
    m_price = contour.work + kLeastPrice;
    m_drawn.reset();
    if (contour.contour)
        m_drawn = drawContour(context.model.document, target(), *contour.contour, rulesOf(context));
}

DrawingRules StrokeGesture::rulesOf(const GestureContext &context) const
{
    const StrokeContour &contour = m_stroke.contour();
    return {context.settings.cutsAtGround, context.settings.naming,
            contour.isMirrored ? contour.axis : std::nullopt};
}

/// Of what is committed, once: what is drawn is no more than that as long as the hand goes on. What
/// crossed itself was no circle.
void StrokeGesture::updateOffer(const GestureContext &context)
{
    if (!m_drawn || !*m_drawn)
        return;
    offerMovedIn(context);
    const StrokeContour &contour = m_stroke.contour();
    if (m_offer || contour.wasCrossing)
        return;
    m_offer = shapeOffer(context.model.document, target(),
                         contour.beside ? *contour.beside : *contour.contour, m_stroke.tolerance(),
                         rulesOf(context), m_stroke.slit());
}

bool StrokeGesture::hasOffer() const
{
    return m_movedIn.has_value();
}

/// Only if that does no harm, which is not known before it is drawn.
void StrokeGesture::keepMovedIn(const GestureContext &context)
{
    if (!m_isMovedIn || !m_drawn || !*m_drawn)
        return;
    const DrawnContour &moved = **m_drawn;
    const tl::expected<DrawnContour, Hint> drawn = drawContour(
        context.model.document, m_target, *m_stroke.contour().contour, rulesOf(context));
    if (!drawn || isWellMovedIn(drawn->document, moved.document, moved.section.drawn,
                                *m_ground->section, m_stroke.slitLength()))
        return;
    m_isMovedIn = false;
    m_wasPutBack = true;
    updateDrawn(context);
}

/// As it was said while it was drawn, where it is held when it is moved in.
void StrokeGesture::offerMovedIn(const GestureContext &context)
{
    if (!m_movedIn || m_isMovedIn || m_wasPutBack)
        return;
    const StrokeContour &contour = m_stroke.contour();
    const Document &before = context.model.document;
    tl::expected<DrawnContour, Hint> moved =
        drawContour(before, *m_movedIn, *contour.contour, rulesOf(context));
    if (!moved)
        return;
    if (!isWellMovedIn((*m_drawn)->document, moved->document, moved->section.drawn,
                       *m_ground->section, m_stroke.slitLength()))
        return;
    m_offer = ShapeOffer();
    m_offer->step = {steps::kMoveIn, {Named{moved->name}}};
    m_offer->signs = offerSigns(hints::kOfferMoveIn, *moved);
    m_offer->done = Hint::undoable(hints::kWasMovedIn);
    m_offer->document = std::move(moved->document);
}

GestureReply StrokeGesture::done(const GestureContext &context)
{
    if (!m_drawn || !*m_drawn) {
        GestureReply failed = over();
        failed.note = m_drawn ? m_drawn->error() : Hint::refusal(hints::kFailed);
        return failed;
    }
    DrawnContour &drawn = **m_drawn;
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    const StrokeContour &contour = m_stroke.contour();
    // What is lost of the stroke comes before what became of the rest.
    reply.note = std::move(drawn.note);
    if (contour.wasCrossing)
        reply.note = Hint::undoable(hints::kCrossesItself);
    if (contour.isApart)
        reply.note = Hint(hints::kNotJoined, {Named{drawn.name}, Named{m_ground->section->name}});
    else if (contour.beside && drawn.isCutAtGround)
        reply.note = Hint(hints::kHasNeckAndIsCut, {Named{drawn.name}});
    const auto tell = [&](bool applies, Text text) {
        if (applies && !reply.note)
            reply.note = Hint(text, {Named{drawn.name}});
    };
    if (m_wasPutBack)
        reply.note = Hint(hints::kNotMovedIn, {Named{drawn.name}, Named{m_ground->section->name}});
    tell(contour.wasCutAtAxis, hints::kCutAtAxis);
    tell(!contour.doHalvesMeet, hints::kHalvesDoNotMeet);
    tell(contour.beside.has_value(), hints::kHasNeck);
    reply.commit = {std::move(drawn.step), std::move(drawn.document)};
    reply.offer = std::move(m_offer);
    if (m_quick)
        reply.settling = {m_quick->ended(context.viewport), m_quick->end() - m_now};
    return reply;
}

/// Came to nothing: the view goes back to where it was.
GestureReply StrokeGesture::over() const
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    if (m_turn)
        reply.returnTo = m_before;
    switch (m_stroke.refusal()) {
    case Stroke::Refusal::NeverLeft:
        reply.note = Hint::refusal(hints::kNeverLeft, {Named{m_ground->section->name}});
        break;
    case Stroke::Refusal::TooShort:
        reply.note = m_stroke.samples().empty() ? Hint::refusal(hints::kTooShort)
                                                : refusalOf(m_stroke.contour());
        break;
    case Stroke::Refusal::None:
        break;
    }
    return reply;
}

GestureReply StrokeGesture::cancel(GestureContext &)
{
    m_stroke.cancel();
    return over();
}

} // namespace fff
