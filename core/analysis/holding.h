// The stage of whether the model holds, itself and what hangs on it.
#pragma once

#include "core/analysis/bearable_mass.h"
#include "core/analysis/stage.h"

namespace fff {

struct Holding
{
    AnalysisPointer analysis; // that it is about
    Strength strength;
    BearableMass bearable; // empty without weights
    std::vector<Finding> findings;
    std::shared_ptr<StrengthCaches> caches; // the stage's own
};

/// As the stage has it.
Holding holdingOf(AnalysisPointer analysis, const StrengthRules &rules,
                  std::shared_ptr<StrengthCaches> caches);

inline constexpr StageOf<Holding> kHolding{"holding"};

Result<Holding> holding(const Snapshot &snapshot, const Holding *previous, Progress &progress,
                        std::stop_token stop);

} // namespace fff
