#include "core/io/stacked_sheets.h"

#include "core/fabrication/machine.h"

namespace fff::io {

bool hasBar(const CuttingDrawing &drawing)
{
    return drawing.hasReference && machineOf(drawing).hasGuides;
}

StackedSheets stacked(const CuttingDrawing &drawing)
{
    StackedSheets stack;
    double top = 0.0;
    const auto add = [&](const Vec2 &size) {
        const Vec2 corner(0.0, top);
        stack.box.extend(corner);
        stack.box.extend(Vec2(corner + size));
        top += size.y() + kSheetGap;
        return corner;
    };
    for (const CuttingSheet &sheet : drawing.sheets)
        stack.corners.push_back(add(sheet.size));
    if (hasBar(drawing))
        stack.reference = add(kReferenceSize);
    return stack;
}

bool hasEdges(const CuttingDrawing &drawing, const CuttingSheet &sheet)
{
    return machineOf(drawing).hasGuides && (drawing.sheets.size() > 1 || sheet.outline);
}

std::array<Vec2, 4> cornersOf(const Vec2 &corner, const Vec2 &size)
{
    return {corner, Vec2(corner.x() + size.x(), corner.y()), Vec2(corner + size),
            Vec2(corner.x(), corner.y() + size.y())};
}

} // namespace fff::io
