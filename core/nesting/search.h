// Makes a layout better for as long as there is work to do. Internal to nesting.
#pragma once

#include "core/nesting/first_layout.h"

#include <optional>
#include <stop_token>

namespace fff::nest {

/// Two explorations with seeds of their own, which meet from time to time, where the better layout
/// is taken over by both: the same result however their threads are timed.
/// work   of each of the two
Laid improved(Prepared &prepared, Laid laid, const Options &options, const LongWork &longWork,
              Steps &steps);

/// What overlaps there, or reaches over its sheet, is moved until nothing does; none where little
/// work does not do, or for more pieces than one search takes.
std::optional<Laid> takenApart(Prepared &prepared, const Laid &laid, std::uint64_t seed,
                               std::stop_token stop, Steps &steps);

} // namespace fff::nest
