// The stages of how a model is put together: the order of its assembly and what checks say of it,
// and what would free the parts that are locked.
#pragma once

#include "core/analysis/flips.h"
#include "core/analysis/plan_checks.h"
#include "core/analysis/stage.h"

namespace fff {

struct PlannedAnalysis
{
    AnalysisPointer analysis; // that it is about
    ModelPlan plan;
    std::vector<Finding> findings;
    struct Caches
    {
        PlanCaches plan;
        PlanCheckCaches checks;
    };
    std::shared_ptr<Caches> caches; // the stage's own
};

inline constexpr StageOf<PlannedAnalysis> kPlanned{"plan"};

Result<PlannedAnalysis> planned(const Snapshot &snapshot, const PlannedAnalysis *previous,
                                Progress &progress, std::stop_token stop);

struct FoundFlips
{
    std::optional<Flips> flips; // where parts are locked, and turning slits frees them
};

inline constexpr StageOf<FoundFlips> kFlips{"flips"};

Result<FoundFlips> foundFlips(const Snapshot &snapshot, const FoundFlips *previous,
                              Progress &progress, std::stop_token stop);

} // namespace fff
