// Which sections are other ones when a value is: what is lit while somebody points at it.
#pragma once

#include "core/model/model.h"

#include <vector>

namespace fff {

/// Ascending, of those that are there now: sections with a number that is made of the value, or of
/// others that are made of it; those of a stock with one; what operations with one make, or
/// operations that look at any of these; and what stands on them, as it moves along.
/// O(bindings and sections · what they look at)
std::vector<SectionRef> dependents(const Model &model, ValueId id);

} // namespace fff
