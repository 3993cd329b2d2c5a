#include "ui/sheets/part_hand.h"

#include "core/base/units.h"
#include "core/geometry/turning.h"

#include <cmath>

namespace fff::ui {

namespace {

constexpr double kQuarterTurn = 90.0, kHalfTurn = 180.0; // degrees

const Placement &placementOf(const Nested &nested, const SheetSpot &spot)
{
    return nested.layout->sheets[spot.sheet].placements[spot.part];
}

/// Exact for quarter turns.
Vec2 turnOf(double angle)
{
    const double quarters = angle / kQuarterTurn;
    if (quarters != std::round(quarters))
        return {std::cos(radians(angle)), std::sin(radians(angle))};
    Vec2 turn = Vec2::UnitX();
    for (int i = static_cast<int>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0)); i > 0; --i)
        turn = Vec2(-turn.y(), turn.x());
    return turn;
}

} // namespace

std::optional<double> turningStep(nest::Turning turning)
{
    switch (turning) {
    case nest::Turning::None:
        return std::nullopt;
    case nest::Turning::Half:
        return kHalfTurn;
    case nest::Turning::Quarter:
        return kQuarterTurn;
    case nest::Turning::Free:
        break;
    }
    return 0.0;
}

PartHand::PartHand(const SheetsContent &content, const SheetSpot &spot)
    : m_nested(content.made->nested), m_spot(spot),
      m_part(content.facts[spot.sheet].parts[spot.part]),
      m_index(placementOf(*m_nested, spot).part),
      m_placing(m_nested->parts->parts, *m_nested->layout, m_nested->question->nesting.layout,
                m_index)
{
    const Placement &placement = placementOf(*m_nested, spot);
    m_from = {static_cast<int>(spot.sheet), placement.turn, placement.offset};
    m_now = m_from;
}

void PartHand::judge()
{
    m_isSound = m_now == m_from || m_placing.isSound(m_now);
}

void PartHand::moveTo(int sheet, const Vec2 &offset, double reach)
{
    const HandPlace wished{sheet, m_now.turn, offset};
    m_now = reach > 0.0 ? m_placing.snapped(wished, reach) : wished;
    judge();
}

void PartHand::turnFrom(const HandPlace &place, double degrees)
{
    m_now = turnedInPlace(m_nested->parts->parts[static_cast<std::size_t>(m_index)], place,
                          turnOf(degrees));
    judge();
}

void PartHand::put(const HandPlace &place)
{
    m_now = place;
    judge();
}

QTransform PartHand::way() const
{
    const Vec2 back(m_from.turn.x(), -m_from.turn.y());
    const Vec2 by = turned(m_now.turn, back);
    const Vec2 shift = m_now.offset - turned(m_from.offset, by);
    return {by.x(), by.y(), -by.y(), by.x(), shift.x(), shift.y()};
}

QPointF PartHand::middle() const
{
    const Part &part = m_nested->parts->parts[static_cast<std::size_t>(m_index)];
    const Box2 box = turnedBounds(part.outline.region.outer, m_now.turn);
    const Vec2 middle = 0.5 * (box.min + box.max) + m_now.offset;
    return {middle.x(), middle.y()};
}

PinnedPlace PartHand::place() const
{
    const Sheet &sheet = m_nested->layout->sheets[static_cast<std::size_t>(m_now.sheet)];
    return {m_part.section, m_part.body, sheet.index, m_now.turn, m_now.offset};
}

PinnedPlace placeOf(const SheetsContent &content, const SheetSpot &spot)
{
    return PartHand(content, spot).place();
}

} // namespace fff::ui
