// Sections that only touch: by so little that nobody who puts them together will see it.
#pragma once

#include "core/analysis/check_rules.h"
#include "core/analysis/finding.h"
#include "core/analysis/plan_finder.h"

namespace fff {

/// Of kTouching.
struct Touching
{
    int pairs = 0;
    double least = 0.0; // mm: those that overlap by less
};

extern const FindingKind kTouching; // one for the whole model

/// Whether the sections of a joint overlap by less than the rules say: it is no joint, and no
/// fault.
bool onlyTouch(const Joint &joint, const CheckRules &rules);

void findTouching(const LookedAtPlan &at, std::vector<Finding> &found);

} // namespace fff
