// What is said of templates: in the history, and while one is moved or sized in the view.
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
inline constexpr Text kTurnTemplate = FFF_TEXT("Step", "Turn template %1");
//: %1 is the name of a template
inline constexpr Text kSizeTemplate = FFF_TEXT("Step", "Scale template %1");
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
//: %1 is the name of a template
inline constexpr Text kMakeNet = FFF_TEXT("Step", "Unfold %1");

} // namespace fff::steps

namespace fff::hints {

//: %1 is the name of a template
inline constexpr Text kTemplateHandles =
    FFF_TEXT("Hint", "Drag an arrow to move %1, a ring to turn it, a box to scale it; or type "
                     "numbers. <kbd>Esc</kbd> hides the handles.");
inline constexpr Text kTemplateMove =
    FFF_TEXT("Hint", "Drag to move; <kbd>Shift</kbd> keeps to one direction.");
inline constexpr Text kTemplateTurn = FFF_TEXT("Hint", "Drag to turn.");
inline constexpr Text kTemplateScale = FFF_TEXT("Hint", "Drag to scale.");
inline constexpr Text kTemplateInHand =
    FFF_TEXT("Hint", "Release to keep it like this. <kbd>Esc</kbd> cancels.");
//: %1 is the name of a template
inline constexpr Text kTemplateLocked = FFF_TEXT("Hint", "%1 is locked.");
//: %1 is the name of a template
inline constexpr Text kTemplateNotMoved =
    FFF_TEXT("Hint", "%1 cannot be moved or scaled that far.");

//: %1 is the name of a template
inline constexpr Text kLineOver =
    FFF_TEXT("Hint", "Drag along something in %1 whose length you know; <kbd>Shift</kbd> keeps "
                     "to eight directions. <kbd>Esc</kbd> ends.");
//: %1 is the name of a template
inline constexpr Text kLineLength =
    FFF_TEXT("Hint", "Type how long that is; <kbd>Enter</kbd> makes %1 that large. "
                     "<kbd>Esc</kbd> clears the line.");

inline constexpr Text kBareEdges = FFF_TEXT_OF_MANY(
    "Hint", "%n edges have no fingers: their sheets meet too flat or too sharply, or are too short "
            "there. Fewer faces help, or slices instead.");
//: %1 is the name of a template
inline constexpr Text kTooSmallForFacets =
    FFF_TEXT("Hint", "No flat piece of %1 is large enough for a section: make it larger first.");
inline constexpr Text kTooManyFacets =
    FFF_TEXT("Hint", "It has more than %1 flat pieces: choose fewer faces.");
//: A sheet. %1 and %2 are lengths
inline constexpr Text kTooThickToFold =
    FFF_TEXT("Hint", "A sheet of %1 does not fold: choose a stock of %2 or less.");
inline constexpr Text kUnfolded = FFF_TEXT_OF_MANY(
    "Hint", "Fold along the scored lines, then join edges with the same number: %n seams.");

} // namespace fff::hints
