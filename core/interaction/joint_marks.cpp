#include "core/interaction/joint_marks.h"

#include "core/base/tolerances.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>

namespace fff {

namespace {

/// Beside the slit of a selected joint, px: seen on its edge it is a line.
constexpr double kSlitReach = 4.0;

void addOutlines(const Model &model, int host, const std::vector<Slit> &slits, JointLook &look)
{
    const auto index = static_cast<std::size_t>(host);
    const Frame &frame = model.section(index)->frame;
    for (const Slit &slit : slits) {
        if (slit.role == SlitRole::Shoulder)
            continue; // its tabs tell enough
        for (const Polygon &cut : slit.outlines(kDrawChord)) {
            JointLook::Outline outline{model.ref(index), slit.overlap, {}};
            for (const Vec2 &corner : cut)
                outline.corners.push_back(frame.toWorld(corner));
            look.slits.push_back(std::move(outline));
        }
    }
}

/// As it is drawn, on one of the slits of that overlap.
bool isOnSlit(const JointLook &look, int overlap, const Sight &sight, const Vec2 &position)
{
    for (const JointLook::Outline &slit : look.slits) {
        if (slit.overlap != overlap)
            continue;
        Polygon drawn;
        for (const Vec3 &corner : slit.corners)
            drawn.push_back(sight.camera.toScreen(corner, sight.viewport));
        if (locate(position, drawn) != Side::Outside)
            return true;
        for (std::size_t i = 0, j = drawn.size() - 1; i < drawn.size(); j = i++)
            if (distanceToSegment(position, drawn[j], drawn[i]) <= kSlitReach)
                return true;
    }
    return false;
}

} // namespace

JointLook lookOf(const Model &model, const JointState &state)
{
    JointLook look;
    look.joint = state.ref;
    addOutlines(model, state.a, state.slitsOfA, look);
    addOutlines(model, state.b, state.slitsOfB, look);
    for (std::size_t i = 0; i < state.crossing.overlaps.size(); ++i)
        look.meetingPoints.push_back(state.meetingPoint(static_cast<int>(i)));
    look.opens = state.openingOfB();
    return look;
}

JointMark markOf(const JointState &state, int overlap)
{
    JointMark mark;
    mark.joint = state.ref;
    mark.overlap = overlap;
    mark.at = state.meetingPoint(overlap);
    mark.moves = state.shares[static_cast<std::size_t>(overlap)].has_value();
    mark.isProblem = state.kind == JointKind::None;
    return mark;
}

void JointMarks::add(const Model &model, const JointRef &joint)
{
    if (look(joint))
        return; // of two sections that are both selected
    const std::optional<JointState> state = jointState(model, joint);
    if (!state)
        return;
    for (std::size_t i = 0; i < state->crossing.overlaps.size(); ++i)
        m_marks.push_back(markOf(*state, static_cast<int>(i)));
    m_looks.push_back(lookOf(model, *state));
}

const std::vector<JointMark> &JointMarks::of(const Model &model, const Selection &selection)
{
    if (m_document && m_document->isSame(model.document) && m_sections == selection.sections() &&
        m_joint == selection.joint())
        return m_marks;
    m_document = model.document;
    m_sections = selection.sections();
    m_joint = selection.joint();
    m_marks.clear();
    m_looks.clear();
    if (m_joint)
        add(model, *m_joint);
    if (m_sections.empty() || m_sections.size() > kMostSections)
        return m_marks;
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        boxes.push_back(worldBounds(*model.section(i)->shape, model.section(i)->frame));
    for (const SectionRef &ref : m_sections) {
        const int here = model.indexOf(ref);
        for (std::size_t i = 0; here >= 0 && i < boxes.size(); ++i)
            if (static_cast<int>(i) != here &&
                boxes[i].intersects(boxes[static_cast<std::size_t>(here)]))
                add(model, {ref, model.ref(i)});
    }
    return m_marks;
}

const JointLook *JointMarks::look(const JointRef &joint) const
{
    const auto found = std::find_if(m_looks.begin(), m_looks.end(),
                                    [&](const JointLook &look) { return look.joint == joint; });
    return found == m_looks.end() ? nullptr : &*found;
}

double reachOf(Pointer pointer)
{
    switch (pointer) {
    case Pointer::Mouse:
        return 10.0;
    case Pointer::Pen:
        return 14.0;
    case Pointer::Finger:
        return 22.0;
    }
    return 0.0; // not reached: every pointer is above
}

bool isShown(const JointMark &mark, const Sight &sight)
{
    if (!sight.view.isPicked(mark.joint.a) || !sight.view.isPicked(mark.joint.b))
        return false;
    if (sight.view.clip && sight.view.clip->height(mark.at) > 0.0)
        return false; // cut away
    const Camera &camera = sight.camera;
    return !camera.isPerspective() ||
           camera.forward().dot(mark.at - camera.eye(sight.viewport)) > 0.0;
}

int jointMarkAt(const std::vector<JointMark> &marks, const JointLook *selected, const Sight &sight,
                const Vec2 &position, double reach)
{
    int best = -1;
    double nearest = reach;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (!isShown(marks[i], sight))
            continue;
        const Vec2 at = sight.camera.toScreen(marks[i].at, sight.viewport);
        if (const double d = (at - position).norm(); d <= nearest) {
            nearest = d;
            best = static_cast<int>(i);
        }
    }
    for (std::size_t i = 0; best < 0 && selected && i < marks.size(); ++i)
        if (marks[i].joint == selected->joint && isShown(marks[i], sight) &&
            isOnSlit(*selected, marks[i].overlap, sight, position))
            best = static_cast<int>(i);
    return best;
}

} // namespace fff
