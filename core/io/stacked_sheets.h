// Where the sheets of a drawing lie in a file that has them all in one plane. Internal to io.
#pragma once

#include "core/fabrication/cutting_drawing.h"

#include <array>
#include <vector>

namespace fff::io {

inline constexpr double kSheetGap = 10.0;             // mm
inline const Vec2 kReferenceSize = Vec2(100.0, 10.0); // mm, of the bar to measure

/// y up: the first sheet's lower left corner is the origin, so that a file of one sheet has the
/// sheet's coordinates; each next one lies above, and the bar above all.
struct StackedSheets
{
    std::vector<Vec2> corners;     // the lower left of each
    Vec2 reference = Vec2::Zero(); // the same of the bar, where there is one
    Box2 box;                      // of all, with the bar
};
/// Whether there is a bar to measure: where it was asked for, and the machine lets it alone.
bool hasBar(const CuttingDrawing &drawing);
StackedSheets stacked(const CuttingDrawing &drawing);

/// Whether the sheet's edges are drawn, as guides: of several, and of an offcut, which is to be
/// laid down as it is.
bool hasEdges(const CuttingDrawing &drawing, const CuttingSheet &sheet);

/// Corners of a rectangle, counter-clockwise from its lower left one.
std::array<Vec2, 4> cornersOf(const Vec2 &corner, const Vec2 &size);

} // namespace fff::io
