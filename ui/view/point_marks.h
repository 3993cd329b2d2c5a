// The control points of the section that is edited: squares for corners, circles for smooth points,
// diamonds for symmetric ones, and the handles of those that are selected (ui/UI.md, section 3).
#pragma once

#include "core/interaction/sign.h"
#include "ui/view/mark_pen.h"

namespace fff::ui {

/// section  as it is shown, which during a drag is not as it is committed
void paintPoints(MarkPen &pen, const Section &section, const sign::Points &points);

} // namespace fff::ui
