// What a click selects.
#pragma once

#include "core/interaction/pick.h"

#include <optional>

namespace fff {

/// Keeps the place of the last click: a click at the same place takes the section behind the one
/// that the last click took, and after the last one the first again.
class ClickSelection
{
public:
    /// The selection after a click. `hits`: what lies under it, nearest first; `adds`: to what was
    /// selected; `reach`: px within which two clicks are at the same place.
    std::vector<SectionRef> click(const Model &model, const std::vector<Hit> &hits,
                                  const Vec2 &position, double reach, bool adds,
                                  const std::vector<SectionRef> &before);
    /// The view or the model changed: what lies behind what is another question.
    void forget() { m_place.reset(); }

private:
    std::optional<Vec2> m_place; // px
    SectionRef m_taken;
};

} // namespace fff
