#include "core/interaction/hovering.h"

#include "core/interaction/hover_words.h"

#include <string>
#include <string_view>

namespace fff {

namespace {

/// A name stays while the cursor is this near to where it was shown, px.
constexpr double kNameReach = 24.0;

Hint hintOf(const Load &load, bool isSelected, const Model &model)
{
    const Named on{model.nameOf(load.section)};
    if (load.isPush())
        return {isSelected ? hints::kMoveSelectedPush : hints::kSelectPush,
                {forceOf(load.push.norm()), on}};
    return {isSelected ? hints::kMoveSelectedWeight : hints::kSelectWeight,
            {massOf(load.mass), on}};
}

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
    if (const std::optional<PlacedMark> mark = sight.markAt(*m_position)) {
        const ProblemMark &first = sight.marks[mark->marks.front()];
        hovered.problem = first.number;
        hovered.problemPlace = first.place;
        return;
    }
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

Text lookFrom(const CubePart &part)
{
    static constexpr std::pair<std::string_view, Text> kLooks[] = {
        {"front", FFF_TEXT("Hint", "Click to look from the front; drag to turn the view.")},
        {"back", FFF_TEXT("Hint", "Click to look from the back; drag to turn the view.")},
        {"left", FFF_TEXT("Hint", "Click to look from the left; drag to turn the view.")},
        {"right", FFF_TEXT("Hint", "Click to look from the right; drag to turn the view.")},
        {"top", FFF_TEXT("Hint", "Click to look from the top; drag to turn the view.")},
        {"bottom", FFF_TEXT("Hint", "Click to look from below; drag to turn the view.")},
        {"edge", FFF_TEXT("Hint", "Click to look at this edge; drag to turn the view.")},
    };
    for (const auto &[name, text] : kLooks)
        if (name == nameOfPart(part))
            return text;
    return FFF_TEXT("Hint", "Click to look at this corner; drag to turn the view.");
}

std::pair<Hint, Cursor> hoverHint(const OperationHandle &handle, const Model &model)
{
    const Operation *operation = model.document.find(handle.operation);
    const Text text = handle.key == "from" ? hints::kMoveBeginning : hints::kMoveEnd;
    return {{text, {Named{operation ? operation->name : std::string()}}}, Cursor::MoveCross};
}

std::pair<Hint, Cursor> hoverHint(const Hovered &hovered, const Overlay &overlay,
                                  const Model &model, const Selection &selection)
{
    if (hovered.cubePart)
        return {Hint::ofView(lookFrom(*hovered.cubePart)), Cursor::Hand};
    if (hovered.problem > 0)
        return {{hints::kChooseProblem, {Named{std::to_string(hovered.problem)}}}, Cursor::Hand};
    if (hovered.isCutHandle)
        return {hints::kMoveCut, Cursor::MoveCross};
    if (const Load *load = model.document.find(hovered.load))
        return {hintOf(*load, load->id == selection.load(), model), Cursor::Hand};
    if (model.sectionCount() == 0)
        return {hints::kDrawFirstSection, Cursor::Pencil};
    if (hovered.section >= 0) {
        const Section &section = *model.section(static_cast<std::size_t>(hovered.section));
        const Operation *operation = model.document.find(section.made.operation);
        if (operation) {
            const bool isChosen = operationInFocus(selection) == operation->id;
            return {{isChosen ? hints::kSelectInstance : hints::kSelectOperation,
                     {Named{section.name}, Named{operation->name}}},
                    hovered.slitStart ? Cursor::PencilWithSlit : Cursor::Arrow};
        }
        if (hovered.slitStart)
            return {{hints::kDragOutOfSection, {Named{section.name}}}, Cursor::PencilWithSlit};
        return {{hints::kSeenOnEdge, {Named{section.name}}}, Cursor::Arrow};
    }
    const Operation *operation = model.document.find(selection.operation());
    const OperationMarks *marks = overlay.find<OperationMarks>();
    if (operation && marks && !marks->handles.empty())
        return {{hints::kMoveRange, {Named{operation->name}}}, Cursor::Arrow};
    return {Hint::ofView(hints::kTurnView), Cursor::Arrow};
}

std::pair<Hint, Cursor> hoverHint(const PointTarget &target)
{
    switch (target.kind) {
    case PointTarget::Kind::Anchor:
        return {hints::kMovePoint, Cursor::MoveCross};
    case PointTarget::Kind::Handle:
        return {hints::kMoveHandle, Cursor::MoveCross};
    case PointTarget::Kind::Line:
        return {hints::kAddPoint, Cursor::ArrowWithPlus};
    }
    return {}; // not reached: every kind is above
}

std::pair<Hint, Cursor> hoverHint(const JointMark &mark, const Model &model, bool isSelected)
{
    const Named a{model.nameOf(mark.joint.a)}, b{model.nameOf(mark.joint.b)};
    if (!mark.moves)
        return {{hints::kSelectJoint, {a, b}}, Cursor::Hand};
    return {{isSelected ? hints::kMoveSelectedMeetingPoint : hints::kMoveMeetingPoint, {b, a}},
            Cursor::Hand};
}

} // namespace fff
