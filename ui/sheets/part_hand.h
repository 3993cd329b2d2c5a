// A part of the Sheets dock that is in somebody's hand: where it would lie, and whether it may.
#pragma once

#include "core/fabrication/hand_placing.h"
#include "core/model/sheet_wishes.h"
#include "ui/sheets/sheets_content.h"

#include <QTransform>

#include <memory>
#include <optional>

namespace fff::ui {

/// How far a part may be turned at once; none: not at all. Degrees; 0: as little as one likes.
std::optional<double> turningStep(nest::Turning turning);

class PartHand
{
public:
    /// content  with what was made of it
    PartHand(const SheetsContent &content, const SheetSpot &spot);

    const SheetSpot &spot() const { return m_spot; }
    const PartOnSheet &part() const { return m_part; }
    const HandPlace &from() const { return m_from; }
    const HandPlace &now() const { return m_now; }
    bool isSound() const { return m_isSound; }
    bool isMoved() const { return m_now != m_from; }
    bool takes(int sheet) const { return m_placing.takes(sheet); }

    /// reach  mm, of snapping; 0: it lies just there
    void moveTo(int sheet, const Vec2 &offset, double reach);
    void moveBy(const Vec2 &way) { moveTo(m_now.sheet, m_now.offset + way, 0.0); }
    /// Against how it lay at first. degrees: counter-clockwise
    void turnFrom(const HandPlace &place, double degrees);
    void turnBy(double degrees) { turnFrom(m_now, degrees); }
    void put(const HandPlace &place);

    /// From where it lay to where it lies now, sheet coordinates of either.
    QTransform way() const;
    /// The middle of its box, on its sheet.
    QPointF middle() const;
    PinnedPlace place() const;

private:
    void judge();

    std::shared_ptr<const Nested> m_nested;
    SheetSpot m_spot;
    PartOnSheet m_part;
    int m_index = 0; // of the part
    HandPlacing m_placing;
    HandPlace m_from, m_now;
    bool m_isSound = true;
};

/// Where that part lies now.
PinnedPlace placeOf(const SheetsContent &content, const SheetSpot &spot);

} // namespace fff::ui
