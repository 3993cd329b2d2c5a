// The stage of the checks that cost little, worked out at each place of a drag.
#pragma once

#include "core/analysis/checks.h"
#include "core/analysis/stage.h"

namespace fff {

struct Verdicts
{
    AnalysisPointer analysis; // that they are about
    std::vector<Finding> findings;
    std::shared_ptr<CheckCaches> caches; // the stage's own
};

inline constexpr StageOf<Verdicts> kVerdicts{"verdicts"};

Result<Verdicts> verdicts(const Snapshot &snapshot, const Verdicts *previous, Progress &progress,
                          std::stop_token stop);

} // namespace fff
