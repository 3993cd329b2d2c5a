#include "core/interaction/hovering.h"

#include <string>

namespace fff {

namespace {

/// A name stays while the cursor is this near to where it was shown, px.
constexpr double kNameReach = 24.0;

} // namespace

void Hovering::moveTo(const Vec2 &position)
{
    m_rests = m_position == position;
    m_position = position;
}

void Hovering::leave()
{
    m_rests = false;
    m_position.reset();
}

void Hovering::unmark(Hovered &hovered)
{
    hovered = {};
    m_nameTime.reset();
}

void Hovering::mark(const Sight &sight, double now, double nameDelay, Hovered &hovered)
{
    const int section = hovered.section;
    const std::optional<Vec2> namePlace = hovered.namePlace;
    const std::optional<double> nameDue = m_nameTime;
    unmark(hovered);
    if (!m_position)
        return;
    hovered.cubePart = sight.cubePartAt(*m_position);
    if (hovered.cubePart)
        return;
    hovered.problem = sight.markAt(*m_position);
    if (hovered.problem > 0)
        return;
    hovered.isCutHandle = sight.isOnHandle(*m_position);
    if (hovered.isCutHandle)
        return;
    const std::vector<Hit> hits = sight.hitsAt(*m_position);
    if (hits.empty())
        return;
    hovered.section = hits.front().section;
    if (!sight.isOnEdge(hits.front()))
        hovered.slitStart = hits.front().point;
    if (hovered.section == section && namePlace && (*namePlace - *m_position).norm() <= kNameReach)
        hovered.namePlace = namePlace;
    else if (hovered.section == section && nameDue && m_rests)
        m_nameTime = nameDue;
    else
        m_nameTime = now + nameDelay;
}

void Hovering::advance(double now, Hovered &hovered)
{
    if (m_nameTime && now >= *m_nameTime) {
        m_nameTime.reset();
        hovered.namePlace = m_position;
    }
}

std::pair<Hint, Cursor> hoverHint(const OperationHandle &handle, const Model &model)
{
    const Operation *operation = model.document.find(handle.operation);
    return {
        {Hint::Kind::MoveHandleOf, operation ? operation->name : std::string(), false, handle.key},
        Cursor::MoveCross};
}

std::pair<Hint, Cursor> hoverHint(const Hovered &hovered, const Overlay &overlay,
                                  const Model &model, const Selection &selection)
{
    if (hovered.cubePart)
        return {{Hint::Kind::LookFrom, std::string(nameOfPart(*hovered.cubePart)), false},
                Cursor::Hand};
    if (hovered.problem > 0)
        return {{Hint::Kind::ChooseProblem, std::to_string(hovered.problem), false}, Cursor::Hand};
    if (hovered.isCutHandle)
        return {{Hint::Kind::MoveCut, {}, false}, Cursor::MoveCross};
    if (model.sectionCount() == 0)
        return {{Hint::Kind::DrawFirstSection, {}, false}, Cursor::Pencil};
    if (hovered.section >= 0) {
        const Section &section = *model.section(static_cast<std::size_t>(hovered.section));
        const Operation *operation = model.document.find(section.made.operation);
        if (operation) {
            const bool isChosen = operationInFocus(selection) == operation->id;
            return {{isChosen ? Hint::Kind::SelectInstance : Hint::Kind::SelectOperation,
                     section.name, false, operation->name},
                    hovered.slitStart ? Cursor::PencilWithSlit : Cursor::Arrow};
        }
        if (hovered.slitStart)
            return {{Hint::Kind::DragOutOfSection, section.name, false}, Cursor::PencilWithSlit};
        return {{Hint::Kind::SeenOnEdge, section.name, false}, Cursor::Arrow};
    }
    const Operation *operation = model.document.find(selection.operation());
    const OperationMarks *marks = overlay.find<OperationMarks>();
    if (operation && marks && !marks->handles.empty())
        return {{Hint::Kind::MoveRange, operation->name, false}, Cursor::Arrow};
    return {{Hint::Kind::TurnView, {}, false}, Cursor::Arrow};
}

std::pair<Hint, Cursor> hoverHint(const PointTarget &target)
{
    switch (target.kind) {
    case PointTarget::Kind::Anchor:
        return {{Hint::Kind::MovePoint, {}, false}, Cursor::MoveCross};
    case PointTarget::Kind::Handle:
        return {{Hint::Kind::MoveHandle, {}, false}, Cursor::MoveCross};
    case PointTarget::Kind::Line:
        return {{Hint::Kind::AddPoint, {}, false}, Cursor::ArrowWithPlus};
    }
    return {}; // not reached: every kind is above
}

std::pair<Hint, Cursor> hoverHint(const JointMark &mark, const Model &model, bool isSelected)
{
    const Hint::Kind kind = !mark.moves  ? Hint::Kind::SelectJoint
                            : isSelected ? Hint::Kind::MoveSelectedMeetingPoint
                                         : Hint::Kind::MoveMeetingPoint;
    return {{kind, model.nameOf(mark.joint.a), false, model.nameOf(mark.joint.b)}, Cursor::Hand};
}

} // namespace fff
