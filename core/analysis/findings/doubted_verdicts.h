// Whether something holds together, goes together, stands and is strong enough is asked of it as it
// would be if nothing else were wrong; what else was found may say that it is not.
#pragma once

#include "core/analysis/finding.h"

namespace fff {

/// In place of kConnected, kCanAssemble, kStands and kHolds, where others among them say that the
/// model comes apart, does not go together as it is cut, or is pushed over, kWouldConnect and so
/// on, and why. Mends are judged by what is found without this: a verdict that is known again is
/// none that was made better or worse.
void doubtVerdicts(std::vector<Finding> &found);

/// Of a verdict that others among them doubt ("Would stand") the one that says why; null: it is
/// none of these.
const Finding *doubterOf(const Finding &verdict, const std::vector<Finding> &found);

/// What keeps a model from going together as it is cut, from standing, and from being as strong as
/// is worked out for it: "if it held together"; empty where nothing found does.
struct VerdictDoubts
{
    Text assembly, standing, strength;
};
VerdictDoubts verdictDoubts(const std::vector<Finding> &found);

} // namespace fff
