// The stage of whether the model holds, more accurately: its bodies bend.
#pragma once

#include "core/analysis/bent_model.h"
#include "core/analysis/holding.h"

namespace fff {

struct Accurate
{
    std::shared_ptr<const Holding> held;   // null: nobody asks for it (StrengthRules::isElastic)
    std::shared_ptr<const BentModel> bent; // under its forces; null where those are not known
    std::vector<Finding> findings;         // of that
    std::shared_ptr<StrengthCaches> caches;
};

inline constexpr StageOf<Accurate> kAccurate{"accurate"};

Result<Accurate> accurate(const Snapshot &snapshot, const Accurate *previous, Progress &progress,
                          std::stop_token stop);

} // namespace fff
