// Why a joint cannot be had.
#pragma once

#include "core/base/text.h"

namespace fff::hints {

inline constexpr Text kNoMeetingPoint = FFF_TEXT(
    "Hint", "Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.");
inline constexpr Text kJointCannotBe =
    FFF_TEXT("Hint", "Nothing changed: %1 and %2 cannot be joined like that.");
inline constexpr Text kJointCannotFlip =
    FFF_TEXT("Hint", "Nothing flipped: the slits of %1 and %2 cannot open to the other side.");
inline constexpr Text kCannotTrim =
    FFF_TEXT("Hint", "Nothing trimmed: %1 is not in %2, or nothing of it would remain.");

} // namespace fff::hints

namespace fff::steps {

//: %1 and %2 are the names of two sections
inline constexpr Text kTrimSection = FFF_TEXT("Step", "Trim %1 to %2");

} // namespace fff::steps
