// What is said of contours that are drawn, whatever draws them.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

// Of the canvas.
inline constexpr Text kCanvasOnEdge =
    FFF_TEXT("Hint", "You can't draw on a plane seen edge-on: turn the view to go on.");
inline constexpr Text kCanvasGone =
    FFF_TEXT("Hint", "Path discarded: its section no longer exists.");
// What became of it, or why nothing did.
inline constexpr Text kFailed = FFF_TEXT(
    "Hint", "Nothing drawn: no section can be made from this line. Draw it as one open loop.");
inline constexpr Text kBelowGround =
    FFF_TEXT("Hint", "Nothing drawn: all of it lies below the ground, where it is cut off.");
inline constexpr Text kHoleOutside =
    FFF_TEXT("Hint", "No hole made: it must lie in %1 and leave it in one piece.");
inline constexpr Text kHoleIsNotch =
    FFF_TEXT("Hint", "The hole reaches beyond the edge of %1 and was cut out of it.");
inline constexpr Text kHolesMerged =
    FFF_TEXT("Hint", "The hole touched others in %1; they are one hole now.");
inline constexpr Text kHolesLeftOut =
    FFF_TEXT("Hint", "Holes of %1 outside its new contour were left out.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is the name of a section
inline constexpr Text kDrawSection = FFF_TEXT("Step", "Draw %1");

} // namespace fff::steps
