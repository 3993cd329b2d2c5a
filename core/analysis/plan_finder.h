// The contract of what finds in the plan of an assembly: once a model is there, not at each place
// of a drag.
#pragma once

#include "core/analysis/assembly_plan.h"
#include "core/analysis/captives.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/finding_action.h"
#include "core/assembly/webs.h"

#include <vector>

namespace fff {

/// What is known from the time before. Not for several threads at once.
struct PlanCheckCaches
{
    struct OfSection
    {
        CutSectionPointer cut;  // what the rest was worked out of
        double thickness = 0.0; // mm
        std::vector<Web> webs;  // thinner than that; of slits by their places in its row
    };
    std::vector<OfSection> sections; // by index in the model
    CaptiveCache captives;
};

struct LookedAtPlan
{
    const Analysis &analysis;
    const ModelPlan &plan;
    const CheckRules &rules;
    PlanCheckCaches &caches;
};
using PlanFinder = void (*)(const LookedAtPlan &, std::vector<Finding> &);

/// The sections of parts, each once, ascending.
std::vector<int> sectionsOf(const std::vector<int> &parts, const ModelPlan &plan);
/// Two sections that a joint holds, for the view.
ProblemLink linkOf(const Model &model, const Joint &joint);

} // namespace fff
