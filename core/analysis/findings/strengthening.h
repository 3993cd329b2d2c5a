// What makes a model bear more: thicker stock, and slits that are cut less deep where they weaken.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// The least usual thickness of the stock of the weakest section with which all holds.
extern const ActionKind kThickerStock;
/// The slit that the weakest section would crack at, as little less deep as it takes.
extern const ActionKind kShallowerSlit;

/// Of a stock that is not rated; the window's.
extern const ActionKind kEnterStrength;

/// Of a verdict with Held.
std::vector<FindingAction> strengthen(const Finding &finding, const Analysis &analysis);
std::vector<FindingAction> enterStrength(const Finding &finding, const Analysis &analysis);

} // namespace fff
