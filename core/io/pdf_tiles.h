// How a sheet is cut into pages of paper. Internal to io.
#pragma once

#include "core/geometry/vector.h"

#include <string>
#include <vector>

namespace fff::io {

inline constexpr double kPaperMargin = 10.0;  // mm, that printers leave white
inline constexpr double kPaperFoot = 6.0;     // mm within them, below: what is said of the page
inline constexpr double kPaperOverlap = 10.0; // mm, that neighbours share

struct PdfTile
{
    int column = 0, row = 0;    // from the left, from above
    Vec2 corner = Vec2::Zero(); // the lower left of what it shows, sheet coordinates

    /// "A1", "B1", … "AA1", below it "A2".
    std::string name() const;
};

struct PdfTiles
{
    Vec2 paper = Vec2::Zero(); // mm, as it is held
    int columns = 0, rows = 0;
    std::vector<PdfTile> tiles; // row by row

    /// Of the paper, without its margins and the foot.
    Vec2 room() const;
    /// The lower left of that on the paper.
    static Vec2 low() { return {kPaperMargin, kPaperMargin + kPaperFoot}; }
};

/// Tiles over the box, in the middle of them; the paper is turned where that takes fewer.
/// paper  mm, larger than its margins, the foot and the overlap
PdfTiles tilesOver(const Box2 &box, const Vec2 &paper);

} // namespace fff::io
