// What edits of several kinds are refused with, what the history says of them, and what becomes of
// shapes in them.
#pragma once

#include "core/model/step.h"

namespace fff::hints {

inline constexpr Text kEditFailed = FFF_TEXT("Hint", "Nothing changed: this cannot be done here.");
inline constexpr Text kLocked =
    FFF_TEXT("Hint", "%1 is locked. Unlock it in the Outline to change it.");
inline constexpr Text kMadeByOperation =
    FFF_TEXT("Hint", "%1 is made by %2: edit its source, or detach this one.");
inline constexpr Text kWouldBeEmpty =
    FFF_TEXT("Hint", "Nothing would be left of %1; it stays as it was.");
inline constexpr Text kCutAtGround = FFF_TEXT("Hint", "%1 was cut flat at the ground.");
inline constexpr Text kLargestPiece = FFF_TEXT(
    "Hint", "%1 fell apart when it was cut flat at the ground; the largest piece was kept.");

} // namespace fff::hints

namespace fff::steps {

//: %1 is the name of a section or an operation
inline constexpr Text kRename = FFF_TEXT("Step", "Rename %1");
//: %1 is the name of a section
inline constexpr CountedText kDeleteSections{FFF_TEXT("Step", "Delete %1"),
                                             FFF_TEXT_OF_MANY("Step", "Delete %n sections")};

} // namespace fff::steps
