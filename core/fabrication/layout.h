// Parts on sheets, per stock: by the boxes of their hulls, turned as it suits them.
#pragma once

#include "core/fabrication/outline_size.h"
#include "core/fabrication/part.h"

namespace fff {

struct LayoutOptions
{
    double margin = 5.0;       // mm, sheet's edge to nearest cut
    double spacing = 2.0;      // mm, between neighbouring cuts
    std::optional<Vec2> sheet; // instead of the stock's, mm
    bool turnsFreely = true;   // false: quarter turns only, for sheets that have a grain

    bool operator==(const LayoutOptions &) const = default;
};

/// A part's place: sheet coordinates (mm, origin at the sheet's lower left, y up) = turned(p) +
/// offset.
struct Placement
{
    int part = 0;              // index into the parts
    Vec2 turn = Vec2::UnitX(); // cosine and sine of the turn, counter-clockwise
    Vec2 offset = Vec2::Zero();

    Vec2 apply(const Vec2 &p) const { return turned(p, turn) + offset; }
};

struct Sheet
{
    StockId stock;
    Vec2 size = Vec2::Zero();
    std::vector<Placement> placements;
    /// Among the whole ones of its stock, of which some may be empty and not there; of its spare
    /// ones -1 is the first (SheetSupply).
    int index = 0;
    std::shared_ptr<const Region> outline = {}; // of an offcut; null: a rectangle of that size
};

struct Layout
{
    std::vector<Sheet> sheets;
    std::vector<int>
        oversized; // indices of parts that fit no sheet; each lies on a sheet of its own size
};

/// Boxes of parts side by side, on the first sheet that has room, as low as they go there. Tried in
/// several orders (tallest, largest, longest first) and with the parts as they are drawn, turned to
/// their smallest boxes and to their lowest ones; the fewest sheets win, then the least height that
/// is used, then the parts as drawn. A part that fits the sheet only at an angle is turned to that
/// angle; it fits none when no turn of its hull does.
///
/// All parts of a stock on its own whole sheets, however many there are, in the order of the
/// document's stocks; oversized ones last. No two parts are nearer than the spacing, none is nearer
/// to the edge than the margin. Deterministic. O(parts · parts of a sheet) for each try where parts
/// have a few sizes (OpenSheets), O(v log v) for the hull of a part with v vertices.
Layout layOut(const std::vector<Part> &parts, const Model &model, const LayoutOptions &options);

/// A part by its size alone, in the room of its stock's sheet.
struct SizedPart
{
    StockId stock;
    std::shared_ptr<const OutlineSize> size;
};

/// What margins leave of a sheet, mm.
Vec2 roomOf(const Vec2 &sheet, const LayoutOptions &options);

/// The same where the sizes are at hand: each worked out for roomOf() its sheet.
Layout layOutBySize(const std::vector<SizedPart> &parts, const Model &model,
                    const LayoutOptions &options);

/// How the parts of each stock lay when they were laid out last.
struct LayoutCache
{
    struct OfStock
    {
        // What the rest was made of.
        StockId stock;
        Vec2 sheet = Vec2::Zero(); // mm
        LayoutOptions options;
        std::vector<int> parts;                                // that fit the sheet
        std::vector<std::shared_ptr<const OutlineSize>> sizes; // of these

        std::shared_ptr<const std::vector<Sheet>> sheets;
    };
    std::vector<OfStock> stocks;
};

/// The same, where the parts of a stock may lie as they lay last that are as they were but for
/// their areas.
Layout layOutBySize(const std::vector<SizedPart> &parts, const Model &model,
                    const LayoutOptions &options, LayoutCache &cache);
double usedShare(const Layout &layout, const std::vector<SizedPart> &parts);

/// How much of the sheets' area the parts cover, 0 … 1; 0 without sheets.
double usedShare(const Layout &layout, const std::vector<Part> &parts);

} // namespace fff
