// Whether something stands is asked of it as one piece that nothing pushes; what else was found may
// say that it is not.
#pragma once

#include "core/analysis/finding.h"

namespace fff {

/// In place of kStands, where others among them say that it comes apart or is pushed over,
/// kWouldStand and why.
void doubtStanding(std::vector<Finding> &found);

} // namespace fff
