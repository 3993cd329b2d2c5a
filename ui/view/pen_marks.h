// The marks of a path that is set point by point: its pieces, points and handles, what the next
// point is drawn to, and its numbers (ui/UI.md, section 10). And the frame of a plane that can be
// moved.
#pragma once

#include "core/interaction/interaction.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

void paintPath(MarkPen &pen, const PenMarks &marks, LengthUnit unit, const QLocale &locale);

void paintPlane(MarkPen &pen, const Overlay::Plane &plane);

} // namespace fff::ui
