// Closing what the holes of a mesh leave open. Internal to templates.
#pragma once

#include "core/templates/cut_chains.h"
#include "core/templates/plane_cut.h"

namespace fff {

/// Loops of the chains: closed ones as they are, open ones joined at their ends, the nearest two
/// ends first, whatever chains they are of (J. McCrae et al. 2014, "Template 3D objects"). From end
/// to end goes a cubic that leaves both as their chains arrive there.
///
/// Area and hole of the loops are left open.
/// Cost  O(n²) for n open chains, a few milliseconds for a thousand.
std::vector<CutLoop> closedChains(std::vector<CutChain> chains, const CutPlane &plane);

} // namespace fff
