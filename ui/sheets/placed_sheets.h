// Where sheets stand side by side, as large as they fit: one row of them for each stock, parts that
// fit no sheet at its left.
#pragma once

#include "ui/dialogs/sheet_paths.h"

#include <QRectF>
#include <QSizeF>

#include <cstddef>
#include <vector>

namespace fff::ui {

struct PlacedSheet
{
    std::size_t sheet = 0; // index
    QRectF rect;           // px, from the room's upper left corner
    bool isTooLarge = false;
    int number = 0, of = 0; // of its stock's sheets, from 1 on; 0 for what is too large
};

struct PlacedSheets
{
    std::vector<PlacedSheet> all;
    QSizeF size;            // of all of it, px: wider than the room where there are many
    double rowHeight = 0.0; // px, with the caption
};

inline constexpr double kSheetCaption = 20.0, kSheetGap = 14.0; // px, above and between sheets

/// areTooLarge  of each sheet; room: px. The first two of each row fit, all of the others follow at
/// the right.
PlacedSheets placeSheets(const std::vector<SheetPaths> &sheets,
                         const std::vector<bool> &areTooLarge, const QSizeF &room);

} // namespace fff::ui
