// What is said while something is engraved.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kPickMarked =
    FFF_TEXT("Hint", "Draw on the section to engrave, or click it. <kbd>Esc</kbd> cancels.");
inline constexpr Text kDrawMark = FFF_TEXT(
    "Hint", "Drag to draw a line on %1; <kbd>Shift</kbd> keeps it straight. Click to place text.");
inline constexpr Text kDrawingMark =
    FFF_TEXT("Hint", "Release to keep the line. <kbd>Esc</kbd> cancels.");
//: %1 is the name of a section, seen from behind until now
inline constexpr Text kEngravesFront =
    FFF_TEXT("Hint", "%1 is engraved on its front, the one face that the laser reaches; the view "
                     "has turned to it.");
inline constexpr Text kMarkOutside = FFF_TEXT("Hint", "Nothing engraved: that is not on %1.");
inline constexpr Text kLetterUnknown = FFF_TEXT("Hint", "The character “%1” cannot be engraved.");

} // namespace fff::hints
