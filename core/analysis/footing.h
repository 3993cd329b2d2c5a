// How sections stand on the ground.
#pragma once

#include "core/analysis/check_caches.h"
#include "core/assembly/stability.h"

#include <vector>

namespace fff {

/// Of sections (indices into the model), with the weights that hang on them.
MassProperties loadedMass(const Analysis &analysis, const std::vector<int> &sections);

/// Whether and how the sections (indices into the model) stand, taken as one rigid body with the
/// weights that hang on them.
Stability stabilityOf(const Analysis &analysis, const std::vector<int> &sections);
/// The same, of their mass as above, with what is known of their contact with the ground: that is
/// worked out anew only where the contact of one of them changed.
Stability stabilityOf(const Analysis &analysis, const std::vector<int> &sections,
                      const MassProperties &mass, const CheckCaches &caches,
                      CheckCaches::OfStance &stance);

} // namespace fff
