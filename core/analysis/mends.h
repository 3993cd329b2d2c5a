// The stage of what can be done about what the checks have found.
#pragma once

#include "core/analysis/check_actions.h"
#include "core/analysis/stage.h"

#include <utility>

namespace fff {

/// More checks of one kind than this say less than a number does; nothing is offered for each of
/// the others.
inline constexpr int kMostAlike = 12;

/// Whether it is the same verdict after a change of the model; its numbers may differ.
bool isSameVerdict(const Check &a, const Check &b);

struct Mends
{
    std::vector<std::pair<Check, std::vector<CheckAction>>> ofChecks;

    /// What can be done about the check, or about the same verdict on another model; null where
    /// that is not known.
    const std::vector<CheckAction> *of(const Check &check) const;
};

inline constexpr StageOf<Mends> kMends{"mends"};

Result<Mends> mends(const Snapshot &snapshot, const Mends *previous, Progress &progress,
                    std::stop_token stop);

} // namespace fff
