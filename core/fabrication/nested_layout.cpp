#include "core/fabrication/nested_layout.h"

#include "core/base/tolerances.h"
#include "core/nesting/nester.h"

#include <algorithm>

namespace fff {

namespace {

/// The parts of a stock, and its sheet.
struct StockParts
{
    StockId stock;
    Vec2 sheet = Vec2::Zero();
    std::vector<int> parts;
};

std::vector<StockParts> byStock(const std::vector<Part> &parts, const Model &model,
                                const LayoutOptions &options)
{
    std::vector<StockParts> stocks;
    for (const auto &stock : model.document.stocks) {
        StockParts of{stock->id, options.sheet.value_or(stock->sheet), {}};
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].stock == stock->id)
                of.parts.push_back(static_cast<int>(i));
        if (!of.parts.empty())
            stocks.push_back(std::move(of));
    }
    return stocks;
}

nest::Turning turningOf(const NestOptions &options, int part)
{
    const auto index = static_cast<std::size_t>(part);
    return index < options.turnings.size() ? options.turnings[index] : options.turning;
}

nest::Piece pieceOf(const Part &part, nest::Turning turning, const Vec2 &room)
{
    nest::Piece piece;
    piece.outline = part.outline.region;
    piece.turns = nest::turnsOf(turning);
    piece.turnsFreely = turning == nest::Turning::Free;
    // Where a long part fits the sheet by no turn that it would begin with.
    if (piece.turnsFreely)
        if (const auto fitting = sizeOf(part.outline, room, true).fitting)
            piece.turns.push_back(fitting->turn);
    return piece;
}

nest::Problem problemOf(const std::vector<Part> &parts, const StockParts &stock,
                           const NestOptions &options)
{
    const Vec2 &size = stock.sheet;
    nest::Problem problem;
    problem.margin = options.layout.margin;
    problem.spacing = options.layout.spacing;
    problem.chord = kCutChord;
    problem.sheets = {{{{Vec2::Zero(), {size.x(), 0.0}, size, {0.0, size.y()}}, {}},
                       nest::SheetKind::kUnlimited}};
    // Chords of an outline may be within it by that much, and so do its pieces have to be.
    const Vec2 room = roomOf(size, options.layout) - Vec2::Constant(2.0 * kCutChord);
    for (const int part : stock.parts)
        problem.pieces.push_back(
            pieceOf(parts[static_cast<std::size_t>(part)], turningOf(options, part), room));
    return problem;
}

void addSheets(const nest::Solution &solution, const StockParts &stock, Layout &layout)
{
    const std::size_t first = layout.sheets.size();
    layout.sheets.resize(first + solution.sheets.size(), Sheet{stock.stock, stock.sheet, {}});
    for (const nest::Place &place : solution.places)
        layout.sheets[first + static_cast<std::size_t>(place.sheet)].placements.push_back(
            {stock.parts[static_cast<std::size_t>(place.piece)], place.turn, place.offset});
}

void addOversized(int index, const Part &part, const LayoutOptions &options, Layout &layout)
{
    const Vec2 margin = Vec2::Constant(options.margin);
    const Box2 box = sizeOf(part.outline, Vec2::Zero(), false).drawn.box;
    Sheet own{part.stock, box.size() + 2.0 * margin, {}};
    own.placements.push_back({index, Vec2::UnitX(), margin - box.min});
    layout.sheets.push_back(std::move(own));
    layout.oversized.push_back(index);
}

/// Whether layOut() turns no part in a way that it may not be turned here.
bool mayTurnAsBoxes(const NestOptions &options)
{
    const auto isEnough = [](nest::Turning turning) {
        return turning == nest::Turning::Quarter || turning == nest::Turning::Free;
    };
    return isEnough(options.turning) &&
           std::all_of(options.turnings.begin(), options.turnings.end(), isEnough);
}

/// Where its boxes take fewer sheets, that of layOut().
void takeBetter(const std::vector<Part> &parts, const Model &model, const NestOptions &options,
                Layout &layout)
{
    if (!mayTurnAsBoxes(options))
        return;
    const auto isFree = [](nest::Turning turning) { return turning == nest::Turning::Free; };
    LayoutOptions ofBoxes = options.layout;
    ofBoxes.turnsFreely = isFree(options.turning) &&
                          std::all_of(options.turnings.begin(), options.turnings.end(), isFree);
    Layout boxes = layOut(parts, model, ofBoxes);
    if (boxes.oversized.size() < layout.oversized.size() ||
        boxes.sheets.size() < layout.sheets.size())
        layout = std::move(boxes);
}

} // namespace

NestedLayout nestOut(const std::vector<Part> &parts, const Model &model, const NestOptions &options,
                     const LongWork &longWork)
{
    NestedLayout nested;
    double done = 0.0; // share of the parts
    for (const StockParts &stock : byStock(parts, model, options.layout)) {
        const double share =
            static_cast<double>(stock.parts.size()) / static_cast<double>(parts.size());
        nest::Options of;
        of.seed = options.seed;
        of.work = static_cast<std::int64_t>(share * static_cast<double>(options.work));
        of.usesThreads = options.usesThreads;
        const LongWork part{longWork.stop,
                            [&](double within) { longWork.tell(done + share * within); }};
        const nest::Solution solution =
            nest::nestPieces(problemOf(parts, stock, options), of, part);
        nested.work += solution.work;
        addSheets(solution, stock, nested.layout);
        for (const int piece : solution.left) {
            const int index = stock.parts[static_cast<std::size_t>(piece)];
            addOversized(index, parts[static_cast<std::size_t>(index)], options.layout,
                         nested.layout);
        }
        done += share;
    }
    takeBetter(parts, model, options, nested.layout);
    return nested;
}

} // namespace fff
