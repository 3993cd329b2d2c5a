#include "core/interaction/pen_tool.h"

#include "core/base/tolerances.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/draw_tool.h"
#include "core/interaction/pen_words.h"
#include "core/interaction/sight.h"
#include "core/interaction/stroke_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

/// Two presses within this time at the same place are a double click, ms.
constexpr double kDoubleClickTime = 400.0;

bool isSamePlace(const Vec2 &a, const Vec2 &b)
{
    return (a - b).norm() <= kClipGrid;
}

/// A section that can be drawn out of; none where there is only air, or an edge.
std::optional<Hit> groundAt(const Vec2 &position, const GestureContext &context)
{
    const Sight sight{context.model, context.camera, context.viewport, context.view, {}};
    const std::vector<Hit> hits = sight.hitsAt(position);
    if (hits.empty() || sight.isOnEdge(hits.front()))
        return {};
    return hits.front();
}

} // namespace

// Canvases.

GestureReply PenTool::begin(GestureContext &context, double)
{
    faceFirstCanvas(context);
    return {};
}

std::optional<GestureReply> PenTool::useCanvas(CanvasChoice canvas, GestureContext &context)
{
    if (!m_path.isEmpty()) {
        GestureReply reply = shown();
        reply.note = Hint::refusal(hints::kPathIsOpen);
        return reply;
    }
    m_slit.reset();
    if (!m_viewBefore)
        m_viewBefore = context.camera;
    GestureReply reply;
    reply.turnTo = cameraAtCanvas(canvas.target, context);
    Camera there = reply.turnTo.value_or(context.camera);
    setCanvas(std::move(canvas), false,
              {context.model, context.pulled, context.settings, context.viewport, there,
               context.overlay, context.hovered, context.view, context.selection, context.points});
    return reply;
}

void PenTool::setCanvas(CanvasChoice choice, bool isFirst, const GestureContext &context)
{
    const Frame &frame = choice.target.canvas;
    const Eigen::Quaterniond &view = context.camera.orientation;
    SnapTargets targets(frame, isFirst ? canvasGrid(frame, view) : ownGrid(frame, view));
    const SectionRef own =
        choice.target.section.isValid() ? SectionRef(choice.target.section) : SectionRef();
    // A hole is drawn to the contour around it; a contour that is redrawn goes away.
    const bool isRedraw = choice.target.purpose == ContourTarget::Purpose::Redraw;
    targets.addModel(context.model, context.view, isRedraw ? own : SectionRef());
    if (const auto &parent = choice.target.parent) {
        targets.addPoint(Vec2::Zero());
        targets.addPoint({(parent->slitTo - parent->slitFrom).norm(), 0.0});
    }
    TemplateGuides guides(context.model, context.pulled.get(), frame);
    targets.setGuides(guides.loops(), context.settings.guideReach);
    targets.addGuideCrossings(context.model, context.view, own);
    m_canvas = Canvas{std::move(choice), std::move(targets), std::move(guides), isFirst, false};
    m_snap.reset();
    m_typed.reset();
}

/// Without a section there is a canvas at once, which faces the view until a point is on it.
void PenTool::faceFirstCanvas(const GestureContext &context)
{
    if (!m_path.isEmpty() || m_slit || context.model.sectionCount() > 0 ||
        (m_canvas && !m_canvas->isFirst))
        return;
    const Frame frame = firstCanvas(context.camera);
    if (!m_canvas || !(m_canvas->choice.target.canvas == frame))
        setCanvas({ContourTarget::newSection(frame), std::string(kCommand)}, true, context);
}

GestureReply PenTool::interrupt(GestureContext &)
{
    m_press.reset();
    if (m_slit && m_slit->state() == SlitTurn::State::Slit)
        m_slit.reset();
    return shown();
}

GestureReply PenTool::modelChanged(GestureContext &context)
{
    GestureReply reply;
    m_press.reset();
    if (m_slit) {
        reply.returnTo = m_slit->before();
        m_slit.reset();
        return reply;
    }
    if (!m_canvas)
        return reply;
    if (m_canvas->isFirst && context.model.sectionCount() > 0 && m_path.isEmpty()) {
        m_canvas.reset();
        return reply;
    }
    const ContourTarget &target = m_canvas->choice.target;
    bool isThere = true;
    if (target.section.isValid()) {
        const Section *section = context.model.document.find(target.section);
        isThere = section && section->frame == target.canvas;
    } else if (target.parent) {
        // Where its slit was drawn there may be none by now, or elsewhere.
        const int index = context.model.indexOf(target.parent->section);
        isThere = index >= 0 &&
                  isSamePlace(
                      target.canvas.toLocal(context.model.section(static_cast<std::size_t>(index))
                                                ->frame.toWorld(target.parent->slitFrom)),
                      Vec2::Zero());
    }
    if (!isThere) {
        if (!m_path.isEmpty())
            reply.note = Hint::refusal(hints::kCanvasGone);
        forgetPath();
        m_canvas.reset();
        return reply;
    }
    const std::optional<Vec2> typed = m_typed;
    setCanvas(m_canvas->choice, m_canvas->isFirst, context);
    m_typed = typed;
    pathChanged(context);
    reply.preview = shown().preview;
    return reply;
}

// What the person does.

bool PenTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return m_canvas || m_slit || context.model.sectionCount() == 0 ||
           groundAt(press.position, context).has_value();
}

GestureReply PenTool::handle(const PointerEvent &event, GestureContext &context)
{
    m_event = event;
    if (m_slit)
        return followSlit(event, context);
    faceFirstCanvas(context);
    if (event.isPress())
        return press(event, context);
    if (!m_canvas)
        return {};
    if (m_press && !m_press->isOver) {
        drag(event, context);
        if (event.type == PointerEvent::Type::Release)
            return release(context);
        return shown();
    }
    if (event.type == PointerEvent::Type::Release)
        m_press.reset();
    hover(context);
    return shown();
}

GestureReply PenTool::followSlit(const PointerEvent &event, GestureContext &context)
{
    const bool wasTurned = m_slit->isTurned();
    if (event.isPress()) {
        // Where the view stands by now, if it has turned; in the turn nobody can aim.
        const bool isInTurn = m_slit->state() == SlitTurn::State::Turn;
        finish(context);
        if (!isInTurn)
            return press(event, context);
        m_press = Press{event.position, event.time, {}, false, true};
        return {};
    }
    const double way = (event.position - m_press->position).norm();
    m_press->isDrag = m_press->isDrag || way > context.settings.dragThreshold;
    if (m_press->isDrag || wasTurned)
        m_slit->move(event, context);
    GestureReply reply;
    if (m_slit->isTooShort()) {
        reply.note = Hint::refusal(hints::kTooShort);
        m_slit.reset();
        m_press->isOver = true;
    } else if (m_slit->isTurned()) {
        if (!wasTurned)
            reply.left = m_slit->before();
        advance(event.time, context);
    } else if (event.type == PointerEvent::Type::Release) {
        if (m_press->isDrag)
            reply.note = Hint::refusal(hints::kNeverLeft, {Named{m_slit->sectionName()}});
        else
            reply.isClick = true;
        m_slit.reset();
        m_press.reset();
    }
    return reply;
}

GestureReply PenTool::press(const PointerEvent &event, GestureContext &context)
{
    m_typed.reset();
    if (!m_canvas) {
        const std::optional<Hit> hit = groundAt(event.position, context);
        if (!hit)
            return {};
        context.camera = retargeted(context.camera, hit->point, context.viewport);
        m_press = Press{event.position, event.time, {}, false, false};
        m_slit.emplace(event, *hit, context);
        return {};
    }
    const bool isDouble =
        m_lastPress && m_lastPress->place.kind == Place::Kind::Free && !m_lastPress->isDrag &&
        event.time - m_lastPress->time <= kDoubleClickTime &&
        (event.position - m_lastPress->position).norm() <= context.settings.dragThreshold;
    m_press = Press{event.position, event.time, placeAt(event.position, context), false, false};
    if (isDouble) {
        m_press->isOver = true;
        m_lastPress.reset();
        return isClosable() ? close(context) : shown();
    }
    if (m_press->place.kind != Place::Kind::Free)
        return shown();
    const std::optional<Vec2> under = pointUnder(event.position, context);
    if (!under) {
        m_press->isOver = true;
        return shown();
    }
    m_snap = snapTo(*under, {}, context);
    return addPoint(m_snap->point, context);
}

/// What the press sets, moves or bends.
void PenTool::drag(const PointerEvent &event, GestureContext &context)
{
    if (!m_press->isDrag) {
        if ((event.position - m_press->position).norm() <= context.settings.dragThreshold)
            return;
        m_press->isDrag = true;
        if (m_press->place.kind != Place::Kind::Free)
            m_path.keep();
    }
    const std::optional<Vec2> under = pointUnder(event.position, context);
    if (!under)
        return;
    const Place &place = m_press->place;
    if (place.kind == Place::Kind::Point) {
        m_snap = snapTo(*under, place.index, context);
        m_path.move(place.index, m_snap->point);
    } else {
        const Vec2 &at = m_path.points()[place.index].at;
        const Vec2 tip =
            event.modifiers.shift ? held(*under, at, m_canvas->targets, 1.0, false).point : *under;
        m_path.bend(place.index, place.end, tip, event.modifiers.control);
    }
    pathChanged(context);
}

GestureReply PenTool::release(GestureContext &context)
{
    const bool closes = m_press->place.kind == Place::Kind::Point && m_press->place.index == 0 &&
                        !m_press->isDrag && isClosable();
    m_lastPress = std::exchange(m_press, std::nullopt);
    if (closes)
        return close(context);
    hover(context);
    return shown();
}

GestureReply PenTool::addPoint(const Vec2 &point, GestureContext &context)
{
    if (!m_path.isEmpty() && isSamePlace(point, m_path.points().back().at)) {
        if (m_press)
            m_press->isOver = true;
        return shown();
    }
    const bool closes =
        m_path.size() > 1 && isClosable() && isSamePlace(point, m_path.points().front().at);
    if (closes) {
        if (m_press)
            m_press->isOver = true;
        return close(context);
    }
    m_path.keep();
    m_path.add(point);
    m_canvas->isFirst = false;
    if (m_press)
        m_press->place = {Place::Kind::Free, m_path.size() - 1, PenPath::End::Out};
    pathChanged(context);
    return shown();
}

void PenTool::hover(GestureContext &context)
{
    m_hoverCamera = context.camera;
    m_place = {};
    if (!m_canvas)
        return;
    const std::optional<Vec2> under = pointUnder(m_event.position, context);
    m_canvas->isOnEdge = !under;
    if (!under) {
        m_snap.reset();
        return;
    }
    m_place = placeAt(m_event.position, context);
    if (m_place.kind == Place::Kind::Free)
        m_snap = snapTo(*under, {}, context);
    else
        m_snap.reset();
}

/// To a contour, if it encloses something.
GestureReply PenTool::close(GestureContext &)
{
    GestureReply reply = shown();
    if (!m_drawn || !*m_drawn) {
        reply.note = m_drawn ? m_drawn->error() : Hint::refusal(hints::kNothingToClose);
        return reply;
    }
    DrawnContour drawn = **std::exchange(m_drawn, std::nullopt);
    reply.preview.reset();
    reply.note = std::move(drawn.note);
    if (m_closed.wasCrossing)
        reply.note = Hint::undoable(hints::kCrossesItself);
    reply.commit = {std::move(drawn.step), std::move(drawn.document)};
    forgetPath();
    m_canvas.reset();
    m_viewBefore.reset();
    return reply;
}

GestureReply PenTool::cancel(GestureContext &context)
{
    GestureReply reply;
    if (m_slit) {
        if (m_slit->isTurned())
            reply.returnTo = m_slit->before();
        m_slit.reset();
        m_press.reset();
        return reply;
    }
    if (!m_path.isEmpty()) {
        forgetPath();
        if (m_canvas->choice.command == kCommand && !m_canvas->choice.target.parent)
            m_canvas.reset(); // the first one: it faces the view again
        faceFirstCanvas(context);
        return reply;
    }
    reply.state = GestureReply::State::Over;
    reply.returnTo = m_viewBefore;
    return reply;
}

bool PenTool::wants(ToolKey) const
{
    return m_canvas && (!m_path.isEmpty() || m_typed);
}

GestureReply PenTool::key(ToolKey key, GestureContext &context)
{
    if (key == ToolKey::Enter) {
        if (!m_typed)
            return close(context);
        m_press.reset();
        return addPoint(*std::exchange(m_typed, std::nullopt), context);
    }
    if (!m_path.isEmpty()) {
        m_press.reset();
        m_path.keep();
        m_path.removeLast();
        pathChanged(context);
    }
    return shown();
}

GestureReply PenTool::undo(GestureContext &context)
{
    m_press.reset();
    m_path.undo();
    pathChanged(context);
    return shown();
}

GestureReply PenTool::redo(GestureContext &context)
{
    m_press.reset();
    m_path.redo();
    pathChanged(context);
    return shown();
}

// Time and view.

void PenTool::advance(double time, GestureContext &context)
{
    if (!m_slit)
        return;
    m_slit->advance(time, context);
    if (m_slit->state() == SlitTurn::State::Over)
        takeSlit(context);
}

void PenTool::finish(GestureContext &context)
{
    if (!isAnimating())
        return;
    if (m_slit->state() == SlitTurn::State::Turn)
        m_slit->finish(context);
    takeSlit(context);
}

/// From now on clicks place points on the slit's canvas.
void PenTool::takeSlit(GestureContext &context)
{
    m_viewBefore = m_slit->before();
    const ContourTarget target = m_slit->target();
    m_slit.reset();
    if (m_press)
        m_press->isOver = true;
    setCanvas({target, std::string(kCommand)}, false, context);
    hover(context);
}

bool PenTool::isAnimating() const
{
    return m_slit && m_slit->isTurned();
}

} // namespace fff
