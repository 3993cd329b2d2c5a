// Where a section is so thin that it does not come off the machine in one piece, or not for long.
#pragma once

#include "core/analysis/finding.h"
#include "core/analysis/strength.h"

namespace fff {

extern const FindingKind kHangsByNothing, kThinNeck;

/// Of bodies that are strained; slits have findings of their own (thin_webs.h).
void findThinNecks(const Analysis &analysis, const Strength &strength, std::vector<Finding> &found);

} // namespace fff
