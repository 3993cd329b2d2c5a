#include "core/interaction/figure_tool.h"

#include "core/base/tolerances.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/draw_tool.h"
#include "core/interaction/figure_editing.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/stroke_gesture.h"
#include "core/model/origin.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

const FigureKind &kindOf(const GestureContext &context)
{
    const FigureKind *kind = figureKind(context.settings.figure);
    return kind ? *kind : figureKinds().front();
}

/// Of the drawn sections whose slab the canvas runs along, the one with material at this place: a
/// second section in there could only be in its way.
const Section *sectionIn(const Frame &canvas, const Vec3 &place, const GestureContext &context)
{
    for (const SectionPointer &section : context.model.document.sections) {
        const Frame &frame = section->frame;
        const double half = 0.5 * context.model.document.stockOf(*section).thickness;
        if (frame.normal().cross(canvas.normal()).norm() < kPracticallyParallel &&
            std::abs(frame.height(place)) < half && context.view.isPicked(section->ref()) &&
            locate(frame.toLocal(place), section->shape->region()) == Side::Inside)
            return section.get();
    }
    return nullptr;
}

} // namespace

GestureReply FigureTool::begin(GestureContext &context, double)
{
    m_kind = kindOf(context).key;
    const std::vector<SectionRef> &selected = context.selection.sections();
    const auto origin =
        selected.size() == 1 ? originOf(context.model, selected.front()) : std::nullopt;
    GestureReply reply;
    if (origin && !whyNotEdited(context.model, {selected.front()})) {
        const Section &section = *origin->section;
        m_before = context.camera;
        m_solo.begin(selected.front(), context.view);
        CanvasChoice canvas{ContourTarget::hole(section), std::string(kCommand), {}, section.name};
        reply.turnTo = cameraAtCanvas(canvas.target, context);
        setCanvas(std::move(canvas), context);
        m_isPicked = true;
        return reply;
    }
    faceFirstCanvas(context);
    return reply;
}

void FigureTool::setCanvas(CanvasChoice canvas, const GestureContext &context)
{
    const Frame &frame = canvas.target.canvas;
    const Eigen::Quaterniond &view = context.camera.orientation;
    const bool isFirst = context.model.sectionCount() == 0;
    m_targets.emplace(frame, isFirst ? canvasGrid(frame, view) : ownGrid(frame, view));
    m_targets->addModel(context.model, context.view, {});
    m_guides = TemplateGuides(context.model, context.pulled.get(), frame);
    // As near as points: a stroke is meant to follow a guide, a shape only to lie at one.
    m_targets->setGuides(m_guides.loops(), context.settings.guideReach, kSnapReach);
    m_targets->addGuideCrossings(context.model, context.view,
                                 canvas.target.section.isValid() ? SectionRef(canvas.target.section)
                                                                 : SectionRef());
    m_canvas = std::move(canvas);
    m_target = m_canvas.target;
    m_middle.reset();
}

/// Upright before the view, until another one is picked.
void FigureTool::faceFirstCanvas(const GestureContext &context)
{
    if (m_isPicked || m_press)
        return;
    Frame frame = firstCanvas(context.camera);
    if (context.model.sectionCount() > 0)
        frame = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
    if (!m_targets || !(m_canvas.target.canvas == frame))
        setCanvas({ContourTarget::newSection(frame), std::string(kCommand)}, context);
}

std::optional<GestureReply> FigureTool::useCanvas(CanvasChoice canvas, GestureContext &context)
{
    GestureReply reply;
    m_press.reset();
    m_solo.end(context.view);
    if (!m_before)
        m_before = context.camera;
    reply.turnTo = cameraAtCanvas(canvas.target, context);
    setCanvas(std::move(canvas), context);
    m_isPicked = true;
    return reply;
}

bool FigureTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return pointOnPlane(context.camera, context.viewport, m_canvas.target.canvas, press.position)
        .has_value();
}

/// Onto a section that is in the canvas a shape is a hole, as if the section had been picked.
ContourTarget FigureTool::targetAt(const Vec3 &middle, const GestureContext &context) const
{
    const ContourTarget &target = m_canvas.target;
    const Section *below = target.purpose == ContourTarget::Purpose::NewSection
                               ? sectionIn(target.canvas, middle, context)
                               : nullptr;
    return below ? ContourTarget::hole(*below) : target;
}

Figure FigureTool::figureTo(const Vec2 &corner, bool isEven, const GestureContext &context) const
{
    const Vec2 way = m_targets->toGrid(corner) - m_targets->toGrid(m_middle->point);
    Vec2 size = 2.0 * way.cwiseAbs();
    if (isEven)
        size.setConstant(size.maxCoeff());
    Figure figure = newFigure(kindOf(context));
    if (m_isDrag && size.minCoeff() > 0.0)
        figure = sized(figure, size);
    figure.centre = m_target.canvas.toLocal(m_canvas.target.canvas.toWorld(m_middle->point));
    const Vec2 right = m_target.canvas.directionToLocal(m_targets->grid().x);
    figure.turn = std::atan2(right.y(), right.x());
    return figure;
}

GestureReply FigureTool::made(const Figure &figure, bool isOver, GestureContext &context)
{
    GestureReply reply;
    tl::expected<DrawnContour, Hint> drawn =
        drawFigure(context.model.document, m_target, figure,
                   {context.settings.cutsAtGround, context.settings.naming});
    m_figure = isOver ? std::optional<Figure>() : figure;
    m_isPossible = drawn.has_value();
    if (!drawn) {
        if (isOver)
            reply.note = drawn.error();
        return reply;
    }
    if (!isOver) {
        reply.preview = std::move(drawn->document);
        return reply;
    }
    reply.note = std::move(drawn->note);
    reply.select = {{drawn->section}};
    reply.commit = {std::move(drawn->step), std::move(drawn->document)};
    return reply;
}

GestureReply FigureTool::handle(const PointerEvent &event, GestureContext &context)
{
    m_kind = kindOf(context).key;
    faceFirstCanvas(context);
    const std::optional<Vec2> at =
        pointOnPlane(context.camera, context.viewport, m_canvas.target.canvas, event.position);
    if (!at)
        return {};
    const double scale =
        context.camera.scaleAt(m_canvas.target.canvas.toWorld(*at), context.viewport);
    const bool snaps = context.settings.snaps && !event.modifiers.control;
    const auto snap = [&](const Snap &before) {
        return snaps ? snapped(*at, *m_targets, scale, before)
                     : Snap{Snap::Kind::None, *at, {}, false};
    };
    if (!m_press) {
        m_middle = snap(m_middle.value_or(Snap()));
        if (event.isPress()) {
            m_press = event.position;
            m_isDrag = false;
            m_target = targetAt(m_canvas.target.canvas.toWorld(m_middle->point), context);
        }
        return {};
    }
    m_isDrag = m_isDrag || (event.position - *m_press).norm() > context.settings.dragThreshold;
    const Figure figure = figureTo(snap(Snap()).point, event.modifiers.shift, context);
    if (event.type != PointerEvent::Type::Release)
        return m_isDrag ? made(figure, false, context) : GestureReply();
    m_press.reset();
    return made(figure, true, context);
}

void FigureTool::mark(GestureContext &context, bool hasCursor)
{
    m_kind = kindOf(context).key;
    if (!m_targets)
        return;
    Signs &signs = context.overlay.held;
    signs.add(sign::Rulers{m_targets->grid()});
    m_guides.show(nullptr, false, signs);
    if (m_middle && (hasCursor || m_press))
        signs.add(sign::Handle{SignRole::Place, m_canvas.target.canvas.toWorld(m_middle->point)});
    if (m_figure)
        if (const Result<Contour> contour = contourOf(*m_figure))
            signs.add(sign::Curve{m_isPossible ? SignRole::Figure : SignRole::Refused,
                                  m_target.canvas, *contour});
}

GestureReply FigureTool::interrupt(GestureContext &)
{
    m_press.reset();
    m_figure.reset();
    return {};
}

GestureReply FigureTool::cancel(GestureContext &context)
{
    if (m_press)
        return interrupt(context);
    m_solo.end(context.view);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.returnTo = m_before;
    return reply;
}

GestureReply FigureTool::modelChanged(GestureContext &context)
{
    GestureReply reply = interrupt(context);
    const ContourTarget &target = m_canvas.target;
    if (!target.section.isValid()) {
        if (m_targets)
            setCanvas(m_canvas, context);
        return reply;
    }
    if (const Section *section = context.model.document.find(target.section)) {
        setCanvas({ContourTarget::hole(*section), std::string(kCommand), {}, section->name},
                  context);
        return reply;
    }
    m_solo.end(context.view);
    reply.state = GestureReply::State::Over;
    reply.note = Hint::refusal(hints::kCanvasGone);
    return reply;
}

std::vector<std::string_view> FigureTool::commands() const
{
    return {"section.addCircle",  "section.addEllipse", "section.addRectangle",
            "section.addPolygon", "section.addStar",    "section.addSlot"};
}

Hint FigureTool::hint() const
{
    if (m_press)
        return hints::kSizeFigure;
    const FigureKind *kind = figureKind(m_kind);
    const Text figure{"Figure", kind ? kind->name : ""};
    if (m_canvas.target.section.isValid())
        return {hints::kPlaceHole, {figure, Named{m_canvas.name}}};
    return {hints::kPlaceFigure, {figure}};
}

} // namespace fff
