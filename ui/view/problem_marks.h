// Draws who blocks whom, how the centre of mass lies over the feet, and feet that hang in the air.
#pragma once

#include "core/analysis/problem_look.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

/// Over the model: on what is before them, too. Of a link a dashed line between the two sections
/// and, where they meet, an arrow both ways they would have to slide, each against a bar. What lies
/// behind the eye is left out.
void paintProblems(MarkPen &pen, const ProblemLook &look, LengthUnit unit, const QLocale &locale);

} // namespace fff::ui
