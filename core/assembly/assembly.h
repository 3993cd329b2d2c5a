// From a model to its joints and slits.
#pragma once

#include "core/assembly/joint.h"

namespace fff {

/// All joints and slits of the model. Deterministic.
/// O(n log n + pairs whose boxes meet).
Assembly assemble(const Model &model);

/// The same, made from the assembly of an earlier model: only the joints and slits of sections
/// that differ are computed, all other rows are shared with `before`. A section is the same when
/// its shape, its frame and its stock are. Comparing costs a few nanoseconds a section; where
/// sections were removed or put in before others, rows are written anew for the new places, O(n +
/// joints), but nothing is computed for that.
Assembly assemble(const Model &model, const Model &previous, const Assembly &before);

} // namespace fff
