// What is said while the pen is in the hand.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kPenWithoutCanvas =
    FFF_TEXT("Hint", "Drag out of a section to draw across it with the pen; drag here to turn the "
                     "view. <kbd>Esc</kbd> puts the pen away.");
inline constexpr Text kPenOnSection =
    FFF_TEXT("Hint", "Drag out of %1 to draw across it with the pen; click to select it.");
inline constexpr Text kPenFirstPoint = FFF_TEXT(
    "Hint", "Click to set the first point, drag to bend. <kbd>Esc</kbd> puts the pen away.");
inline constexpr Text kPenPoint =
    FFF_TEXT("Hint", "Click to set a point, drag to bend; <kbd>Enter</kbd> closes, "
                     "<kbd>Backspace</kbd> takes one back.");
inline constexpr Text kPenSnapped = FFF_TEXT(
    "Hint", "Click to set a point, drag to bend; <kbd>Enter</kbd> closes, "
            "<kbd>Backspace</kbd> takes one back. <kbd>Ctrl</kbd>+click sets it without snapping.");
inline constexpr Text kPenCrosses =
    FFF_TEXT("Hint", "The contour crosses itself: <kbd>Enter</kbd> keeps the largest loop, "
                     "<kbd>Backspace</kbd> takes a point back.");
inline constexpr Text kPenBending = FFF_TEXT(
    "Hint", "Drag to bend; <kbd>Ctrl</kbd> makes a corner, <kbd>Shift</kbd> holds the direction.");
inline constexpr Text kPenOnPoint =
    FFF_TEXT("Hint", "Drag to move the point; <kbd>Ctrl</kbd> turns snapping off, <kbd>Shift</kbd> "
                     "holds the direction.");
inline constexpr Text kPenOnHandle =
    FFF_TEXT("Hint", "Drag the handle to bend; <kbd>Ctrl</kbd> makes a corner.");
inline constexpr Text kPenClosing =
    FFF_TEXT("Hint", "Click to close the contour; drag to move the point.");
inline constexpr Text kPenNumbers =
    FFF_TEXT("Hint", "<kbd>Enter</kbd> sets the point, <kbd>Tab</kbd> goes to the next number. "
                     "<kbd>Esc</kbd> closes the bar.");
inline constexpr Text kNothingToClose =
    FFF_TEXT("Hint", "Not closed: the points enclose nothing yet.");
inline constexpr Text kPathIsOpen = FFF_TEXT(
    "Hint", "A contour is still open: <kbd>Enter</kbd> closes it, <kbd>Esc</kbd> takes it back.");

} // namespace fff::hints
