// What the cursor marks while no button is pressed: the section under it and where a slit would
// begin, after a while its name, the view cube, a problem’s number, the handle of the cut.
#pragma once

#include "core/interaction/interaction.h"
#include "core/interaction/selection.h"
#include "core/interaction/sight.h"

#include <optional>
#include <utility>

namespace fff {

class Hovering
{
public:
    /// The cursor is there (px) by now; a name is waited for from when it comes to rest.
    void moveTo(const Vec2 &position);
    /// It is over the view no more.
    void leave();
    bool isOverView() const { return m_position.has_value(); }
    /// The view moves under it, so it does not rest.
    void disturb() { m_rests = false; }

    /// Says what is under the cursor, and nothing else. `now`: ms; `nameDelay`: ms that the cursor
    /// rests before a name is shown.
    void mark(const Sight &sight, double now, double nameDelay, Hovered &hovered);
    /// px; none: not over the view.
    const std::optional<Vec2> &position() const { return m_position; }
    /// Marks nothing: the view turns.
    void unmark(Hovered &hovered);
    /// Shows the name whose time has come.
    void advance(double now, Hovered &hovered);
    /// When a name is to be shown, ms.
    const std::optional<double> &nameTime() const { return m_nameTime; }

private:
    std::optional<Vec2> m_position;   // none: not over the view
    bool m_rests = false;             // since it was marked last
    std::optional<double> m_nameTime; // ms
};

/// What a click on a part of the view cube does.
Text lookFrom(const CubePart &part);

/// What the next click or drag does at what is marked, and the cursor that says so.
std::pair<Hint, Cursor> hoverHint(const Hovered &hovered, const Overlay &overlay,
                                  const Model &model, const Selection &selection);
/// The same over what of a contour can be dragged.
std::pair<Hint, Cursor> hoverHint(const PointTarget &target);
/// The same over a handle of the selected operation.
std::pair<Hint, Cursor> hoverHint(const OperationHandle &handle, const Model &model);
/// The same over the mark of a joint.
std::pair<Hint, Cursor> hoverHint(const JointMark &mark, const Model &model, bool isSelected);

} // namespace fff
