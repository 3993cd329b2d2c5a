// What is said of a drawing that came from a file.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kDrawingOpen = FFF_TEXT(
    "Hint", "Nothing imported: no line in %1 forms a closed outline. They can be engraved.");
inline constexpr Text kDrawingLeft =
    FFF_TEXT_OF_MANY("Hint", "%n outlines of %1 did not fit and were left out.");
// What of it was left out, and what was read.
//: %1 is a file, %2 "3 texts", %3 "5 lines were read"
inline constexpr Text kDrawingRead = FFF_TEXT("Hint", "%1: %2 skipped; %3.");
//: %1 is a file, %2 "3 texts", %3 "1 picture", %4 "5 lines were read"
inline constexpr Text kDrawingReadOfBoth = FFF_TEXT("Hint", "%1: %2 and %3 skipped; %4.");
inline constexpr Text kSkippedTexts = FFF_TEXT_OF_MANY("Hint", "%n texts");
inline constexpr Text kSkippedPictures = FFF_TEXT_OF_MANY("Hint", "%n pictures");
inline constexpr Text kLinesRead = FFF_TEXT_OF_MANY("Hint", "%n lines were read");

//: %1 is a section, %2 the name of a template
inline constexpr Text kDrawingAslant =
    FFF_TEXT("Hint", "%2 lies aslant to %1: move it to the plane of %1 first.");
//: %1 is the name of a template
inline constexpr Text kTooManyOutlines = FFF_TEXT_OF_MANY(
    "Hint", "%1 has %n outlines, which is too many: trace it coarser, or smooth it first.");
//: %1 is the name of a template
inline constexpr Text kNothingTraced =
    FFF_TEXT("Hint", "Nothing traced: no part of %1 is on that side of the threshold.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is the name of a file
inline constexpr Text kImportDrawing = FFF_TEXT("Step", "Import %1");
//: %1 is the name of a template
inline constexpr Text kTraceTemplate = FFF_TEXT("Step", "Trace %1");

} // namespace fff::steps
