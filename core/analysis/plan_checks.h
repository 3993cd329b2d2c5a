// The findings of a model that is there, not of each place on the way of a drag: what the plan of
// its assembly says, and what its slits leave.
#pragma once

#include "core/analysis/plan_finder.h"

#include <chrono>
#include <functional>
#include <span>

namespace fff {

/// What finds them, in the order in which a person reads them.
std::span<const PlanFinder> planFinders();

/// Whether it can be assembled, which sections are in each other without a slit between them, which
/// form rings, and where slits leave too little; the verdict first, the others in the order of the
/// sections. Nothing for a model without parts.
std::vector<Finding> planChecks(const Analysis &analysis, const ModelPlan &plan,
                                const CheckRules &rules = {});
/// The same, with any caches.
std::vector<Finding> planChecks(const Analysis &analysis, const ModelPlan &plan,
                                PlanCheckCaches &caches, const CheckRules &rules = {});

/// True once so much time has gone by from now on: for planOf().
std::function<bool()> timeLimit(std::chrono::milliseconds time);

} // namespace fff
