// The signs of a single stroke while it is drawn (ui/UI.md, section 3): slit, contour, its mirrored
// half, and where its plane meets the ground.
#pragma once

#include "core/interaction/sign.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

/// isHatched: what is below the ground is hatched already.
/// Where it is, when it lies below what is seen: legs are drawn towards it.
void paintGround(MarkPen &pen, const sign::Ground &ground, bool isHatched, LengthUnit unit,
                 const QLocale &locale);
/// All but its end. isSlitAxis: what it is mirrored across is its slit.
void paintContour(MarkPen &pen, const sign::Stroke &stroke, bool isSlitAxis);
/// Where the cursor is, and how large it is so far.
void paintEnd(MarkPen &pen, const sign::Stroke &stroke, LengthUnit unit, const QLocale &locale);
void paintSlit(MarkPen &pen, const sign::Slit &slit, LengthUnit unit, const QLocale &locale);

/// What the ground cuts off of what is drawn: the whole contour, dotted.
void paintCutOff(MarkPen &pen, const Contour &contour, const Frame &canvas);
/// Beside it, below the ground, what became of it: away from the cursor (canvas coordinates).
void paintCutChip(MarkPen &pen, const Contour &contour, const Frame &canvas, const Vec2 &cursor);

} // namespace fff::ui
