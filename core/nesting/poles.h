// Discs that fill a shape. Internal to nesting.
#pragma once

#include "core/nesting/posed.h"

namespace fff::nest {

/// One after the other the largest disc that is inside and in none of those before, until they
/// cover nine tenths or there are Poles::kMost of them. At least one for what has an area.
/// Source  V. Agafonkin 2016, polylabel: halving squares, the most promising first.
std::vector<Pole> polesOf(const Region &shape);

} // namespace fff::nest
