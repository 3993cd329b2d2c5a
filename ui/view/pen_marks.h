// The marks of a path that is set point by point: its pieces, points and handles, what the next
// point is drawn to, and its numbers (ui/UI.md, section 10).
#pragma once

#include "core/interaction/pen_marks.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

void paintPath(MarkPen &pen, const PenMarks &marks, LengthUnit unit, const QLocale &locale);

} // namespace fff::ui
