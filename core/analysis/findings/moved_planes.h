// Slices that cross, of a grid or around an axis, whose planes lie elsewhere, where sections are in
// each other's way or come apart.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// Of the slices that one of the finding's sections is of: their planes a quarter, half or three
/// quarters of their distance further, or one more. Empty for all other sections, and for slices
/// in one direction.
std::vector<FindingAction> movedPlanes(const Finding &finding, const Document &document);
/// What may help where none of those does, each tried only as long as nothing is offered: smaller
/// shifts, one or two planes fewer or more, both together; other distances where these are set.
std::vector<FindingAction> otherPlanes(const Finding &finding, const Document &document);

/// Whether there is any of these.
bool areOfCrossingSlices(const Finding &finding, const Document &document);

} // namespace fff
