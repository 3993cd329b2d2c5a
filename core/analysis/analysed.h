// The stage that all others begin with: joints, slits, cuts and bodies of the model.
#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/stage.h"

namespace fff {

struct Analysed
{
    AnalysisPointer analysis;
    std::shared_ptr<AnalysisCaches> caches; // the stage's own
};

inline constexpr StageOf<Analysed> kAnalysed{"analysis"};

/// With all that drawing will ask for, so that it costs a worker's time, not the window's.
Result<Analysed> analysed(const Snapshot &snapshot, const Analysed *previous, Progress &progress,
                          std::stop_token stop);

} // namespace fff
