// What ways to spread a load are called in files, commands and on the command line.
#pragma once

#include "core/model/load.h"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace fff {

inline constexpr std::array<std::pair<std::string_view, Spread>, 4> kSpreadNames{
    {{"point", Spread::Point},
     {"patch", Spread::Patch},
     {"edge", Spread::Edge},
     {"hanging", Spread::Hanging}}};

constexpr std::string_view nameOf(Spread spread)
{
    for (const auto &[name, named] : kSpreadNames)
        if (named == spread)
            return name;
    return {}; // not reached: every one is above
}

constexpr std::optional<Spread> spreadNamed(std::string_view name)
{
    for (const auto &[known, spread] : kSpreadNames)
        if (known == name)
            return spread;
    return {};
}

} // namespace fff
