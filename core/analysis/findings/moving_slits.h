// Slits where there is more room for them: sections moved along those that they are in, and slits
// that are cut less deep.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// Of a slit with one wall: its guest is moved in from the edge, until both sides hold.
extern const ActionKind kMoveIn;
/// Of a web that is too thin: the guest of its slit is moved, until the web is a thickness wide.
extern const ActionKind kMoveSlit;
/// The same where the slit's end is too near: the two slits of its joint meet so much earlier.
extern const ActionKind kCutLessDeep;

inline constexpr Text kLessDeepText = FFF_TEXT("Checks", "Make the slit shallower");
/// The slit of host for guest, by so much, mm: the two slits of their joint meet so much earlier.
/// Nothing where they cannot.
std::optional<FindingEdit> cutLessDeepBy(double by, const Slit &slit, const SectionRef &host,
                                         const SectionRef &guest, const Analysis &analysis);

} // namespace fff
