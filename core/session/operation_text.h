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
/// A sentence or two: what is missing, or could not be made, and what can be done.
QString noticeText(const OperationNotice &notice, const Operation &operation);
/// Whether it makes nothing because of that.
bool isFailure(const OperationNotice &notice);

} // namespace fff
