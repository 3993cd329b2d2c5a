// What is said of a canvas that waits for its stroke.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kDrawOnGround =
    FFF_TEXT("Hint", "Draw a section on the ground in one go. <kbd>Esc</kbd> cancels.");
inline constexpr Text kDrawOnFront =
    FFF_TEXT("Hint", "Draw a section on the front plane in one go. <kbd>Esc</kbd> cancels.");
inline constexpr Text kDrawOnSide =
    FFF_TEXT("Hint", "Draw a section on the side plane in one go. <kbd>Esc</kbd> cancels.");
inline constexpr Text kDrawParallel =
    FFF_TEXT("Hint", "Draw a section parallel to %1 in one go. <kbd>Esc</kbd> cancels.");
inline constexpr Text kDrawNewContour =
    FFF_TEXT("Hint", "Draw the new contour of %1 in one go. <kbd>Esc</kbd> keeps the old one.");
inline constexpr Text kDrawHole =
    FFF_TEXT("Hint", "Draw a hole in %1 in one go. <kbd>Esc</kbd> cancels.");
inline constexpr Text kDrawHoleOnAny =
    FFF_TEXT("Hint", "Draw a hole: begin on the section that gets it. <kbd>Esc</kbd> cancels.");

} // namespace fff::hints
