#include "ui/sheets/placed_sheets.h"

#include <algorithm>
#include <limits>

namespace fff::ui {

namespace {

constexpr std::size_t kFitting = 2; // sheets of a row, what is too large not counted

struct SheetRow
{
    StockId stock;
    std::vector<std::size_t> tooLarge, sheets;

    std::vector<std::size_t> inOrder() const
    {
        std::vector<std::size_t> all = tooLarge;
        all.insert(all.end(), sheets.begin(), sheets.end());
        return all;
    }
};

std::vector<SheetRow> rowsOf(const std::vector<SheetPaths> &sheets,
                             const std::vector<bool> &areTooLarge)
{
    std::vector<SheetRow> rows;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        auto row = std::find_if(rows.begin(), rows.end(), [&](const SheetRow &known) {
            return known.stock == sheets[i].stock;
        });
        if (row == rows.end())
            row = rows.insert(rows.end(), SheetRow{sheets[i].stock, {}, {}});
        (areTooLarge[i] ? row->tooLarge : row->sheets).push_back(i);
    }
    return rows;
}

/// px a mm, so that the first ones fit the room and the row is no higher than that.
double scaleOf(const SheetRow &row, const std::vector<SheetPaths> &sheets, const QSizeF &room)
{
    double width = 0.0, height = 0.0;
    const std::vector<std::size_t> all = row.inOrder();
    const std::size_t count = std::min(all.size(), row.tooLarge.size() + kFitting);
    for (std::size_t i = 0; i < all.size(); ++i) {
        height = std::max(height, sheets[all[i]].size.height());
        if (i < count)
            width += sheets[all[i]].size.width();
    }
    const double gaps = kSheetGap * static_cast<double>(count - 1);
    const double scale = std::min((room.width() - gaps) / std::max(width, 1.0),
                                  room.height() / std::max(height, 1.0));
    return std::max(scale, 0.0);
}

} // namespace

PlacedSheets placeSheets(const std::vector<SheetPaths> &sheets,
                         const std::vector<bool> &areTooLarge, const QSizeF &room)
{
    const std::vector<SheetRow> rows = rowsOf(sheets, areTooLarge);
    PlacedSheets placed;
    if (rows.empty())
        return placed;
    const auto count = static_cast<double>(rows.size());
    const double height =
        (room.height() - kSheetGap * (count - 1.0)) / count - kSheetCaption; // of a row's sheets
    double scale = std::numeric_limits<double>::infinity(); // one for all: sizes can be compared
    for (const SheetRow &row : rows)
        scale = std::min(scale, scaleOf(row, sheets, {room.width(), height}));
    double top = 0.0;
    for (const SheetRow &row : rows) {
        double left = 0.0, highest = 0.0;
        int number = 0;
        for (const std::size_t index : row.inOrder()) {
            PlacedSheet one{index,
                            QRectF(QPointF(left, top + kSheetCaption), scale * sheets[index].size),
                            areTooLarge[index], 0, static_cast<int>(row.sheets.size())};
            if (!one.isTooLarge)
                one.number = ++number;
            left = one.rect.right() + kSheetGap;
            highest = std::max(highest, one.rect.height());
            placed.size.setWidth(std::max(placed.size.width(), one.rect.right()));
            placed.all.push_back(one);
        }
        top += kSheetCaption + highest + kSheetGap;
    }
    placed.size.setHeight(top - kSheetGap);
    placed.rowHeight = height + kSheetCaption;
    return placed;
}

} // namespace fff::ui
