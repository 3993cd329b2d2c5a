// What a hand drew by mistake.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// A line whose larger extent stays below this is a slip of the hand, mm.
inline constexpr double kTwitch = 6.0;

/// Whether it is one: less than kTwitch wide and high, and no loop. A loop is drawn on purpose,
/// however small: its ends are nearer to each other than half of its extent, it is more than twice
/// as long as that, and it encloses a fifth of its box's square. So an eye of 5 mm is a shape; a
/// stroke of 5 mm there and back, a hook or an arc are none, at any zoom.
///
/// samples  finite, mm
bool isTwitch(const std::vector<Vec2> &samples);

} // namespace fff
