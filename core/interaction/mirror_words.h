// What is said while a mirror is in the hand.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kMirrorWhat =
    FFF_TEXT("Hint", "Choose the plane and what to mirror in the bar; <kbd>Enter</kbd> mirrors. "
                     "<kbd>Esc</kbd> cancels.");
inline constexpr Text kMirrorAcross = FFF_TEXT(
    "Hint", "Click the section to mirror across; drag to turn the view. <kbd>Esc</kbd> cancels.");
//: before the buttons X, Y, Z and Section, the plane that is mirrored across
inline constexpr Text kMirrorPlane = FFF_TEXT("MirrorBar", "Plane");
//: before the buttons Copy, Both sides and Once
inline constexpr Text kMirrorOutcome = FFF_TEXT("MirrorBar", "How");

} // namespace fff::hints
