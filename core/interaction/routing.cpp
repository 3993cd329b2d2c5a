#include "core/interaction/routing.h"

#include "core/interaction/clip_gesture.h"
#include "core/interaction/joint_gesture.h"
#include "core/interaction/load_gesture.h"
#include "core/interaction/magnet_handle.h"
#include "core/interaction/operation_gesture.h"
#include "core/interaction/point_gesture.h"
#include "core/interaction/rubber_band.h"
#include "core/interaction/stroke_gesture.h"
#include "core/interaction/view_gestures.h"
#include "core/model/origin.h"

namespace fff {

namespace {

std::unique_ptr<Gesture> onViewMark(const PointerEvent &press, const Sight &sight,
                                    GestureContext &context)
{
    const Vec2 &at = press.position;
    if (sight.cubePartAt(at))
        return std::make_unique<OrbitGesture>(press, sight.middleOf(context.selection.sections()));
    if (sight.isOnNumber(at))
        return std::make_unique<OrbitGesture>(press, sight.pivotAt(at));
    return std::make_unique<ClipGesture>(press, context);
}

std::unique_ptr<Gesture> onOperation(const PointerEvent &press, const GestureContext &context)
{
    const OperationMarks *marks = context.overlay.find<OperationMarks>();
    if (press.button != Button::Left || !marks ||
        dragKind(context.settings.navigation, press.button, press.modifiers) != DragKind::Edit)
        return nullptr;
    const int index =
        handleAt(*marks, context.camera, context.viewport, press.position, reachOf(press.pointer));
    if (index < 0)
        return nullptr;
    return std::make_unique<OperationGesture>(*marks, index, press, context);
}

std::unique_ptr<Gesture> onJoint(const PointerEvent &press, const Sight &sight,
                                 GestureContext &context)
{
    const sign::Joints *shown = context.overlay.find<sign::Joints>();
    if (press.button != Button::Left || !shown ||
        dragKind(context.settings.navigation, press.button, press.modifiers) != DragKind::Edit)
        return nullptr;
    const sign::Joints joints = *shown;
    const std::vector<JointMark> &marks = joints.marks;
    // What is selected is lit first.
    const bool hasSelected = context.selection.joint() && !joints.lit.empty();
    const int index = jointMarkAt(marks, hasSelected ? &joints.lit.front() : nullptr, sight,
                                  press.position, reachOf(press.pointer));
    if (index < 0)
        return nullptr;
    return std::make_unique<JointGesture>(marks[static_cast<std::size_t>(index)], press, context);
}

std::unique_ptr<Gesture> onLoad(const PointerEvent &press, const GestureContext &context)
{
    if (press.button != Button::Left ||
        dragKind(context.settings.navigation, press.button, press.modifiers) != DragKind::Edit)
        return nullptr;
    const std::optional<LoadAt> at = loadAt(press.position, context);
    return at ? std::make_unique<LoadGesture>(*at, context) : nullptr;
}

std::unique_ptr<Gesture> onMagnet(const PointerEvent &press, const GestureContext &context)
{
    if (press.button != Button::Left ||
        dragKind(context.settings.navigation, press.button, press.modifiers) != DragKind::Edit)
        return nullptr;
    const auto handle = magnetHandle(context.model, context.selection, context.camera);
    if (!handle || !isOnMagnet(*handle, context, press.position, reachOf(press.pointer)))
        return nullptr;
    return std::make_unique<MagnetGesture>(*handle, press, context);
}

/// Ctrl, which turns the view elsewhere, does something of its own to points and handles.
std::unique_ptr<Gesture> onPoint(const PointerEvent &press, const Sight &sight,
                                 const GestureContext &context)
{
    const sign::Points *points = context.overlay.find<sign::Points>();
    if (press.button != Button::Left || press.modifiers.space || !points)
        return nullptr;
    const SectionRef &section = points->section;
    const auto target = pointTargetAt(sight, section, context.points, press.position);
    const bool edits =
        dragKind(context.settings.navigation, press.button, press.modifiers) == DragKind::Edit;
    if (!target || (target->kind == PointTarget::Kind::Line && !edits))
        return nullptr;
    return std::make_unique<PointGesture>(*target, press, section, context);
}

/// The left button alone: what lies under the cursor decides.
std::unique_ptr<Gesture> editing(const PointerEvent &press, const Sight &sight,
                                 GestureContext &context)
{
    if (context.model.sectionCount() == 0)
        return std::make_unique<StrokeGesture>(
            press, ContourTarget::newSection(firstCanvas(context.camera)), context);
    const std::vector<Hit> hits = sight.hitsAt(press.position);
    if (hits.empty() && press.modifiers.shift) {
        if (const sign::Points *points = context.overlay.find<sign::Points>())
            return std::make_unique<PointBandGesture>(
                press, *editedSection(context.model, points->section), context);
        return std::make_unique<RubberBandGesture>(press, context);
    }
    if (!hits.empty() && !sight.isOnEdge(hits.front()))
        return std::make_unique<StrokeGesture>(press, hits.front(), context);
    return std::make_unique<OrbitGesture>(press, sight.pivotAt(press.position));
}

/// What a drag does to the view; one that edits elsewhere turns it.
std::unique_ptr<Gesture> moving(const PointerEvent &press, const Sight &sight,
                                GestureContext &context)
{
    context.camera = sight.cameraAt(press.position);
    switch (dragKind(context.settings.navigation, press.button, press.modifiers)) {
    case DragKind::Pan:
        return std::make_unique<PanGesture>(press);
    case DragKind::Zoom:
        return std::make_unique<ZoomGesture>(press);
    case DragKind::Edit:
    case DragKind::Orbit:
        break;
    }
    return std::make_unique<OrbitGesture>(press, sight.pivotAt(press.position));
}

} // namespace

bool isOnViewMark(const Sight &sight, const Vec2 &position)
{
    return sight.cubePartAt(position) || sight.isOnNumber(position) || sight.isOnHandle(position);
}

std::unique_ptr<Gesture> gestureFor(const PointerEvent &press, const Sight &sight,
                                    GestureContext &context)
{
    if (press.button == Button::Left && isOnViewMark(sight, press.position))
        return onViewMark(press, sight, context);
    if (auto gesture = onOperation(press, context))
        return gesture;
    if (auto gesture = onLoad(press, context))
        return gesture;
    if (auto gesture = onMagnet(press, context))
        return gesture;
    if (auto gesture = onJoint(press, sight, context))
        return gesture;
    if (auto gesture = onPoint(press, sight, context))
        return gesture;
    if (dragKind(context.settings.navigation, press.button, press.modifiers) == DragKind::Edit) {
        context.camera = sight.cameraAt(press.position);
        return editing(press, sight, context);
    }
    return moving(press, sight, context);
}

std::unique_ptr<Gesture> viewGestureFor(const PointerEvent &press, const Sight &sight,
                                        GestureContext &context)
{
    if (press.button == Button::Left && sight.cubePartAt(press.position))
        return onViewMark(press, sight, context);
    return moving(press, sight, context);
}

} // namespace fff
