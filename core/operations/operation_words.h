// What is said of operations that are edited, and of their values.
#pragma once

#include "core/base/message.h"
#include "core/model/step.h"
#include "core/operations/operation_kind.h"

namespace fff::steps {

//: %1 is the name of an operation
inline constexpr Text kAddOperation = FFF_TEXT("Step", "Add %1");
//: %1 is the name of an operation
inline constexpr Text kMoveOperation = FFF_TEXT("Step", "Change the order of %1");
//: %1 is the name of a section that an operation made
inline constexpr CountedText kHideInstance{FFF_TEXT("Step", "Leave out %1"),
                                           FFF_TEXT_OF_MANY("Step", "Leave out %n sections")};
inline constexpr Text kShowInstance = FFF_TEXT("Step", "Bring a left-out section back");

/// "Back plates: Count 9 → 13", "Back plates: Along → Body": one parameter or one input of an
/// operation became another; it was `before` and is `after`, none where that follows from the
/// inputs.
Step changed(const Operation &operation, const std::string &key,
             const std::optional<ParameterValue> &before,
             const std::optional<ParameterValue> &after);
/// Of more than one.
Step changed(const Operation &operation);

} // namespace fff::steps

namespace fff {

/// A text of a kind: "Linear", "Repeat by", "Click the section to repeat."
inline Text operationWord(const char *text)
{
    return {"Operation", text};
}
/// "13", "12.7 mm", "73.5 %", "Both", "on"; of one that follows from the inputs "automatic".
Argument valueWords(const ParameterSpec &spec, const std::optional<ParameterValue> &value);

} // namespace fff
