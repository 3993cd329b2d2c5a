// The handles to move, turn and scale with, and what dragging one of them comes to.
#pragma once

#include "core/interaction/gizmo.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

namespace fff::ui {

void paintGizmo(MarkPen &pen, const GizmoMarks &marks, LengthUnit unit, const QLocale &locale);

} // namespace fff::ui
