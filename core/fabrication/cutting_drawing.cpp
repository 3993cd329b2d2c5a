#include "core/fabrication/cutting_drawing.h"

#include <algorithm>

namespace fff {

namespace {

/// Lines of a part, in the part's coordinates, come to where it lies.
class Placed
{
public:
    explicit Placed(const Placement &placement) : m_placement(placement) {}

    CurvePath operator()(const CurvePath &path) const
    {
        return path.moved([this](const Vec2 &p) { return m_placement.apply(p); });
    }
    CurvePath operator()(const Contour &contour) const
    {
        return (*this)(CurvePath::around(contour));
    }
    Strokes operator()(const Strokes &strokes) const
    {
        Strokes placed;
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            placed.start();
            for (const Vec2 &p : strokes[i])
                placed.add(m_placement.apply(p));
        }
        return placed;
    }

private:
    const Placement &m_placement;
};

CuttingPart drawn(const Part &part, const Engraving *engraving, const Placement &placement,
                  const Model &model)
{
    const Placed placed(placement);
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
    add(LineRole::InnerCut, part.outline.holes);
    all.lines.push_back({LineRole::OuterCut, placed(part.outline.outer)});
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
