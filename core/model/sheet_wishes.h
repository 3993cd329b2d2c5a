// What a person wants of how parts lie on their sheets: those that stay where they were put, and
// how sections may be turned there.
#pragma once

#include "core/model/section.h"
#include "core/nesting/problem.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace fff {

/// Of a part: by its section, and which of its bodies it is, in their order. It may name nothing
/// now (dormant), as a section that an operation made may.
struct PinnedPlace
{
    SectionRef section;
    int body = 0;
    int sheet = 0; // among the whole ones of its stock, from 0 on; -1 is the first of its offcuts
    Vec2 turn = Vec2::UnitX();  // cosine and sine, counter-clockwise
    Vec2 offset = Vec2::Zero(); // mm: on the sheet = turned(p, turn) + offset, p as in its contour

    bool operator==(const PinnedPlace &) const = default;
};

/// Of all parts of a section, in place of what is asked of all sections.
struct SectionTurning
{
    SectionRef section;
    nest::Turning turning = nest::Turning::None;

    bool operator==(const SectionTurning &) const = default;
};

/// What is more is nonsense: so many sheets, so many bodies of a section.
inline constexpr int kMostPinnedSheets = 10000, kMostPinnedBodies = 10000;
/// A turn makes a part neither larger nor smaller by more than this share.
inline constexpr double kPinnedTurnError = 1e-9;

/// What turnings are called in files and commands.
inline constexpr std::array<std::pair<std::string_view, nest::Turning>, 4> kTurningNames{
    {{"none", nest::Turning::None},
     {"half", nest::Turning::Half},
     {"quarter", nest::Turning::Quarter},
     {"free", nest::Turning::Free}}};

constexpr std::string_view nameOf(nest::Turning turning)
{
    for (const auto &[name, named] : kTurningNames)
        if (named == turning)
            return name;
    return {}; // not reached: every turning is above
}

constexpr std::optional<nest::Turning> turningNamed(std::string_view name)
{
    for (const auto &[known, turning] : kTurningNames)
        if (known == name)
            return turning;
    return {};
}

} // namespace fff
