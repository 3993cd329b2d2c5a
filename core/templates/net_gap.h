// How near what is laid beside a net comes to the rest of it. Internal to templates.
#pragma once

#include "core/geometry/polygon.h"
#include "core/templates/mesh_nets.h"

#include <vector>

namespace fff {

/// What is laid beside a fold keeps `gap` mm from all that is there, so that a beam of that width
/// parts them and takes nothing else. At the two ends of the fold they meet, so that within
/// kNearFold gaps of these they may come as near as they like: edges that open by less than about
/// 10° there are too near behind that.
///
/// placed, added  loops that do not cross, and touch along the fold only
bool keepsGap(const std::vector<Polygon> &placed, const std::vector<Polygon> &added,
              const NetLine &fold, double gap);
inline constexpr double kNearFold = 6.0;

} // namespace fff
