// What the checks and the tests read of a document, from scratch.
#pragma once

#include "core/analysis/analysis.h"
#include "core/operations/evaluate.h"

namespace fff::test {

inline Analysis analysed(const Model &model)
{
    AnalysisCaches caches;
    return analyse(model, caches);
}

inline Analysis analysed(const Document &document)
{
    return analysed(evaluate(document));
}

} // namespace fff::test
