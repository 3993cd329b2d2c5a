// How far a group of sections that nothing holds is from the rest of the model.
#pragma once

#include "core/analysis/check_caches.h"

namespace fff {

/// Of a group (indices into the model), from what the caches know of each section. Sections are
/// looked at by how near their boxes are; of those equally near, the first in the model comes first
/// and stays unless another is nearer.
CheckCaches::OfGroup measuredGap(const Analysis &analysis, const std::vector<int> &group,
                                 const CheckCaches &caches);

/// Whether the gap may have become another one when the section in this box, or what used to be in
/// it, has changed.
bool isReached(const CheckCaches::OfGroup &gap, const Box3 &box);

} // namespace fff
