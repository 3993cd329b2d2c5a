// What the history says of templates.
#pragma once

#include "core/base/text.h"

namespace fff::steps {

//: %1 is the name of a template
inline constexpr Text kAddTemplate = FFF_TEXT("Step", "Add template %1");
//: %1 is the name of a template
inline constexpr Text kRemoveTemplate = FFF_TEXT("Step", "Remove template %1");
//: %1 is the name of a template
inline constexpr Text kChangeTemplate = FFF_TEXT("Step", "Change template %1");
//: %1 is the name of a template
inline constexpr Text kMoveTemplate = FFF_TEXT("Step", "Move template %1");
//: %1 is the name of a template
inline constexpr Text kHideTemplate = FFF_TEXT("Step", "Hide template %1");
//: %1 is the name of a template
inline constexpr Text kShowTemplate = FFF_TEXT("Step", "Show template %1");

} // namespace fff::steps
