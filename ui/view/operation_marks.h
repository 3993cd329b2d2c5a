// The track of the selected operation and the handles on it (ui/UI.md, section 3).
#pragma once

#include "core/interaction/operation_handles.h"
#include "core/operations/operation_kind.h"
#include "ui/view/mark_pen.h"

namespace fff::ui {

void paintOperation(MarkPen &pen, const OperationMarks &marks, const OperationKind &kind);

} // namespace fff::ui
