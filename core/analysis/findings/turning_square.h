// A section turned about where it meets another one, so that it stands square to that.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// Of a finding with two sections: the one that was drawn on the other is turned, by the least
/// turn; else the one that its action names. What was drawn on it goes along.
extern const ActionKind kTurnSquare;

/// For a finding of two sections.
std::vector<FindingAction> turnEither(const Finding &finding, const Analysis &analysis);

} // namespace fff
