// The signs that lie over the model, and what the cursor is over.
#pragma once

#include "core/interaction/sign.h"
#include "core/interaction/view_cube.h"

#include <algorithm>
#include <utility>

namespace fff {

/// Signs in the order in which they came.
class Signs
{
public:
    void add(Sign sign) { m_signs.push_back(std::move(sign)); }
    /// In place of those of its kind.
    template <class Kind>
    Kind &put(Kind sign)
    {
        remove<Kind>();
        return std::get<Kind>(m_signs.emplace_back(std::move(sign)));
    }
    template <class Kind>
    void remove()
    {
        std::erase_if(m_signs, [](const Sign &sign) { return std::holds_alternative<Kind>(sign); });
    }
    /// The first of a kind; null: there is none.
    template <class Kind>
    const Kind *find() const
    {
        for (const Sign &sign : m_signs)
            if (const Kind *found = std::get_if<Kind>(&sign))
                return found;
        return nullptr;
    }
    template <class Kind>
    Kind *find()
    {
        return const_cast<Kind *>(std::as_const(*this).find<Kind>());
    }

    bool isEmpty() const { return m_signs.empty(); }
    void clear() { m_signs.clear(); }
    auto begin() const { return m_signs.begin(); }
    auto end() const { return m_signs.end(); }
    bool operator==(const Signs &) const = default;

private:
    std::vector<Sign> m_signs;
};

struct Overlay
{
    Signs drawn;    // of the gesture, and of a stroke within a tool, as long as they last
    Signs held;     // of the tool in the hand (Tool::mark), anew after each event
    Signs selected; // of what is selected
    Signs offered;  // of what a stroke was meant to be (shape_offer.h)

    /// Among all of them.
    template <class Kind>
    const Kind *find() const
    {
        for (const Signs *signs : {&drawn, &held, &selected, &offered})
            if (const Kind *found = signs->find<Kind>())
                return found;
        return nullptr;
    }
    /// A stroke, or the slit that it begins with.
    bool hasStroke() const
    {
        return find<sign::Stroke>() || find<sign::Slit>() || find<sign::Capsule>();
    }
};

/// What is under the cursor while nothing is dragged.
struct Hovered
{
    int section = -1;              // index of the section
    std::optional<Vec3> slitStart; // where a slit would begin there; world, mm
    /// The cursor has rested on a section: its name may be shown there (px).
    std::optional<Vec2> namePlace;
    std::optional<CubePart> cubePart; // of the view cube
    bool isCutHandle = false;         // also while that is dragged
    int problem = 0;                  // number of its mark; 0: none
    int problemPlace = 0;             // and which of its places
    DimensionId dimension;            // or in the hand
    LoadId load;                      // "

    bool operator==(const Hovered &) const = default;
};

} // namespace fff
