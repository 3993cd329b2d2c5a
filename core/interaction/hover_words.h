// What is said of what is under the cursor.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kDrawFirstSection =
    FFF_TEXT("Hint", "Draw the first section: press, draw its shape in one go, release.");
inline constexpr Text kTurnView =
    FFF_TEXT("Hint", "Drag to turn the view; <kbd>Shift</kbd> drag selects a group.");
inline constexpr Text kDragOutOfSection =
    FFF_TEXT("Hint", "Drag out of %1 to draw a section across it; click to select it.");
inline constexpr Text kSeenOnEdge = FFF_TEXT(
    "Hint", "Click to select %1. Drag to turn the view: you can't draw on a section seen edge-on.");
inline constexpr Text kMoveCut =
    FFF_TEXT("Hint", "Drag to move the cut through the model; <kbd>Esc</kbd> closes it.");
inline constexpr Text kChooseProblem = FFF_TEXT("Hint", "Click to select problem %1.");
inline constexpr Text kMovePoint = FFF_TEXT(
    "Hint", "Drag to move the point; <kbd>Ctrl</kbd> makes a corner, arrow keys move 1\u202fmm.");
inline constexpr Text kMoveHandle =
    FFF_TEXT("Hint", "Drag to bend the curve; <kbd>Ctrl</kbd> makes a corner, <kbd>Shift</kbd> "
                     "keeps the direction.");
inline constexpr Text kAddPoint =
    FFF_TEXT("Hint", "Double-click to add a point here; drag to bend the contour.");
inline constexpr Text kSelectJoint = FFF_TEXT("Hint", "Click to select the joint of %1 and %2.");
inline constexpr Text kMoveMeetingPoint = FFF_TEXT(
    "Hint",
    "Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.");
inline constexpr Text kMoveSelectedMeetingPoint = FFF_TEXT(
    "Hint",
    "Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1\u202fmm.");
inline constexpr Text kSelectWeight =
    FFF_TEXT("Hint", "Drag to move the weight of %1 on %2; click to select it.");
inline constexpr Text kMoveSelectedWeight =
    FFF_TEXT("Hint", "Arrow keys move the weight of %1 on %2 by 1\u202fmm; <kbd>+</kbd> and "
                     "<kbd>\u2212</kbd> change it, <kbd>Del</kbd> removes it.");
inline constexpr Text kSelectPush =
    FFF_TEXT("Hint", "Drag to move the push of %1 on %2, its tip to turn it; click to select it.");
inline constexpr Text kMoveSelectedPush =
    FFF_TEXT("Hint", "Arrow keys move the push of %1 on %2 by 1\u202fmm; <kbd>+</kbd> and "
                     "<kbd>\u2212</kbd> change it, <kbd>Del</kbd> removes it.");
inline constexpr Text kSelectOperation =
    FFF_TEXT("Hint", "%1 is made by %2: click to edit them all, click again for this one.");
inline constexpr Text kSelectInstance =
    FFF_TEXT("Hint", "Click to select %1 alone; drag out of it to draw a section across it.");
inline constexpr Text kMoveRange = FFF_TEXT(
    "Hint",
    "Drag a round handle to move the start or the end of %1; click one section to select it.");
inline constexpr Text kMoveBeginning =
    FFF_TEXT("Hint", "Drag to move the start of %1; click to type it.");
inline constexpr Text kMoveEnd = FFF_TEXT("Hint", "Drag to move the end of %1; click to type it.");

} // namespace fff::hints
