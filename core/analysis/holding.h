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

/// As the stage has it. work: as of strengthOf().
Holding holdingOf(AnalysisPointer analysis, const StrengthRules &rules,
                  std::shared_ptr<StrengthCaches> caches, const LongWork &work = {});

inline constexpr StageOf<Holding> kHolding{"holding"};

/// With rigid bodies, also where a person wants them to bend: it follows a drag, and what is more
/// accurate takes its place once that is there (accurate.h).
Result<Holding> holding(const Snapshot &snapshot, const Holding *previous, Progress &progress,
                        std::stop_token stop);

} // namespace fff
