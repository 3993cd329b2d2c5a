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
//: %1 and %2 are the names of templates
inline constexpr Text kAlignTemplates = FFF_TEXT("Step", "Align %1 and %2");
//: %1 is the name of a template
inline constexpr Text kHideTemplate = FFF_TEXT("Step", "Hide template %1");
//: %1 is the name of a template
inline constexpr Text kShowTemplate = FFF_TEXT("Step", "Show template %1");
//: %1 is the name of a template
inline constexpr Text kSuggestSections = FFF_TEXT_OF_MANY("Step", "Suggest %n sections for %1");

//: %1 is the name of a template
inline constexpr Text kMakeFacets = FFF_TEXT("Step", "Make facets of %1");

} // namespace fff::steps

namespace fff::hints {

inline constexpr Text kBareEdges = FFF_TEXT_OF_MANY(
    "Hint", "%n edges have no fingers: their sheets meet too flat or too sharply, or are too short "
            "there.");
//: %1 is the name of a template
inline constexpr Text kTooSmallForFacets =
    FFF_TEXT("Hint", "No flat piece of %1 is large enough for a section: make it larger first.");
inline constexpr Text kTooManyFacets =
    FFF_TEXT("Hint", "It has more than %1 flat pieces: choose fewer faces.");

} // namespace fff::hints
