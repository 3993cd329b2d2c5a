// All that is found out about a model, as the window's Checks have it.
#pragma once

#include "core/analysis/assembly_plan.h"
#include "core/analysis/finding.h"

namespace fff::cli {

/// plan  of the analysis
std::vector<Finding> allFound(const Analysis &analysis, const ModelPlan &plan);

} // namespace fff::cli
