// What the stages find of a document, one after the other on the thread of whoever asks, and from
// scratch: nothing of it hangs on a clock, or on what was there before.
#pragma once

#include "core/analysis/mends.h"
#include "core/model/document.h"

#include <vector>

namespace fff::test {

struct Staged
{
    AnalysisPointer analysis;
    std::vector<Finding> found;         // of all stages but those that only refine others
    std::shared_ptr<const Mends> mends; // null unless they are asked for
};

/// Empty where a stage fails.
Staged staged(const Document &document);
Staged stagedWithMends(const Document &document);

} // namespace fff::test
