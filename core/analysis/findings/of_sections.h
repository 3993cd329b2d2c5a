// Findings about some of the sections of a model, each with a verdict of its own.
#pragma once

#include "core/base/text.h"

namespace fff {

/// The sentence of these alone: "Rib and Fin: Falls over forwards. …". Whoever has a heading and a
/// text for it may take the names out of the heading.
//: %1 names sections, %2 is a sentence about them such as "Falls over forwards."
inline constexpr Text kOfSections = FFF_TEXT("Checks", "%1: %2");

} // namespace fff
