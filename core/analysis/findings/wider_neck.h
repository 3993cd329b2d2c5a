// Sections that are made wider where they would break.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// The boundaries beside the weakest place are pushed out until it bears what it has to, by as
/// little as that takes; then those of the next one, for as long as something would break. Of a
/// copy its source is made wider. What is symmetric stays so, slits stay where they are, and no
/// others come. Nothing where a boundary would cross itself, where on both sides are slits, or
/// where that takes more than anybody would call a neck.
extern const ActionKind kWiderNeck;

} // namespace fff
