// What is said of control points that are edited.
#pragma once

#include "core/model/step.h"

namespace fff::hints {

inline constexpr Text kWouldCrossItself =
    FFF_TEXT("Hint", "The contour would cross itself here; it stays as it was just before.");
inline constexpr Text kWouldMeetHole = FFF_TEXT(
    "Hint", "A hole would touch the edge or another hole here; it stays as it was just before.");
inline constexpr Text kWouldBeBelowGround =
    FFF_TEXT("Hint", "All of %1 would be cut off at the ground here; it stays as it was.");
inline constexpr Text kTooFewPoints =
    FFF_TEXT("Hint", "Nothing deleted: a contour needs at least two points.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is the name of a section
inline constexpr CountedText kMovePoints{FFF_TEXT("Step", "Move point of %1"),
                                         FFF_TEXT_OF_MANY("Step", "Move %n points of %1")};
//: %1 is the name of a section
inline constexpr CountedText kChangePoints{FFF_TEXT("Step", "Change point of %1"),
                                           FFF_TEXT_OF_MANY("Step", "Change %n points of %1")};

} // namespace fff::steps
