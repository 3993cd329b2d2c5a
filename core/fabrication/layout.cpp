#include "core/fabrication/layout.h"

#include <algorithm>
#include <numeric>

namespace fff {

namespace {

/// A part's box, lying on its longer side where that fits the sheet.
struct Item
{
    int part = 0;
    Box2 box; // of the part as it is
    bool quarterTurn = false;

    Vec2 size() const { return turned(quarterTurn); }
    Vec2 turned(bool isTurned) const
    {
        const Vec2 s = box.size();
        return isTurned ? Vec2(s.y(), s.x()) : s;
    }
};

struct Shelf
{
    std::size_t sheet = 0;
    double bottom = 0.0, height = 0.0;
    double right = 0.0; // where the next part may begin
};

Placement placed(const Item &item, bool quarterTurn, const Vec2 &lowerLeft)
{
    // The lower left corner of the turned box: the turn takes (x, y) to (-y, x).
    const Vec2 corner = quarterTurn ? Vec2(-item.box.max.y(), item.box.min.x()) : item.box.min;
    return {item.part, quarterTurn, lowerLeft - corner};
}

/// Packs the parts of one stock onto sheets of one size.
class ShelfPacking
{
public:
    ShelfPacking(const Vec2 &sheet, StockId stock, const LayoutOptions &options)
        : m_size(sheet), m_stock(stock), m_options(options),
          m_room(sheet - Vec2::Constant(2.0 * options.margin))
    {
    }

    bool fits(const Vec2 &size) const { return size.x() <= m_room.x() && size.y() <= m_room.y(); }
    void add(const Item &item);
    std::vector<Sheet> takeSheets() { return std::move(m_sheets); }

private:
    bool addToShelf(const Item &item, bool quarterTurn, Shelf &shelf);

    Vec2 m_size;
    StockId m_stock;
    LayoutOptions m_options;
    Vec2 m_room;
    std::vector<Sheet> m_sheets;
    std::vector<Shelf> m_shelves;
    double m_top = 0.0; // of the last sheet's last shelf, with the spacing
};

bool ShelfPacking::addToShelf(const Item &item, bool quarterTurn, Shelf &shelf)
{
    const Vec2 size = item.turned(quarterTurn);
    if (size.y() > shelf.height || shelf.right + size.x() > m_room.x())
        return false;
    const Vec2 corner = Vec2::Constant(m_options.margin) + Vec2(shelf.right, shelf.bottom);
    m_sheets[shelf.sheet].placements.push_back(placed(item, quarterTurn, corner));
    shelf.right += size.x() + m_options.spacing;
    return true;
}

void ShelfPacking::add(const Item &item)
{
    // Standing takes less of a shelf's length, where the shelf is high enough for it.
    const Vec2 size = item.size();
    const bool standing = size.x() > size.y() ? !item.quarterTurn : item.quarterTurn;
    for (Shelf &shelf : m_shelves) {
        if (addToShelf(item, standing, shelf) || addToShelf(item, item.quarterTurn, shelf))
            return;
    }
    if (m_sheets.empty() || m_top + size.y() > m_room.y()) {
        m_sheets.push_back({m_stock, m_size, {}});
        m_top = 0.0;
    }
    m_shelves.push_back({m_sheets.size() - 1, m_top, size.y(), 0.0});
    m_top += size.y() + m_options.spacing;
    addToShelf(item, item.quarterTurn, m_shelves.back());
}

std::vector<Item> itemsOf(const std::vector<Part> &parts, StockId stock)
{
    std::vector<Item> items;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].stock == stock)
            items.push_back({static_cast<int>(i), bounds(parts[i].outline.region.outer), false});
    }
    return items;
}

} // namespace

Layout layOut(const std::vector<Part> &parts, const Model &model, const LayoutOptions &options)
{
    Layout layout;
    for (const auto &stock : model.document.stocks) {
        std::vector<Item> items = itemsOf(parts, stock->id);
        if (items.empty())
            continue;
        ShelfPacking packing(options.sheet.value_or(stock->sheet), stock->id, options);
        std::vector<Sheet> oversized;
        std::erase_if(items, [&](Item &item) {
            const Vec2 size = item.box.size();
            const bool lying = size.x() < size.y();
            item.quarterTurn = packing.fits(item.turned(lying)) ? lying : !lying;
            if (packing.fits(item.size()))
                return false;
            Sheet sheet{stock->id, size + Vec2::Constant(2.0 * options.margin), {}};
            sheet.placements.push_back(placed(item, false, Vec2::Constant(options.margin)));
            oversized.push_back(std::move(sheet));
            layout.oversized.push_back(item.part);
            return true;
        });
        // Tallest first, so that every shelf is high enough for whatever comes later.
        std::stable_sort(items.begin(), items.end(), [](const Item &a, const Item &b) {
            const Vec2 sa = a.size(), sb = b.size();
            return sa.y() != sb.y() ? sa.y() > sb.y() : sa.x() > sb.x();
        });
        for (const Item &item : items)
            packing.add(item);
        for (Sheet &sheet : packing.takeSheets())
            layout.sheets.push_back(std::move(sheet));
        for (Sheet &sheet : oversized)
            layout.sheets.push_back(std::move(sheet));
    }
    return layout;
}

double usedShare(const Layout &layout, const std::vector<Part> &parts)
{
    double used = 0.0, whole = 0.0;
    for (const Sheet &sheet : layout.sheets) {
        whole += sheet.size.x() * sheet.size.y();
        for (const Placement &placement : sheet.placements)
            used += area(parts[static_cast<std::size_t>(placement.part)].outline.region);
    }
    return whole > 0.0 ? used / whole : 0.0;
}

} // namespace fff
