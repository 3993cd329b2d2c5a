// What is said of edits of whole sections.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kHeldByParent =
    FFF_TEXT("Hint", "%1 keeps its angle to %2. Free it to turn it as you like.");
inline constexpr Text kOnNothing =
    FFF_TEXT("Hint", "%1 is not on another section, so it has no angle to one.");
inline constexpr Text kCannotBeOn = FFF_TEXT("Hint", "%1 cannot be on %2, which is on it.");
inline constexpr Text kDoNotMeet =
    FFF_TEXT("Hint", "%1 and %2 do not meet: move one of them across the other first.");
inline constexpr Text kPickParent =
    FFF_TEXT("Hint", "Click the section to put %1 on. <kbd>Esc</kbd> cancels.");

} // namespace fff::hints
