// What a stroke shows while it is drawn: its signs, its words and the cursor.
#include "core/base/tolerances.h"
#include "core/interaction/cue.h"
#include "core/interaction/offer_words.h"
#include "core/interaction/snapping.h"
#include "core/interaction/stroke_gesture.h"
#include "core/interaction/stroke_words.h"
#include "core/model/ground.h"

#include <utility>

namespace fff {

namespace {

std::optional<sign::Ground> groundLineOf(const Frame &canvas)
{
    const std::optional<Halfplane> above = groundLine(canvas);
    if (!above)
        return {};
    return sign::Ground{canvas.toWorld(above->point), canvas.directionToWorld(above->along())};
}

/// Of what is drawn, along the axes of its section, which are those that are seen: width and
/// height.
Vec2 seenSize(const ContourTarget &target, const Section &section, const Contour &contour)
{
    const bool isHole = target.purpose == ContourTarget::Purpose::Hole;
    return (isHole ? bounds(contour.polygon(kDrawChord)) : section.shape->bounds()).size();
}

} // namespace

/// From the ground for what comes first, else as the section will count.
Frame StrokeGesture::rulers(const GestureContext &context) const
{
    const Eigen::Quaterniond orientation = view(context).orientation;
    if (context.model.sectionCount() == 0)
        return canvasGrid(target().canvas, orientation);
    return m_target.section.isValid() ? ownGrid(target().canvas, orientation) : seenFrame(target());
}

/// Says at the slit that it will hold nothing, and how it would.
void StrokeGesture::addWalls(Signs &signs) const
{
    constexpr double kAbove = 86.0; // px, clear of the zone round the slit and of its length
    if (!m_missing)
        return;
    const Frame &frame = m_ground->section->frame;
    if (m_isMovedIn) {
        const double by = (m_movedIn->canvas.origin - m_target.canvas.origin).norm();
        signs.add(sign::Label{SignRole::Cue,
                              {frame.toWorld(m_movedIn->parent->slitTo)},
                              Message{hints::kIsMovedIn, {lengthOf(by)}},
                              {0.0, -kAbove}});
        return;
    }
    signs.add(sign::Label{SignRole::Doubt,
                          {frame.toWorld(m_stroke.slitTo())},
                          Message{m_movedIn ? hints::kOneWallOffer : hints::kOneWall, {}},
                          {0.0, -kAbove}});
}

void StrokeGesture::updateOverlay(GestureContext &context) const
{
    Signs signs;
    const Stroke::State state = m_stroke.state();
    if (m_ground) {
        const Frame &frame = m_ground->section->frame;
        const Parent *moved = m_isMovedIn ? &*m_movedIn->parent : nullptr;
        sign::Slit slit{frame.toWorld(moved ? moved->slitFrom : m_stroke.slitFrom()),
                        frame.toWorld(moved ? moved->slitTo : m_stroke.slitTo()),
                        state != Stroke::State::Slit, m_ground->section->name};
        if (state == Stroke::State::DeadZone) {
            slit.clearance = m_stroke.deadZoneRadius();
            signs.add(sign::Capsule{SignRole::DeadZone, target().canvas, m_stroke.slitLength(),
                                    m_stroke.deadZoneRadius()});
        }
        slit.hasWords = state != Stroke::State::Contour;
        if (m_guide && (state == Stroke::State::Slit || state == Stroke::State::Turn)) {
            slit.guide = nameOf(m_guide->kind);
            m_guides->show(*m_guide, context.camera, context.viewport, signs);
        }
        signs.add(std::move(slit));
        addWalls(signs);
    }
    addTemplates(context, signs);
    if (state == Stroke::State::Contour) {
        const StrokeContour &contour = m_stroke.contour();
        signs.add(sign::Rulers{rulers(context)});
        sign::Stroke &stroke = signs.put(sign::Stroke());
        stroke.canvas = target().canvas;
        stroke.samples = m_stroke.samples();
        stroke.fitted = contour.fitted;
        stroke.opening = contour.opening;
        stroke.closing = contour.closing;
        stroke.mirrored = contour.mirrored;
        stroke.axis = contour.axis;
        stroke.symmetry = contour.symmetry;
        stroke.isMirrored = contour.isMirrored;
        stroke.isAxisSlit = m_isAxisSlit;
        stroke.purpose = m_target.purpose;
        stroke.doHalvesMeet = contour.doHalvesMeet;
        if (const Section *changed = context.model.document.find(m_target.section))
            stroke.section = changed->name;
        if (contour.contour)
            stroke.pieces = contour.contour->segmentCount();
        if (m_drawn && *m_drawn) {
            const Section &drawn = *(*m_drawn)->document.find((*m_drawn)->section.drawn);
            stroke.section = drawn.name;
            stroke.size = seenSize(m_target, drawn, *contour.contour);
            if ((*m_drawn)->isCutAtGround)
                stroke.cut = contour.contour;
        }
    }
    if (state == Stroke::State::Turn || state == Stroke::State::DeadZone)
        signs.add(cueAt(state == Stroke::State::Turn ? hints::kTurningNow : hints::kDrawOutline,
                        m_cursor, context.camera, context.viewport));
    if (state == Stroke::State::Contour && m_stroke.contour().isApart)
        signs.add(cueAt(hints::kNotJoinedYet, m_cursor, context.camera, context.viewport));
    if (state == Stroke::State::Contour || state == Stroke::State::DeadZone)
        if (const std::optional<sign::Ground> line = groundLineOf(target().canvas))
            signs.add(*line);
    context.overlay.drawn = std::move(signs);
}

/// The line of the cursor alone; all but its last samples are there already.
void StrokeGesture::followSamples(GestureContext &context) const
{
    const std::vector<Vec2> &samples = m_stroke.samples();
    sign::Stroke *stroke = context.overlay.drawn.find<sign::Stroke>();
    if (!stroke || stroke->samples.size() > samples.size()) {
        updateOverlay(context);
        return;
    }
    std::vector<Vec2> &shown = stroke->samples;
    if (!shown.empty())
        shown.pop_back();
    shown.insert(shown.end(), samples.begin() + std::ssize(shown), samples.end());
}

Hint StrokeGesture::hint() const
{
    switch (m_stroke.state()) {
    case Stroke::State::Slit:
        return {m_guide ? hints::kLeaveGuided : hints::kLeaveSection,
                {Named{m_ground->section->name}}};
    case Stroke::State::Turn:
        return hints::kTurning;
    case Stroke::State::DeadZone:
        return hints::kLeaveDeadZone;
    default:
        if (!m_followed.empty())
            return {hints::kFollowGuide, {Named{m_followed}}};
        if (!m_drawn || !*m_drawn)
            return hints::kDrawContour;
        return releaseHint((*m_drawn)->name);
    }
}

Hint StrokeGesture::releaseHint(const std::string &section) const
{
    const bool isRedraw = m_target.purpose == ContourTarget::Purpose::Redraw;
    if (m_target.purpose == ContourTarget::Purpose::Hole)
        return {hints::kReleaseToCutHole, {Named{section}}};
    if (!m_drawnMirrored)
        return isRedraw ? Hint(hints::kReleaseToRedraw, {Named{section}})
                        : Hint(hints::kReleaseToMake);
    if (isRedraw)
        return {hints::kReleaseToRedrawMirrored, {Named{section}}};
    if (!m_mirrors) // Shift is held
        return hints::kReleaseToMirrorByShift;
    return m_isAxisSlit ? hints::kReleaseToMirror : hints::kReleaseToMirrorFirst;
}

Cursor StrokeGesture::cursor() const
{
    switch (m_stroke.state()) {
    case Stroke::State::Slit:
        return Cursor::PencilWithSlit;
    case Stroke::State::Turn:
        return Cursor::PencilWithClock;
    default:
        return Cursor::Pencil;
    }
}

} // namespace fff
