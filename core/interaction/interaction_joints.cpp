#include "core/assembly/joint_editing.h"
#include "core/interaction/interaction_private.h"

namespace fff {

namespace {

/// Cosine of the angle on the screen up to which an axis runs along an arrow, 60°.
constexpr double kAlongArrow = 0.5;
/// Sine of the angle to the axis below which one looks along it.
constexpr double kSeenAlong = 0.05;

} // namespace

// Marks of joints.

/// Null when none is there, or none can be taken hold of.
const JointMark *Interaction::Private::jointMarkAt(const Vec2 &position)
{
    if (tool || isOnViewMark(sight(), position))
        return nullptr;
    const std::vector<JointMark> &all = jointMarks.of(host.model(), selection);
    const JointLook *selected = selection.joint() ? jointMarks.look(*selection.joint()) : nullptr;
    const int index = fff::jointMarkAt(all, selected, sight(), position, reachOf(pointer));
    return index < 0 ? nullptr : &all[static_cast<std::size_t>(index)];
}

void Interaction::Private::hoverJoint()
{
    hoveredJoint.reset();
    const std::optional<Vec2> &at = hovering.position();
    if (!at || hoveredHandle || isOverMagnet || hovered.load.isValid() || motion.animation)
        return;
    if (const JointMark *mark = jointMarkAt(*at)) {
        hoveredJoint = *mark;
        hovering.unmark(hovered);
    }
}

void Interaction::Private::markJoints()
{
    if (gesture && gesture->marksJoints())
        return;
    overlay.selected.remove<sign::Joints>();
    if (isHandBusy())
        return;
    const Model &model = host.model();
    const auto under = static_cast<std::size_t>(std::max(sectionUnderCursor, 0));
    const std::optional<SectionRef> pointedAt =
        hovering.isOverView() && sectionUnderCursor >= 0 && under < model.sectionCount()
            ? std::optional(model.ref(under))
            : std::nullopt;
    // A model is full of joints: those are marked that are asked for, by the cursor or in a list.
    const auto isAskedFor = [&](const JointRef &joint) {
        return listsJoints || selection.joint() == joint ||
               (hoveredJoint && hoveredJoint->joint == joint) ||
               (pointedAt && (joint.a == *pointedAt || joint.b == *pointedAt));
    };
    sign::Joints shown;
    for (const JointMark &mark : jointMarks.of(model, selection)) {
        if (!isAskedFor(mark.joint) || !isShown(mark, sight()))
            continue;
        if (!gesture && hoveredJoint == mark)
            shown.hovered = static_cast<int>(shown.marks.size());
        shown.marks.push_back(mark);
    }
    const auto light = [&](const JointRef &joint) {
        const JointLook *look = jointMarks.look(joint);
        if (look && (shown.lit.empty() || !(shown.lit.front() == *look)))
            shown.lit.push_back(*look);
    };
    if (selection.joint())
        light(*selection.joint());
    if (shown.hovered >= 0)
        light(shown.marks[static_cast<std::size_t>(shown.hovered)].joint);
    if (!shown.marks.empty())
        overlay.selected.put(std::move(shown));
}

/// Along the axis as it runs on the screen; what looks along it cannot tell which way.
bool Interaction::Private::nudgeMeetingPoints(const JointRef &joint, const Vec2 &arrow,
                                              double distance)
{
    const Model &model = host.model();
    const std::optional<JointState> state = jointState(model, joint);
    if (!state)
        return false;
    const Camera &camera = motion.camera;
    const Vec3 at = state->meetingPoint(0);
    const Vec2 way = camera.toScreen(at + state->crossing.axis.direction, motion.viewport) -
                     camera.toScreen(at, motion.viewport);
    const double along = way.x() * arrow.x() - way.y() * arrow.y();
    if (std::abs(along) < kAlongArrow * way.norm() ||
        way.norm() < kSeenAlong / camera.scaleAt(at, motion.viewport))
        return false;
    cancelGesture();
    JointEdit edit = fff::nudgeMeetingPoints(model, joint, along > 0.0 ? distance : -distance);
    if (!edit) {
        note = Note{edit.error(), now + kNoteTime};
        return true;
    }
    note.reset();
    if (!edit->document.isSame(model.document)) {
        document = edit->document;
        host.commit(edit->step, std::move(edit->document));
    }
    hover();
    return true;
}

} // namespace fff
