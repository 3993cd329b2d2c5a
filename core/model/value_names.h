// What files and scripts call kinds of values, and what has numbers that can be driven.
#pragma once

#include "core/model/binding.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace fff {

inline constexpr std::array<std::pair<std::string_view, ValueKind>, 9> kValueKindNames{
    {{"number", ValueKind::Number},
     {"length", ValueKind::Length},
     {"angle", ValueKind::Angle},
     {"count", ValueKind::Count},
     {"mass", ValueKind::Mass},
     {"ratio", ValueKind::Ratio},
     {"text", ValueKind::Text},
     {"choice", ValueKind::Choice},
     {"switch", ValueKind::Switch}}};

inline constexpr std::array<std::pair<std::string_view, DrivenPlace::Of>, 8> kDrivenNames{
    {{"stock", DrivenPlace::Of::Stock},
     {"operation", DrivenPlace::Of::Operation},
     {"section", DrivenPlace::Of::Section},
     {"figure", DrivenPlace::Of::Figure},
     {"lettering", DrivenPlace::Of::Lettering},
     {"load", DrivenPlace::Of::Load},
     {"joint", DrivenPlace::Of::Joint},
     {"dimension", DrivenPlace::Of::Dimension}}};

template <class Kind, std::size_t count>
constexpr std::string_view nameIn(const std::array<std::pair<std::string_view, Kind>, count> &names,
                                  Kind kind)
{
    for (const auto &[name, named] : names)
        if (named == kind)
            return name;
    return {}; // not reached: every one is above
}

template <class Kind, std::size_t count>
constexpr std::optional<Kind>
namedIn(const std::array<std::pair<std::string_view, Kind>, count> &names, std::string_view name)
{
    for (const auto &[known, kind] : names)
        if (known == name)
            return kind;
    return std::nullopt;
}

/// An index says which of a thing's parts it is.
constexpr bool hasIndex(DrivenPlace::Of of)
{
    return of == DrivenPlace::Of::Figure || of == DrivenPlace::Of::Lettering ||
           of == DrivenPlace::Of::Joint;
}

} // namespace fff
