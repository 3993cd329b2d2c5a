// A leg for a section that breaks because too much of it hangs over its feet.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// The weakest section, where it stands upright, gets a leg down to the ground in one piece with
/// it: under what it bears, or at its far end, wherever all holds then. Nothing where something
/// is in the way of a leg.
extern const ActionKind kSecondFoot;

} // namespace fff
