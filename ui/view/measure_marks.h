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
void paintMeasure(MarkPen &pen, const Overlay &overlay, LengthUnit unit, const QLocale &locale);
/// Along both axes of the grid, where they are seen, else at the view's edge.
void paintRulers(MarkPen &pen, const Frame &grid, LengthUnit unit, const QLocale &locale);

} // namespace fff::ui
