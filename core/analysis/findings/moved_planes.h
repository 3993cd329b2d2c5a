// A grid of slices whose planes lie elsewhere, where its sections are in each other's way or come
// apart.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// Of the grid that one of the finding's sections is a slice of: its planes a quarter or half of
/// their distance further, or one more each way. Empty for all other sections.
std::vector<FindingAction> movedPlanes(const Finding &finding, const Document &document);

} // namespace fff
