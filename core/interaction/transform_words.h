// What is said while sections are moved with handles or numbers.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kTransformPick = FFF_TEXT(
    "Hint", "Click the section to move or turn, or drag it. <kbd>Esc</kbd> hides the handles.");
inline constexpr Text kTransform =
    FFF_TEXT("Hint", "Drag an arrow to move, a ring to turn, a box to scale; or type numbers. "
                     "<kbd>Esc</kbd> hides the handles.");
inline constexpr Text kTransformDrag = FFF_TEXT("Hint", "Drag to move %1; click to select it.");
inline constexpr Text kDragToMove = FFF_TEXT(
    "Hint",
    "Drag to move; <kbd>Ctrl</kbd> leaves a copy, <kbd>Shift</kbd> keeps to one direction.");
inline constexpr Text kDragToTurn =
    FFF_TEXT("Hint", "Drag to turn; <kbd>Ctrl</kbd> leaves a copy.");
inline constexpr Text kDragToScale =
    FFF_TEXT("Hint", "Drag to scale; <kbd>Ctrl</kbd> leaves a copy.");
inline constexpr Text kTransforming = FFF_TEXT(
    "Hint", "Release to keep it like this. <kbd>Ctrl</kbd> leaves a copy, <kbd>Esc</kbd> cancels.");
inline constexpr Text kLeavingCopy =
    FFF_TEXT("Hint", "Release to leave a copy here. <kbd>Esc</kbd> cancels.");
inline constexpr Text kTransformNumbers =
    FFF_TEXT("Hint", "<kbd>Enter</kbd> keeps it like this. <kbd>Esc</kbd> cancels.");
inline constexpr Text kTransformCopies = FFF_TEXT_OF_MANY(
    "Hint",
    "<kbd>Enter</kbd> makes %n copies like this, each a step further. <kbd>Esc</kbd> cancels.");

} // namespace fff::hints
