// The section that is edited where what an edit costs is measured.
#pragma once

#include "core/analysis/analysis.h"

#include <vector>

namespace fff::bench {

/// Of each section.
std::vector<int> jointCounts(const Analysis &analysis);

/// Index of the first drawn section that has as many joints as the middle one when ordered by that.
int middleSection(const Analysis &analysis, const std::vector<int> &counts);

/// The section moved by so many mm along its plane and across it, so that its mates' slits move,
/// too.
Document moved(const Document &document, SectionId id, double by);

} // namespace fff::bench
