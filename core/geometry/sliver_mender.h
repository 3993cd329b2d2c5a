// Rids a triangulation of slivers: what is drawn and printed is rounded, and a sliver would become
// a line or turn inside out. Internal to geometry.
#pragma once

#include "core/geometry/triangulation.h"

namespace fff {

/// Turns the longest edges of slivers over, until none is left but at the boundary. Slivers are
/// lower than 0.0001 mm. False when it comes to no end; O(n) where there is none.
bool mendSlivers(Triangulation &triangulation);

} // namespace fff
