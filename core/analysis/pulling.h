// The stage of meshes that magnets pull (core/templates/pulled_templates.h).
#pragma once

#include "core/analysis/stage.h"
#include "core/templates/pulled_templates.h"

namespace fff {

inline constexpr StageOf<PulledTemplates> kPulled{"pulled"};

Result<PulledTemplates> pulled(const Snapshot &snapshot, const PulledTemplates *previous,
                               Progress &progress, std::stop_token stop);

} // namespace fff
