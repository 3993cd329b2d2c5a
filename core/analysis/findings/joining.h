// What joins sections that no joint holds: as somebody did not want it, by tabs, or by a move.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

extern const ActionKind kJoinAgain;    // where somebody wanted no joint; with its section
extern const ActionKind kJoinWithTabs; // where one ends on the other's face; with its section
extern const ActionKind kMoveToOther;  // to its section, which a joint can then hold it to
extern const ActionKind kTrim;         // its section, to the finding's other one

/// For joints that somebody wanted not to be: of the two that are in each other, or of what is
/// loose with others. Some may not be there now.
std::vector<FindingAction> joinAgain(const Finding &finding, const Document &document);

/// To the nearest section that it can be joined with; `first` is tried before all others.
std::optional<FindingAction> moveToNearest(const Finding &finding,
                                           const std::optional<SectionRef> &first,
                                           const Analysis &analysis);

/// What can be done about two sections that are in each other: tabs, or trimming the one that loses
/// less.
std::vector<FindingAction> mendsOfPair(const Finding &finding, const Analysis &analysis);

} // namespace fff
