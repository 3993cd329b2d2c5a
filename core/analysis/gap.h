// How far a group of bodies that nothing holds is from the rest of the model.
#pragma once

#include "core/analysis/check_caches.h"

namespace fff {

/// Of a group of bodies (indices into the list). They are looked at by how near their boxes are; of
/// those equally near, the first in the list comes first and stays unless another is nearer.
CheckCaches::OfGroup measuredGap(const Bodies &bodies, const std::vector<int> &group);

/// Whether the gap may have become another one when the section in this box, or what used to be in
/// it, has changed.
bool isReached(const CheckCaches::OfGroup &gap, const Box3 &box);

} // namespace fff
