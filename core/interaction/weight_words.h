// What is said while weights are put on sections.
#pragma once

#include "core/model/hint.h"
#include "core/model/step.h"

namespace fff::hints {

inline constexpr Text kHangWeight =
    FFF_TEXT("Hint", "Click a place on a section to hang %1 there. <kbd>Esc</kbd> ends.");
inline constexpr Text kMoveWeight =
    FFF_TEXT("Hint", "Drag to move the weight; its mass is under <b>Physics</b>.");
inline constexpr Text kNoPlaceForWeight =
    FFF_TEXT("Hint", "Nothing hung there: click on a section.");
//: %1 is the name of a section
inline constexpr Text kWeightBeside =
    FFF_TEXT("Hint", "The weight stays where it hangs: there it would be beside %1.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is a mass, %2 the name of a section
inline constexpr Text kAddWeight = FFF_TEXT("Step", "Hang %1 on %2");
//: %1 is the name of a section
inline constexpr Text kMoveWeight = FFF_TEXT("Step", "Move the weight on %1");
//: %1 is a mass
inline constexpr Text kSetWeight = FFF_TEXT("Step", "Set a weight to %1");
//: %1 is a name
inline constexpr Text kNameWeight = FFF_TEXT("Step", "Call a weight %1");
inline constexpr Text kRemoveWeight = FFF_TEXT("Step", "Remove a weight");

} // namespace fff::steps
