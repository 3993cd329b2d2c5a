// How many forces statics alone leaves open.
#pragma once

#include "core/physics/components.h"

namespace fff {

/// The dimension of the states of stress that need no load:
///
///     r = 6 (J − (N − 1)) + C − rank of the C contact rows
///
/// of N members and J links of six forces each; a foot gives one row, one that is held horizontally
/// three. The rank is that of the feet under one rigid body, since links hold in all ways. 0:
/// forces follow from equilibrium; more: they hang on what is stiff, and on how tight slits are.
///
/// areAllHeld  every foot is held horizontally, else those that are pinned
/// Source  the product's mechanics, section 1.6, step 5.
int indeterminacy(const Structure &structure, const Component &component, bool areAllHeld);

} // namespace fff
