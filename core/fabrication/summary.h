// The size of a model.
#pragma once

#include "core/model/model.h"

namespace fff {

/// Box of a section's slab: its contour, half a thickness to both sides. World, mm.
Box3 slabBounds(const Section &section, const Stock &stock);
/// Of all slabs. Empty for an empty model.
Box3 slabBounds(const Model &model);

} // namespace fff
