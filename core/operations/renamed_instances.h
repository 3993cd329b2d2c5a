// What sections that operations make are called once others are called otherwise. Internal to
// operations.
#pragma once

#include "core/model/model.h"

#include <map>

namespace fff {

/// From what sections were called to what the same ones are called now.
using Replacements = std::map<SectionRef, SectionRef>;

/// Keys of sections may have names of those in them that they are made of. Of the operation, which
/// both models have: its sections before that have no such key now and the one at the same place,
/// of the same shape, that had none before.
Replacements renamedInstances(const Model &before, const Model &now, OperationId id);

} // namespace fff
