// What is said while a mirror is in the hand.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

// By what is chosen in the bar.
inline constexpr Text kMirrorCopy =
    FFF_TEXT("Hint", "Adds a mirror image of what is selected. <kbd>Enter</kbd> mirrors; "
                     "<kbd>Esc</kbd> cancels.");
inline constexpr Text kMirrorAlways =
    FFF_TEXT("Hint", "What you change on one side changes on the other. <kbd>Enter</kbd> "
                     "mirrors; <kbd>Esc</kbd> cancels.");
inline constexpr Text kMirrorOnce =
    FFF_TEXT("Hint", "Makes both sides the same once; then each is its own. <kbd>Enter</kbd> "
                     "mirrors; <kbd>Esc</kbd> cancels.");
inline constexpr Text kMirrorAcross = FFF_TEXT(
    "Hint", "Click the section to mirror across; drag to turn the view. <kbd>Esc</kbd> cancels.");
//: before the buttons X, Y, Z and Section, the plane that is mirrored across
inline constexpr Text kMirrorPlane = FFF_TEXT("MirrorBar", "Plane");
//: before the buttons Copy, Both sides and Once
inline constexpr Text kMirrorOutcome = FFF_TEXT("MirrorBar", "How");

} // namespace fff::hints
