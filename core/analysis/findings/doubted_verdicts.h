// Whether something stands, and whether it is strong enough, is asked of it as it would be if
// nothing else were wrong; what else was found may say that it is not.
#pragma once

#include "core/analysis/finding.h"

namespace fff {

/// In place of kStands and kHolds, where others among them say that the model comes apart or is
/// pushed over, kWouldStand and kWouldHold, and why. Mends are judged by what is found without
/// this: a verdict that is known again is none that was made better or worse.
void doubtVerdicts(std::vector<Finding> &found);

} // namespace fff
