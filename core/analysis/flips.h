// Slits the other way round, so that a model can be put together.
#pragma once

#include "core/analysis/assembly_plan.h"

namespace fff {

struct Flips
{
    Document document; // with the flips as overrides of their joints
    int count = 0;     // of joints whose slits change sides
};

/// Of a model whose plan says that parts are locked, as few flips of joints among them as are found
/// to free them, one locked set after the other; nothing when none do, or not within the time. The
/// result has been planned: it can be assembled.
///
/// Each try plans the locked sections alone, so that it costs their work; up to three flips of a
/// set are tried at once.
std::optional<Flips> flipsThatHelp(const Analysis &analysis, const ModelPlan &plan,
                                   const std::function<bool()> &isOutOfTime = {});

} // namespace fff
