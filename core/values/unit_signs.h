// The units that may stand behind a number.
#pragma once

#include "core/values/worth.h"

#include <span>
#include <string_view>

namespace fff {

struct UnitSign
{
    std::string_view sign; // folded
    double size = 1.0;     // mm, kg or radians
    Powers powers = {};
};

std::span<const UnitSign> unitSigns();
/// In unitSigns(), or -1. Capitals or not are the same.
int findUnitSign(std::string_view piece);

} // namespace fff
