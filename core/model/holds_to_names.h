// What files and scripts call the ends that a section holds to when the one that it is on is
// stretched.
#pragma once

#include "core/model/section.h"

#include <array>
#include <string_view>
#include <utility>

namespace fff {

inline constexpr std::array<std::pair<std::string_view, HoldsTo>, 5> kHoldsToNames{
    {{"proportion", HoldsTo::Proportion},
     {"left", HoldsTo::Left},
     {"right", HoldsTo::Right},
     {"bottom", HoldsTo::Bottom},
     {"top", HoldsTo::Top}}};

} // namespace fff
