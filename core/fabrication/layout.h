// Parts on sheets: a simple shelf packing by bounding boxes, per stock.
#pragma once

#include "core/fabrication/part.h"

namespace fff {

struct LayoutOptions
{
    double margin = 5.0;       // mm, sheet's edge to nearest cut
    double spacing = 2.0;      // mm, between neighbouring cuts
    std::optional<Vec2> sheet; // instead of the stock's, mm
};

/// A part's place: sheet coordinates (mm, origin at the sheet's lower left, y up) = turn(p) +
/// offset, turn = 0 or a quarter turn counter-clockwise.
struct Placement
{
    int part = 0; // index into the parts
    bool quarterTurn = false;
    Vec2 offset = Vec2::Zero();

    Vec2 apply(const Vec2 &p) const { return (quarterTurn ? perpendicular(p) : p) + offset; }
};

struct Sheet
{
    StockId stock;
    Vec2 size = Vec2::Zero();
    std::vector<Placement> placements;
};

struct Layout
{
    std::vector<Sheet> sheets;
    std::vector<int>
        oversized; // indices of parts that fit no sheet; each lies on a sheet of its own size
};

/// Every part goes on the first shelf that has room for it, tallest first, lying or standing. All
/// parts of a stock on its own sheets, in the order of the document's stocks; oversized ones last.
/// Deterministic. O(parts · shelves).
Layout layOut(const std::vector<Part> &parts, const Model &model, const LayoutOptions &options);

/// How much of the sheets' area the parts cover, 0 … 1; 0 without sheets.
double usedShare(const Layout &layout, const std::vector<Part> &parts);

} // namespace fff
