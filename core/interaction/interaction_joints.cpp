#include "core/interaction/interaction_private.h"

namespace fff {

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
    if (!at || motion.animation)
        return;
    if (const JointMark *mark = jointMarkAt(*at)) {
        hoveredJoint = *mark;
        hovering.unmark(overlay);
    }
}

void Interaction::Private::markJoints()
{
    if (gesture && gesture->marksJoints())
        return;
    overlay.joints.reset();
    if (!marksSelection())
        return;
    Overlay::Joints shown;
    for (const JointMark &mark : jointMarks.of(host.model(), selection)) {
        if (!isShown(mark, sight()))
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
        overlay.joints = std::move(shown);
}

} // namespace fff
