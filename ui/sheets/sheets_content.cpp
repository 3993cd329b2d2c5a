#include "ui/sheets/sheets_content.h"

#include "core/analysis/lying_parts.h"
#include "core/base/units.h"
#include "core/fabrication/sheet_supply.h"
#include "core/geometry/polygon.h"
#include "core/geometry/turning.h"
#include "core/model/sheet_edits.h"
#include "ui/properties/stock_choice.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace fff::ui {

namespace {

constexpr double kWholeTurn = 360.0;

bool isOversized(const Sheet &sheet, const Layout &layout)
{
    return !sheet.placements.empty() &&
           std::find(layout.oversized.begin(), layout.oversized.end(),
                     sheet.placements.front().part) != layout.oversized.end();
}

PartOnSheet partOnSheet(const Placement &placement, const Nested &nested,
                        const BodiesOfParts &bodies)
{
    const Part &part = nested.parts->parts[static_cast<std::size_t>(placement.part)];
    PartOnSheet on;
    const Model &model = nested.analysis->model;
    std::tie(on.section, on.body) = bodies.ofPart[static_cast<std::size_t>(placement.part)];
    const auto own =
        turningOf(model.document, *model.section(static_cast<std::size_t>(part.section)));
    on.turning = own.value_or(nested.question->nesting.turning);
    on.keepsToGrain = own == nest::Turning::None || own == nest::Turning::Half;
    const std::vector<int> &loosened = nested.loosened;
    on.isPinned = pinOf(model.document, on.section, on.body) &&
                  std::find(loosened.begin(), loosened.end(), placement.part) == loosened.end();
    on.size = turnedBounds(part.outline.region.outer, Vec2::UnitX()).size();
    const double turn = degrees(std::atan2(placement.turn.y(), placement.turn.x()));
    on.turn = turn < 0.0 ? turn + kWholeTurn : turn;
    return on;
}

double areaOn(const Sheet &sheet, const std::vector<Part> &parts)
{
    double sum = 0.0;
    for (const Placement &placement : sheet.placements)
        sum += std::abs(area(parts[static_cast<std::size_t>(placement.part)].outline.region));
    return sum;
}

} // namespace

const std::vector<SheetPaths> &SheetsContent::sheets() const
{
    static const std::vector<SheetPaths> kNone;
    return made ? made->sheets : kNone;
}

SheetsContent sheetsContent(std::shared_ptr<const CuttingWork::Made> made)
{
    SheetsContent content;
    if (!made || !made->nested->cutting)
        return content;
    const Nested &nested = *made->nested;
    const NestOptions &options = nested.question->nesting;
    content.margin = options.layout.margin;
    content.hasGrain =
        options.turning == nest::Turning::None || options.turning == nest::Turning::Half;
    const BodiesOfParts bodies = bodiesOfParts(nested.analysis->model, nested.parts->parts);
    const std::vector<double> heights =
        takenHeights(*nested.layout, nested.parts->parts, options.layout);
    std::set<StockId> stocks;
    for (const Sheet &sheet : nested.layout->sheets)
        stocks.insert(sheet.stock);
    for (const Sheet &sheet : nested.layout->sheets) {
        SheetFacts facts;
        for (const Placement &placement : sheet.placements)
            facts.parts.push_back(partOnSheet(placement, nested, bodies));
        facts.isTooLarge = isOversized(sheet, *nested.layout);
        facts.isOffcut = sheet.index < 0;
        const double taken = heights[content.facts.size()];
        const double area = sheet.outline ? areaOf(sheet) : sheet.size.x() * taken;
        facts.usedShare = area > 0.0 ? areaOn(sheet, nested.parts->parts) / area : 0.0;
        const Stock *stock = nested.analysis->model.document.find(sheet.stock);
        if (stock && stocks.size() > 1)
            facts.stock = stockName(*stock);
        content.facts.push_back(std::move(facts));
    }
    content.made = std::move(made);
    return content;
}

} // namespace fff::ui
