// Whether all of a model could be worked out: what is asked before anything is written that speaks
// for all of it.
#pragma once

#include "core/assembly/body.h"
#include "core/model/model.h"

#include <vector>

namespace fff {

/// Whose sections could not be worked out.
std::vector<const Operation *> failedOperations(const Model &model);
/// The sections that could not be cut out, by their indices in the model that the bodies are of.
std::vector<int> uncutSections(const Bodies &bodies);
/// Those of which slits leave nothing: no part comes of them.
std::vector<int> sectionsWithoutPart(const Bodies &bodies);
/// Those without a solid: these, and those that have no triangles. Computes what is not known yet.
std::vector<int> sectionsWithoutSolid(const Bodies &bodies);

/// Errors  OperationFailed, NotCutOut: one that could not be worked out, by its name. Then the
/// parts
///         are not those of the model.
Result<void> haveParts(const Model &model, const Bodies &bodies);
/// Errors  the same, and NotSolid.
Result<void> haveSolids(const Model &model, const Bodies &bodies);

} // namespace fff
