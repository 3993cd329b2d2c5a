// What is said while a stroke goes, and when it is over.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kLeaveSection =
    FFF_TEXT("Hint", "Drag on to leave %1; the slit ends at its edge. <kbd>Esc</kbd> cancels.");
inline constexpr Text kLeaveGuided =
    FFF_TEXT("Hint", "Drag on to leave %1. <kbd>Ctrl</kbd> leaves the slit as you draw it. "
                     "<kbd>Esc</kbd> cancels.");
inline constexpr Text kTurning =
    FFF_TEXT("Hint", "The view is turning: draw on at once, or wait until it stops.");
inline constexpr Text kLeaveDeadZone =
    FFF_TEXT("Hint", "Draw the outline: leave the grey zone where it should start. Release here to "
                     "cancel.");
inline constexpr Text kDrawContour =
    FFF_TEXT("Hint", "Draw the contour, release to close it. <kbd>Esc</kbd> cancels.");
inline constexpr Text kReleaseToMake =
    FFF_TEXT("Hint", "<b>Release</b> to make the section. <kbd>Esc</kbd> cancels.");
inline constexpr Text kReleaseToCutHole =
    FFF_TEXT("Hint", "<b>Release</b> to cut the hole into %1. <kbd>Esc</kbd> cancels.");
inline constexpr Text kReleaseToRedraw =
    FFF_TEXT("Hint", "<b>Release</b> to give %1 this contour. <kbd>Esc</kbd> keeps the old one.");
// Mirrored across the slit, while Shift is held, of a section that is drawn anew, across the
// vertical.
inline constexpr Text kReleaseToMirror =
    FFF_TEXT("Hint", "<b>Release</b> to make the section, mirrored across the slit. Hold "
                     "<kbd>Shift</kbd> to keep only this side. <kbd>Esc</kbd> cancels.");
inline constexpr Text kReleaseToMirrorByShift =
    FFF_TEXT("Hint", "<b>Release</b> to make the section, mirrored. Let <kbd>Shift</kbd> go to "
                     "keep only this side. <kbd>Esc</kbd> cancels.");
inline constexpr Text kReleaseToRedrawMirrored =
    FFF_TEXT("Hint", "<b>Release</b> to give %1 this contour, mirrored across its slit. "
                     "<kbd>Shift</kbd> does the opposite.");
inline constexpr Text kReleaseToMirrorFirst =
    FFF_TEXT("Hint", "<b>Release</b> to make the section, mirrored across the vertical. Hold "
                     "<kbd>Shift</kbd> to keep only this side.");
// Beside the cursor, while the view turns and when it has turned.
inline constexpr Text kTurningNow = FFF_TEXT("Cue", "Turning…");
inline constexpr Text kDrawOutline = FFF_TEXT("Cue", "Draw the outline");
// Where it may follow a template.
//: %1 is the name of a template
inline constexpr Text kFollowGuide =
    FFF_TEXT("Hint", "Follow the teal curve to snap to %1; hold <kbd>Ctrl</kbd> to leave it. "
                     "<kbd>Shift+Enter</kbd> takes it whole.");
inline constexpr Text kTakeGuide = FFF_TEXT("Hint", "Shift+Enter: take the whole guide");
inline constexpr Text kNoGuideAtSlit =
    FFF_TEXT("Hint", "The slit does not touch a guide, so there is none to take whole.");
// When it is over.
inline constexpr Text kNeverLeft =
    FFF_TEXT("Hint", "Nothing drawn: the slit never left %1. Start inside and drag across its "
                     "edge; <kbd>O</kbd> draws holes, <kbd>E</kbd> engraves.");
inline constexpr Text kTooShort =
    FFF_TEXT("Hint", "Nothing drawn: the line is too short to enclose anything.");
//: %1 is a length
inline constexpr Text kTwitch =
    FFF_TEXT("Hint", "Nothing drawn: a line of less than %1 is taken for a slip of the hand, "
                     "unless it closes a loop.");
inline constexpr Text kNoArea =
    FFF_TEXT("Hint", "Nothing drawn: the line goes there and back and encloses nothing.");
inline constexpr Text kCrossesWithoutLoop =
    FFF_TEXT("Hint", "Nothing drawn: the line crosses itself, and no loop of it is large enough.");
inline constexpr Text kHalvesDoNotMeet =
    FFF_TEXT("Hint", "%1 was not mirrored: the two halves would not meet.");
inline constexpr Text kCrossesItself =
    FFF_TEXT("Hint", "The contour crosses itself; the largest loop was kept.");
inline constexpr Text kCutAtAxis =
    FFF_TEXT("Hint", "%1 was mirrored; what crossed its axis and came back was left out.");
//: beside the cursor, while a contour does not reach its slit
inline constexpr Text kNotJoinedYet = FFF_TEXT("Cue", "Not joined yet");
//: %2 is the section that the slit is in
inline constexpr Text kNotJoined =
    FFF_TEXT("Hint", "%1 does not reach its slit: nothing joins it to %2.");
inline constexpr Text kHasNeckAndIsCut = FFF_TEXT(
    "Hint", "%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.");
inline constexpr Text kHasNeck =
    FFF_TEXT("Hint", "%1 was drawn beside its slit and was given a neck that reaches into it.");

} // namespace fff::hints
