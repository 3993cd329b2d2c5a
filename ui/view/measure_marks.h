// Lengths over the view: dimensions that stay, and the rulers of the canvas that is drawn on.
#pragma once

#include "core/interaction/overlay.h"
#include "core/interaction/view_state.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

namespace fff::ui {

/// Those of the model whose ends are there.
Signs dimensionSigns(const Model &model, DimensionId lit);

/// Weights whose sections are seen, with their names and masses; what is hovered or selected is
/// lit.
Signs loadSigns(const Model &model, const ViewState &view, LoadId hovered, LoadId selected);

/// While the hand is busy the words of what it does not hold are only in the way.
void dropWordsOfOthers(Signs &signs, bool keepsLoads);

/// The level one along the ground, where that is seen, else at the lower edge; the upright one at
/// the left edge, where it is in nobody's way.
void paintRulers(MarkPen &pen, const Frame &grid, LengthUnit unit, const QLocale &locale);

} // namespace fff::ui
