// What a click selects.
#pragma once

#include "core/interaction/pick.h"
#include "core/interaction/selection.h"

#include <optional>

namespace fff {

/// Keeps the place of the last click: a click at the same place takes what comes after that which
/// the last click took, and after the last one the first again. Of a section that an operation made
/// the operation comes first, then the section; where the operation is chosen already, or sections
/// are added, the section alone.
class ClickSelection
{
public:
    /// `hits`: what lies under the click, nearest first; `adds`: to what was selected; `reach`: px
    /// within which two clicks are at the same place.
    void click(const Model &model, const std::vector<Hit> &hits, const Vec2 &position, double reach,
               bool adds, Selection &selection);
    /// The view or the model changed: what lies behind what is another question.
    void forget() { m_place.reset(); }

private:
    /// An operation, or a section.
    struct Taken
    {
        OperationId operation;
        SectionRef section;
        bool operator==(const Taken &) const = default;
    };

    std::optional<Vec2> m_place; // px
    Taken m_taken;
};

} // namespace fff
