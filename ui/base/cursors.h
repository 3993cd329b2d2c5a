// Cursor shapes of the view: the cursor says what a press will do.
#pragma once

#include "core/interaction/interaction.h"

#include <QCursor>

namespace fff::ui {

/// Made once for each shape and pixel ratio.
QCursor cursorFor(Cursor cursor, double pixelRatio);

} // namespace fff::ui
