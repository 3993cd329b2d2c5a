#include "core/fabrication/cutting_drawing.h"

#include <algorithm>

namespace fff {

namespace {

CuttingPart drawn(const Part &part, const Engraving *engraving, const Placement &placement,
                  const Model &model)
{
    const auto placed = [&placement](const auto &lines) { // from the part's coordinates
        return lines.moved([&placement](const Vec2 &p) { return placement.apply(p); });
    };
    CuttingPart all;
    all.number = part.number;
    all.name = model.section(static_cast<std::size_t>(part.section))->name;
    const auto add = [&](LineRole role, const auto &lines) {
        for (const auto &line : lines)
            all.lines.push_back({role, placed(line)});
    };
    if (engraving) {
        all.label = placed(engraving->strokes);
        add(LineRole::Engrave, engraving->lines.engraved);
        add(LineRole::Score, engraving->lines.scored);
    }
    all.lines.reserve(all.lines.size() + part.outline.holes.size() + 1);
    for (const Contour &hole : part.outline.holes)
        all.lines.push_back({LineRole::InnerCut, placed(CurvePath::around(hole))});
    all.lines.push_back({LineRole::OuterCut, placed(CurvePath::around(part.outline.outer))});
    return all;
}

} // namespace

CuttingDrawing cuttingDrawing(const Layout &layout, const std::vector<Part> &parts,
                              const std::vector<Engraving> &engravings, const Model &model,
                              const DrawingOptions &options)
{
    CuttingDrawing drawing;
    drawing.isKerfApplied = options.isKerfApplied;
    drawing.hasReference = options.hasReference;
    for (const Sheet &sheet : layout.sheets) {
        CuttingSheet &all = drawing.sheets.emplace_back();
        all.number = static_cast<int>(drawing.sheets.size());
        all.size = sheet.size;
        all.stock = sheet.stock;
        for (const Placement &placement : sheet.placements) {
            const auto part = static_cast<std::size_t>(placement.part);
            all.parts.push_back(drawn(parts[part], engravings.empty() ? nullptr : &engravings[part],
                                      placement, model));
        }
    }
    for (const auto &stock : model.document.stocks)
        if (std::any_of(layout.sheets.begin(), layout.sheets.end(),
                        [&](const Sheet &sheet) { return sheet.stock == stock->id; }))
            drawing.stocks.push_back(*stock);
    return drawing;
}

CuttingDrawing onSheet(const CuttingDrawing &drawing, std::size_t index)
{
    CuttingDrawing one;
    one.sheets = {drawing.sheets[index]};
    one.isKerfApplied = drawing.isKerfApplied;
    one.hasReference = drawing.hasReference;
    std::copy_if(drawing.stocks.begin(), drawing.stocks.end(), std::back_inserter(one.stocks),
                 [&](const Stock &stock) { return stock.id == drawing.sheets[index].stock; });
    return one;
}

} // namespace fff
