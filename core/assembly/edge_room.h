// Where sections have room for tabs and fingers: stretches of lines along their axis. Internal to
// assembly.
#pragma once

#include "core/assembly/lobes.h"

#include <vector>

namespace fff {

/// What is cut and added reaches this far beyond where it must, so that no skin of rounding stays.
inline constexpr double kOvershoot = 0.05; // mm

/// To its left, mm.
PlaneLine shifted(const PlaneLine &line, double across);
/// Where the line is inside.
std::vector<Stretch> stretchesIn(const PlaneLine &line, const Shape &shape);
/// What two lists, each ascending and without overlaps, share, of kMinOverlap at least.
std::vector<Stretch> common(const std::vector<Stretch> &a, const std::vector<Stretch> &b);

} // namespace fff
