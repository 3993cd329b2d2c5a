// What is said while loads are put on sections.
#pragma once

#include "core/model/hint.h"
#include "core/model/step.h"

namespace fff::hints {

inline constexpr Text kHangWeight =
    FFF_TEXT("Hint", "Click a place on a section to put %1 there. <kbd>Esc</kbd> ends.");
inline constexpr Text kPutPush = FFF_TEXT(
    "Hint", "Press on a section and drag in the direction of the push. <kbd>Esc</kbd> ends.");
inline constexpr Text kPull = FFF_TEXT(
    "Hint", "Press on a section and drag to pull it and see what happens; nothing is kept.");
inline constexpr Text kPulling = FFF_TEXT("Hint", "Release to let it go: nothing is kept.");
inline constexpr Text kMoveLoad = FFF_TEXT("Hint", "Drag to move it. <b>Click</b> selects it.");
inline constexpr Text kTurnPush =
    FFF_TEXT("Hint", "Drag the tip to turn the push; a longer arrow pushes harder.");
inline constexpr Text kMovingWeight =
    FFF_TEXT("Hint", "Release to put the weight here. <kbd>Esc</kbd> puts it back.");
inline constexpr Text kMovingPush =
    FFF_TEXT("Hint", "Release to push here. <kbd>Esc</kbd> puts it back.");
inline constexpr Text kNoPlaceForWeight = FFF_TEXT("Hint", "No weight added: click on a section.");
inline constexpr Text kNoPlaceForPush = FFF_TEXT("Hint", "No push added: press on a section.");
//: %1 is the name of a section
inline constexpr CountedText kCarriedByCopies{
    FFF_TEXT("Hint", "The copy of %1 carries it too; <i>Properties</i> can keep it to this one."),
    FFF_TEXT_OF_MANY("Hint",
                     "%n copies of %1 carry it too; <i>Properties</i> can keep it to this one.")};
//: %1 is the name of a section
inline constexpr Text kWeightBeside =
    FFF_TEXT("Hint", "The weight stays where it is: there it would be off %1.");
//: %1 is the name of a section
inline constexpr Text kPushBeside =
    FFF_TEXT("Hint", "The push stays where it is: there it would be off %1.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is a mass, %2 the name of a section
inline constexpr Text kAddWeight = FFF_TEXT("Step", "Put %1 on %2");
//: %1 is the name of a section
inline constexpr Text kMoveWeight = FFF_TEXT("Step", "Move the weight on %1");
//: %1 is a mass
inline constexpr Text kSetWeight = FFF_TEXT("Step", "Set weight to %1");
//: %1 is a name
inline constexpr Text kNameWeight = FFF_TEXT("Step", "Rename weight to %1");
inline constexpr Text kRemoveWeight = FFF_TEXT("Step", "Remove weight");
//: %1 is the name of a section
inline constexpr Text kAddPush = FFF_TEXT("Step", "Push %1");
//: %1 is the name of a section
inline constexpr Text kMovePush = FFF_TEXT("Step", "Move the push on %1");
//: %1 is the name of a section
inline constexpr Text kTurnPush = FFF_TEXT("Step", "Turn the push on %1");
//: %1 is a force
inline constexpr Text kSetPush = FFF_TEXT("Step", "Set push to %1");
//: %1 is a name
inline constexpr Text kNamePush = FFF_TEXT("Step", "Rename push to %1");
inline constexpr Text kRemovePush = FFF_TEXT("Step", "Remove push");
//: %1 is the name of a section
inline constexpr Text kSpreadLoad = FFF_TEXT("Step", "Spread the load on %1");
//: %1 is the name of a section
inline constexpr Text kRepeatLoad = FFF_TEXT("Step", "Load the copies of %1 too");
//: %1 is the name of a section
inline constexpr Text kLoadAlone = FFF_TEXT("Step", "Keep the load off the copies of %1");

} // namespace fff::steps
