// The stage of what can be done about what the others have found.
#pragma once

#include "core/analysis/finding_action.h"
#include "core/analysis/stage.h"

#include <utility>

namespace fff {

/// More findings of one kind than this say less than a number does; nothing is offered for each of
/// the others.
inline constexpr int kMostAlike = 12;

struct Mends
{
    std::vector<std::pair<Finding, std::vector<FindingAction>>> ofFindings;

    /// What can be done about the finding, or about the same verdict on another model; null where
    /// that is not known.
    const std::vector<FindingAction> *of(const Finding &finding) const;
};

inline constexpr StageOf<Mends> kMends{"mends"};

/// After stages that have findings: it looks at those of all of them.
Stage mendsOf(const std::vector<Stage> &others);

} // namespace fff
