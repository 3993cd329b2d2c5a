// What the plan of the assembly says about a model, as verdicts.
#pragma once

#include "core/session/assembly_plan.h"
#include "core/session/checks.h"

#include <chrono>

namespace fff {

/// Whether it can be assembled, and which sections are in each other without a slit between them;
/// the verdict first, the others in the order of the sections. Nothing for a model without parts.
std::vector<Check> planChecks(const Analysis &analysis, const ModelPlan &plan);

/// True once so much time has gone by from now on: for planOf().
std::function<bool()> timeLimit(std::chrono::milliseconds time);

} // namespace fff
