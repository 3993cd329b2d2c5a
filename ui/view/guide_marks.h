// The curves in which the plane that is drawn on cuts templates.
#pragma once

#include "core/interaction/sign.h"
#include "ui/view/mark_pen.h"

namespace fff::ui {

/// Ticks across them every 10 mm, longer ones every 50, from where they are nearest to the canvas'
/// origin on; holes dashed. Where what is drawn is caught, a dot; where it left one or came to it,
/// a square.
void paintGuides(MarkPen &pen, const sign::Guides &guides);

} // namespace fff::ui
