// Lengths over the view: dimensions that stay, the line that is measured, and the rulers of the
// canvas that is drawn on.
#pragma once

#include "core/interaction/interaction.h"
#include "ui/view/length_unit.h"
#include "ui/view/mark_pen.h"

#include <vector>

namespace fff::ui {

struct DimensionMark
{
    Vec3 from, to; // world, mm
    bool isLit = false;
};

/// Those of the model whose ends are there.
std::vector<DimensionMark> dimensionMarks(const Model &model, DimensionId lit);

void paintDimensions(MarkPen &pen, const std::vector<DimensionMark> &marks, LengthUnit unit,
                     const QLocale &locale);
/// The outline of a figure that is dragged; broken where it could not be.
void paintFigure(MarkPen &pen, const Overlay::FigureLine &figure);
void paintMeasure(MarkPen &pen, const Overlay &overlay, LengthUnit unit, const QLocale &locale);
/// The level one along the ground, where that is seen, else at the lower edge; the upright one at
/// the left edge, where it is in nobody's way.
void paintRulers(MarkPen &pen, const Frame &grid, LengthUnit unit, const QLocale &locale);

} // namespace fff::ui
