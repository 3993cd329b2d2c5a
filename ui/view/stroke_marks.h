// The marks of a single stroke while it is drawn (ui/UI.md, section 3): slit, dead zone, contour,
// its mirrored half, and where its plane meets the ground.
#pragma once

#include "core/interaction/interaction.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

/// isGroundHatched: what is below the ground is hatched already.
void paintStroke(MarkPen &pen, const Overlay &overlay, bool isGroundHatched, LengthUnit unit,
                 const QLocale &locale);

/// What the ground cuts off of what is drawn: the whole contour, dotted.
void paintCutOff(MarkPen &pen, const Contour &contour, const Frame &canvas);
/// Beside it, below the ground, what became of it: away from the cursor (canvas coordinates).
void paintCutChip(MarkPen &pen, const Contour &contour, const Frame &canvas, const Vec2 &cursor);

} // namespace fff::ui
