// What a person wants of the checks.
#pragma once

#include "core/analysis/strength_rules.h"

#include <chrono>

namespace fff {

struct CheckRules
{
    double shallowAngle = 0.52359877559829887; // radians, 30°: slits get wide below this
    /// mm: sections that overlap by less only touch, which is no fault.
    double touching = 0.3;
    std::chrono::milliseconds planningTime{1000};
    StrengthRules strength = {};

    bool operator==(const CheckRules &) const = default;
};

} // namespace fff
