// Rings of joints that slide in different directions: the paper's sign of what cannot be put
// together.
#pragma once

#include "core/analysis/plan_finder.h"

namespace fff {

/// Of kRings.
struct Rings
{
    int count = 0;
    bool hasSteps = false;          // it can be put together all the same
    std::vector<ProblemLink> links; // of their joints
};

extern const FindingKind kRings;

/// A hint, whatever planning finds; not where its verdict speaks of the same sections.
void findRings(const LookedAtPlan &at, std::vector<Finding> &found);

} // namespace fff
