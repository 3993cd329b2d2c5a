#include "core/interaction/mark_tool.h"

#include "core/base/tolerances.h"
#include "core/geometry/fit.h"
#include "core/geometry/line_clip.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/draw_tool.h"
#include "core/interaction/facing.h"
#include "core/interaction/mark_editing.h"
#include "core/interaction/mark_words.h"
#include "core/interaction/pick.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/section_view.h"
#include "core/interaction/stroke_words.h"
#include "core/model/origin.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace fff {

namespace {

/// What stands where somebody clicked, until other words are typed.
constexpr const char *kFirstWords = "Abc";
/// Height of a capital of new words, mm.
constexpr double kLetterHeight = 10.0;

Hint why(const Hint &hint)
{
    Hint refusal = hint;
    refusal.isRefusal = true;
    return refusal;
}

} // namespace

GestureReply MarkTool::begin(GestureContext &context, double)
{
    const std::vector<SectionRef> &selected = context.selection.sections();
    if (selected.size() != 1 || !context.model.find(selected.front()))
        return {};
    GestureReply reply = take(selected.front(), context);
    if (m_section)
        lookAt(context, reply);
    return reply;
}

GestureReply MarkTool::take(const SectionRef &ref, GestureContext &context)
{
    GestureReply reply;
    if (const std::optional<Hint> refusal = whyNotEdited(context.model, {ref})) {
        reply.note = why(*refusal);
        return reply;
    }
    const Section &section = *context.model.find(ref);
    m_section = ref;
    m_name = section.name;
    m_canvas = section.frame;
    m_solo.begin(ref, context.view);
    reply.select = {{ref}};
    return reply;
}

bool MarkTool::isFromBehind(const GestureContext &context) const
{
    const Section &section = *context.model.find(*m_section);
    const Vec3 middle = section.frame.toWorld(section.shape->bounds().center());
    return section.frame.normal().dot(context.camera.towardsEye(middle, context.viewport)) < 0.0;
}

/// The view turns to look at the section's front, unless it faces that already.
void MarkTool::lookAt(const GestureContext &context, GestureReply &reply)
{
    const Section &section = *context.model.find(*m_section);
    m_before = context.camera;
    if (isFromBehind(context))
        reply.note = Hint(hints::kEngravesFront, {Named{m_name}});
    else if (isSeenFaced(section, context.camera, context.viewport))
        return;
    const Vec3 middle = section.frame.toWorld(section.shape->bounds().center());
    Eigen::Quaterniond facing =
        facingOrientation(context.camera.orientation, section.frame.normal());
    if ((facing * Vec3::UnitZ()).dot(section.frame.normal()) < 0.0)
        facing = Eigen::AngleAxisd(std::numbers::pi, facing * Vec3::UnitY()) * facing;
    const Camera camera = turned(context.camera, facing, middle, context.viewport);
    reply.turnTo = pinned(camera, middle, 0.5 * context.viewport, context.viewport);
}

bool MarkTool::takes(const PointerEvent &press, GestureContext &context) const
{
    if (!m_section)
        return sectionUnder(context.model,
                            context.camera.rayThrough(press.position, context.viewport),
                            context.view)
            .has_value();
    return true;
}

GestureReply MarkTool::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    if (event.isPress() && !m_section) {
        if (const std::optional<SectionRef> ref = sectionUnder(
                context.model, context.camera.rayThrough(event.position, context.viewport),
                context.view))
            reply = take(*ref, context);
        if (!m_section)
            return reply;
        m_isPicking = true;
    }
    const std::optional<Vec2> at =
        pointOnPlane(context.camera, context.viewport, m_canvas, event.position);
    if (event.isPress()) {
        if (!at && !m_isPicking)
            reply.note = Hint::refusal(hints::kCanvasOnEdge);
        if (!at)
            return reply;
        m_press = event.position;
        m_isDrag = false;
        const double scale = context.camera.scaleAt(m_canvas.toWorld(*at), context.viewport);
        m_drawn.emplace(*at, FitOptions{.tolerance = context.settings.fitTolerance * scale});
        return reply;
    }
    // Nobody draws on the side that is not engraved.
    if (m_isPicking && m_press && !isFromBehind(context) &&
        (event.position - *m_press).norm() > context.settings.dragThreshold)
        m_isPicking = false;
    if (m_isPicking) {
        if (event.type == PointerEvent::Type::Release) {
            interrupt(context);
            lookAt(context, reply);
        }
        return reply;
    }
    if (!m_press)
        return reply;
    m_isStraight = event.modifiers.shift;
    m_isDrag = m_isDrag || (event.position - *m_press).norm() > context.settings.dragThreshold;
    if (at && event.type == PointerEvent::Type::Move)
        m_drawn->add(*at);
    if (event.type == PointerEvent::Type::Release)
        return release(context);
    if (m_isDrag)
        if (const MarkPointer mark = drawn(context, false))
            if (SectionEdit edit = markAdded(context.model, *m_section, mark))
                reply.preview = std::move(edit->document);
    return reply;
}

MarkTool::Drawn::Drawn(const Vec2 &from, const FitOptions &fit)
    : options(fit), hand(fit.tolerance), line(Stroke::kThinning * fit.tolerance), settled(fit),
      start(from), end(from)
{
    line.add(hand.follow(from));
}

void MarkTool::Drawn::add(const Vec2 &p)
{
    end = p;
    if (line.add(hand.follow(p)))
        settled.follow(line.points());
}

/// Null while it is no line yet. Smooth once it is whole: till then all of it would be fitted anew
/// with every move.
MarkPointer MarkTool::drawn(const GestureContext &context, bool isWhole) const
{
    const double scale = context.camera.scaleAt(m_canvas.toWorld(m_drawn->start), context.viewport);
    Mark mark;
    mark.kind = context.settings.scores ? Mark::Kind::Scored : Mark::Kind::Engraved;
    Result<CurvePath> path = tl::unexpected(Error{});
    if (m_isStraight) {
        const SnapTargets none(m_canvas, context.camera.orientation);
        const Vec2 end = held(m_drawn->end, m_drawn->start, none, scale, false).point;
        if ((end - m_drawn->start).norm() > scale)
            path = CurvePath::fromLine({m_drawn->start, end});
    } else if (!isWhole) {
        path = CurvePath::fromLine(m_drawn->line.points());
    } else {
        std::vector<Vec2> points;
        for (const CubicBezier &curve :
             fitAround(m_drawn->line.points(), m_drawn->settled.pieces(), m_drawn->options)) {
            if (points.empty())
                points.push_back(curve.p0);
            points.insert(points.end(), {curve.p1, curve.p2, curve.p3});
        }
        if (!points.empty())
            path = CurvePath::fromPoints(std::move(points));
    }
    if (!path)
        return nullptr;
    mark.paths.push_back(*std::move(path));
    return std::make_shared<const Mark>(std::move(mark));
}

GestureReply MarkTool::release(GestureContext &context)
{
    GestureReply reply;
    m_press.reset();
    SectionEdit edit = tl::unexpected(Hint::refusal(hints::kTooShort));
    if (!m_isDrag) {
        Lettering lettering;
        lettering.text = kFirstWords;
        lettering.height = kLetterHeight;
        lettering.at = m_drawn->start;
        lettering.turn = uprightTurn(m_canvas);
        edit = letteringAdded(context.model, *m_section, lettering,
                              context.settings.scores ? Mark::Kind::Scored : Mark::Kind::Engraved);
    } else if (const MarkPointer mark = drawn(context, true)) {
        edit = markAdded(context.model, *m_section, mark);
    }
    m_drawn.reset();
    if (!edit)
        reply.note = edit.error();
    else if (const Section *now =
                 edit->document.find(originOf(context.model, *m_section)->section->id);
             !now || !isOnSection(*now->marks.back(), context))
        reply.note = Hint::refusal(hints::kMarkOutside, {Named{m_name}});
    else
        reply.commit = {std::move(edit->step), std::move(edit->document)};
    return reply;
}

/// Some of it is.
bool MarkTool::isOnSection(const Mark &mark, const GestureContext &context) const
{
    const Section *section = context.model.find(*m_section);
    return section &&
           std::any_of(mark.paths.begin(), mark.paths.end(), [section](const CurvePath &path) {
               const auto pieces = clippedLine(path.flatten(kDrawChord), section->shape->region());
               return !pieces || !pieces->empty(); // what cannot be told is not thrown away
           });
}

void MarkTool::mark(GestureContext &context, bool)
{
    if (m_section)
        context.overlay.held.add(sign::Rulers{ownGrid(m_canvas, context.camera.orientation)});
}

GestureReply MarkTool::interrupt(GestureContext &)
{
    m_press.reset();
    m_drawn.reset();
    m_isPicking = false;
    return {};
}

GestureReply MarkTool::cancel(GestureContext &context)
{
    if (m_press)
        return interrupt(context);
    m_solo.end(context.view);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.returnTo = m_before;
    return reply;
}

GestureReply MarkTool::modelChanged(GestureContext &context)
{
    GestureReply reply = interrupt(context);
    if (!m_section)
        return reply;
    if (const Section *section = context.model.find(*m_section)) {
        m_canvas = section->frame;
        m_name = section->name;
        return reply;
    }
    m_solo.end(context.view);
    reply.state = GestureReply::State::Over;
    reply.note = Hint::refusal(hints::kCanvasGone);
    return reply;
}

std::vector<std::string_view> MarkTool::commands() const
{
    return {"mark.engrave", "mark.score"};
}

Hint MarkTool::hint() const
{
    if (!m_section)
        return hints::kPickMarked;
    if (m_press && m_isDrag)
        return hints::kDrawingMark;
    return {hints::kDrawMark, {Named{m_name}}};
}

} // namespace fff
