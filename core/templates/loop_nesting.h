// Which loops of a cut are holes. Internal to templates.
#pragma once

#include "core/templates/plane_cut.h"

namespace fff {

/// Works out area and hole of each loop, has them run as holes and others do, largest first.
/// frame  on the plane. Cost  O(points of those whose boxes lie in each other).
void nestLoops(std::vector<CutLoop> &loops, const Frame &frame);

} // namespace fff
