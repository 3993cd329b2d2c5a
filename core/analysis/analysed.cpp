#include "core/analysis/analysed.h"

namespace fff {

Result<Analysed> analysed(const Snapshot &snapshot, const Analysed *previous, Progress &,
                          std::stop_token)
{
    Analysed out{nullptr, previous ? previous->caches : std::make_shared<AnalysisCaches>()};
    out.analysis = analyseNext(snapshot.get(kModel), *out.caches);
    prepareDrawing(*out.analysis, previous ? previous->analysis.get() : nullptr);
    return out;
}

} // namespace fff
