// What is said of shapes that a stroke was meant to be.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

// On the chip; B is the key that takes it.
inline constexpr Text kOfferCircle = FFF_TEXT("Hint", "B: make it a circle");
inline constexpr Text kOfferEllipse = FFF_TEXT("Hint", "B: make it an ellipse");
inline constexpr Text kOfferStraight = FFF_TEXT("Hint", "B: make its lines straight");
inline constexpr Text kOfferRightAngles = FFF_TEXT("Hint", "B: square the corners");
inline constexpr Text kOfferMoveIn = FFF_TEXT("Hint", "B: move its slit in from the edge");
// When it was taken.
inline constexpr Text kIsCircle = FFF_TEXT("Hint", "Made it a circle.");
inline constexpr Text kIsEllipse = FFF_TEXT("Hint", "Made it an ellipse.");
inline constexpr Text kIsStraight = FFF_TEXT("Hint", "Lines straightened.");
inline constexpr Text kIsSquare = FFF_TEXT("Hint", "Corners squared.");
inline constexpr Text kWasMovedIn = FFF_TEXT("Hint", "Moved in from the edge.");
// While it is drawn.
inline constexpr Text kOneWall = FFF_TEXT("Cue", "Too near the edge: the slit would hold nothing");
inline constexpr Text kOneWallOffer =
    FFF_TEXT("Cue", "Too near the edge: the slit would hold nothing. B: move it in");
//: %1 is a length
inline constexpr Text kIsMovedIn = FFF_TEXT("Cue", "Moved in by %1. B: put it back");
//: %1 and %2 are names of sections
inline constexpr Text kNotMovedIn =
    FFF_TEXT("Hint", "%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across "
                     "the edge, not along it.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is the name of a section
inline constexpr Text kMakeCircle = FFF_TEXT("Step", "Make %1 a circle");
//: %1 is the name of a section
inline constexpr Text kMakeEllipse = FFF_TEXT("Step", "Make %1 an ellipse");
//: %1 is the name of a section
inline constexpr Text kRoundHole = FFF_TEXT("Step", "Make the hole in %1 a circle");
//: %1 is the name of a section
inline constexpr Text kOvalHole = FFF_TEXT("Step", "Make the hole in %1 an ellipse");
//: %1 is the name of a section
inline constexpr Text kStraightenLines = FFF_TEXT("Step", "Straighten lines of %1");
//: %1 is the name of a section
inline constexpr Text kMakeRightAngles = FFF_TEXT("Step", "Make corners of %1 right angles");
//: %1 is the name of a section
inline constexpr Text kMoveIn = FFF_TEXT("Step", "Move %1 in from the edge");

} // namespace fff::steps
