// Where a section is so thin that it does not come off the machine in one piece, or not for long.
#pragma once

#include "core/analysis/finding.h"
#include "core/analysis/strength.h"

namespace fff {

/// mm: a laser burns away what is thinner, or a hand breaks it while it takes the part out.
inline constexpr double kLeastNeck = 0.5;

extern const FindingKind kHangsByNothing, kThinNeck;

/// Of bodies that are strained; slits have findings of their own (thin_webs.h).
void findThinNecks(const Analysis &analysis, const Strength &strength, std::vector<Finding> &found);

} // namespace fff
