// What is said of sections that pull templates.
#pragma once

#include "core/model/step.h"

namespace fff::hints {

inline constexpr Text kMoveMagnet = FFF_TEXT("Hint", "Drag to set how far %1 pulls templates.");
//: %1 is the name of a section, %2 a length
inline constexpr Text kMovingMagnet =
    FFF_TEXT("Hint", "Release to let %1 pull templates from %2. <kbd>Esc</kbd> cancels.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is the name of a section
inline constexpr CountedText kPullTemplates{
    FFF_TEXT("Step", "Pull templates to %1"),
    FFF_TEXT_OF_MANY("Step", "Pull templates to %n sections")};
//: %1 is the name of a section
inline constexpr CountedText kReleaseTemplates{FFF_TEXT("Step", "Release templates from %1"),
                                               FFF_TEXT_OF_MANY("Step", "Release templates from %n "
                                                                        "sections")};

} // namespace fff::steps
