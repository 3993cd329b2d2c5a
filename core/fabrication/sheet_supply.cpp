#include "core/fabrication/sheet_supply.h"

#include <algorithm>
#include <cmath>

namespace fff {

SheetSupply::SheetSupply(const Stock &stock, const LayoutOptions &options)
    : m_whole{stock.id, options.sheet.value_or(stock.sheet), {}, 0}
{
    if (options.sheet)
        return;
    for (const SpareSheet &spare : stock.spares) {
        Sheet sheet{stock.id, spare.size(), {}, 0};
        if (!rectangleOf(spare)) // it goes with its shape
            sheet.outline = {spare.shape, &spare.shape->region()};
        for (int i = 0; i < spare.count; ++i) {
            sheet.index = -1 - spareCount();
            m_spares.push_back(sheet);
        }
    }
}

Sheet SheetSupply::sheet(int index) const
{
    if (index < 0)
        return m_spares[static_cast<std::size_t>(-1 - index)];
    Sheet sheet = m_whole;
    sheet.index = index;
    return sheet;
}

std::vector<nest::SheetKind> SheetSupply::kinds(int wholes) const
{
    std::vector<nest::SheetKind> kinds;
    for (const Sheet &spare : m_spares)
        kinds.push_back({outlineOf(spare), 1, {}, true});
    for (int i = 0; i <= wholes; ++i)
        kinds.push_back({outlineOf(m_whole), i < wholes ? 1 : nest::SheetKind::kUnlimited});
    return kinds;
}

bool hasRoom(const Stock &stock, const LayoutOptions &options)
{
    const auto isRoom = [&](const Vec2 &size) { return roomOf(size, options).minCoeff() > 0.0; };
    if (options.sheet)
        return isRoom(*options.sheet);
    return isRoom(stock.sheet) ||
           std::any_of(stock.spares.begin(), stock.spares.end(),
                       [&](const SpareSheet &spare) { return isRoom(spare.size()); });
}

Region outlineOf(const Sheet &sheet)
{
    if (sheet.outline)
        return *sheet.outline;
    const Vec2 &size = sheet.size;
    return {{{0.0, 0.0}, {size.x(), 0.0}, size, {0.0, size.y()}}, {}};
}

double areaOf(const Sheet &sheet)
{
    return sheet.outline ? std::abs(area(*sheet.outline)) : sheet.size.x() * sheet.size.y();
}

namespace {

/// Not of a part that fits none.
bool isWholeOf(const Sheet &sheet, const Stock &stock, const Layout &layout)
{
    return sheet.stock == stock.id && sheet.index >= 0 &&
           std::none_of(sheet.placements.begin(), sheet.placements.end(),
                        [&](const Placement &one) {
                            return std::find(layout.oversized.begin(), layout.oversized.end(),
                                             one.part) != layout.oversized.end();
                        });
}

} // namespace

int missingSheets(const Layout &layout, const Stock &stock)
{
    if (!stock.sheetCount)
        return 0;
    const auto taken =
        std::count_if(layout.sheets.begin(), layout.sheets.end(),
                      [&](const Sheet &sheet) { return isWholeOf(sheet, stock, layout); });
    return std::max(0, static_cast<int>(taken) - *stock.sheetCount);
}

std::vector<bool> areMissing(const Layout &layout, const Document &document)
{
    std::vector<bool> missing(layout.sheets.size());
    for (const auto &stock : document.stocks) {
        int left = missingSheets(layout, *stock);
        for (std::size_t i = layout.sheets.size(); i-- > 0 && left > 0;)
            if (isWholeOf(layout.sheets[i], *stock, layout)) {
                missing[i] = true;
                --left;
            }
    }
    return missing;
}

} // namespace fff
