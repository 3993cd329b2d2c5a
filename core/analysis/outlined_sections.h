// Whom the view outlines of those that a finding is about.
#pragma once

#include "core/analysis/finding.h"

#include <vector>

namespace fff {

/// Of what stands or falls as a whole its feet: those of its sections that reach lowest, on the
/// ground, in it, or above it where none is there. Outlining all of them would say nothing. Of all
/// else whom it is about.
std::vector<SectionRef> outlinedSections(const Finding &finding, const Model &model);

} // namespace fff
