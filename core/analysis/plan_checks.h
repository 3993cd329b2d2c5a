// What is said of a model that is there, not of each place on the way of a drag: what the plan of
// its assembly says, and what its slits leave.
#pragma once

#include "core/analysis/assembly_plan.h"
#include "core/analysis/checks.h"
#include "core/assembly/webs.h"

#include <chrono>

namespace fff {

/// What is known of each section from the time before. Not for several threads at once.
struct WebCaches
{
    struct OfSection
    {
        CutSectionPointer cut;  // what the rest was worked out of
        double thickness = 0.0; // mm
        std::vector<Web> webs;  // thinner than that; of slits by their places in its row
    };
    std::vector<OfSection> sections; // by index in the model
};

/// Whether it can be assembled, which sections are in each other without a slit between them, which
/// form rings, and where slits leave too little; the verdict first, the others in the order of the
/// sections. Nothing for a model without parts.
std::vector<Check> planChecks(const Analysis &analysis, const ModelPlan &plan);
/// The same, with any caches.
std::vector<Check> planChecks(const Analysis &analysis, const ModelPlan &plan, WebCaches &caches);

/// True once so much time has gone by from now on: for planOf().
std::function<bool()> timeLimit(std::chrono::milliseconds time);

} // namespace fff
