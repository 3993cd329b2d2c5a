// The stages that the product has.
#pragma once

#include "core/analysis/stage.h"

namespace fff {

/// Each after those that it is derived from.
const std::vector<Stage> &stages();

} // namespace fff
