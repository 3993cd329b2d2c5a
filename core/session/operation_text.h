// What people read of operations, in the language of the program.
#pragma once

#include "core/model/evaluation.h"
#include "core/operations/operation_kind.h"

#include <QString>

namespace fff {

/// "Linear", "Repeat by", "Click the section to repeat.": a text of a kind.
QString operationText(const char *text);
/// "Linear" of an operation's kind.
QString kindName(const Operation &operation);
/// "13", "12.7 mm", "73.5 %", "Both", "on"; of one that follows from the inputs "automatic".
QString valueText(const ParameterSpec &spec, const std::optional<ParameterValue> &value);
/// A sentence or two: what is missing, or could not be made, and what can be done.
QString noticeText(const OperationNotice &notice, const Operation &operation);
/// How many sections it makes; of one that makes none, how many it makes other ones of.
int countOf(const OperationResult &result);
/// Whether it makes nothing because of that.
bool isFailure(const OperationNotice &notice);

} // namespace fff
