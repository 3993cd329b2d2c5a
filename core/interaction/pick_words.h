// How an operation asks for sections.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

//: %1 is a sentence: "Click the section to repeat."
inline constexpr Text kPickOne = FFF_TEXT("Hint", "%1 <kbd>Esc</kbd> cancels.");
//: %1 is a sentence, %2 a number of sections
inline constexpr Text kPickMore = FFF_TEXT("Hint", "%1 So far: %2. <kbd>Esc</kbd> cancels.");
//: %1 is a sentence, %2 a number of sections
inline constexpr Text kPickMoreOrMake =
    FFF_TEXT("Hint", "%1 So far: %2. <kbd>Enter</kbd> makes it.");
inline constexpr Text kMakeOperation =
    FFF_TEXT("Hint", "<kbd>Enter</kbd> makes it. <kbd>Esc</kbd> cancels.");

} // namespace fff::hints
