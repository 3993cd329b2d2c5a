#include "core/fabrication/cutting_drawing.h"

#include "core/fabrication/machine.h"
#include "core/geometry/turning.h"

#include <algorithm>
#include <cmath>

namespace fff {

CubicBezier CuttingLine::segment(int index) const
{
    const CubicBezier own = segmentOf(index);
    return {m_placement->apply(own.p0), m_placement->apply(own.p1), m_placement->apply(own.p2),
            m_placement->apply(own.p3)};
}

bool CuttingPart::isAtSlit(const Vec2 &point, double room) const
{
    const Vec2 back(m_placement.turn.x(), -m_placement.turn.y());
    const Vec2 own = turned(point - m_placement.offset, back);
    const auto &joints = part().joints;
    return std::any_of(joints.begin(), joints.end(), [&](const Part::JointMark &joint) {
        const Vec2 off = own - joint.inner;
        return off.dot(joint.direction) <= room &&
               std::abs(cross(joint.direction, off)) <= 0.5 * joint.width + room;
    });
}

std::size_t CuttingPart::pointCount() const
{
    std::size_t count = hasLabel() ? engraving()->strokes.pointCount() : 0;
    forLines([&](const CuttingLine &line) {
        count += 3 * static_cast<std::size_t>(line.segmentCount()) + 1;
    });
    return count;
}

CuttingDrawing cuttingDrawing(const Layout &layout, std::vector<Part> parts,
                              std::vector<Engraving> engravings, const Model &model,
                              const DrawingOptions &options)
{
    const auto source = std::make_shared<const CuttingPart::Source>(
        CuttingPart::Source{std::move(parts), std::move(engravings)});
    CuttingDrawing drawing;
    drawing.isKerfApplied = options.isKerfApplied;
    drawing.hasReference = options.hasReference;
    drawing.machine = options.machine;
    drawing.hasJointColours = options.hasJointColours;
    for (const Sheet &sheet : layout.sheets) {
        CuttingSheet &all = drawing.sheets.emplace_back();
        all.number = static_cast<int>(drawing.sheets.size());
        all.size = sheet.size;
        all.outline = sheet.outline;
        all.stock = sheet.stock;
        all.finish = options.finish.value_or(machineOf(drawing).finish);
        all.parts.reserve(sheet.placements.size());
        for (const Placement &placement : sheet.placements) {
            const Part &part = source->parts[static_cast<std::size_t>(placement.part)];
            all.parts.emplace_back(source, placement,
                                   model.section(static_cast<std::size_t>(part.section))->name);
        }
    }
    for (const auto &stock : model.document.stocks)
        if (std::any_of(layout.sheets.begin(), layout.sheets.end(),
                        [&](const Sheet &sheet) { return sheet.stock == stock->id; }))
            drawing.stocks.push_back(*stock);
    return drawing;
}

std::vector<Polygon> edgesOf(const CuttingSheet &sheet)
{
    const Vec2 &size = sheet.size;
    if (!sheet.outline)
        return {{{0.0, 0.0}, {size.x(), 0.0}, size, {0.0, size.y()}}};
    std::vector<Polygon> rings{sheet.outline->outer};
    rings.insert(rings.end(), sheet.outline->holes.begin(), sheet.outline->holes.end());
    return rings;
}

CuttingDrawing onSheet(const CuttingDrawing &drawing, std::size_t index)
{
    CuttingDrawing one;
    one.sheets = {drawing.sheets[index]};
    one.isKerfApplied = drawing.isKerfApplied;
    one.hasReference = drawing.hasReference;
    one.machine = drawing.machine;
    one.hasJointColours = drawing.hasJointColours;
    one.list = drawing.list;
    std::copy_if(drawing.stocks.begin(), drawing.stocks.end(), std::back_inserter(one.stocks),
                 [&](const Stock &stock) { return stock.id == drawing.sheets[index].stock; });
    return one;
}

} // namespace fff
