// Makes a layout better for as long as there is work to do. Internal to nesting.
#pragma once

#include "core/nesting/first_layout.h"

namespace fff::nest {

/// Two explorations with seeds of their own, which meet from time to time, where the better layout
/// is taken over by both: the same result however their threads are timed.
/// work   of each of the two
Laid improved(Prepared &prepared, Laid laid, const Options &options, const LongWork &longWork,
              Steps &steps);

} // namespace fff::nest
