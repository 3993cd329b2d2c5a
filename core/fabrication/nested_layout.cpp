#include "core/fabrication/nested_layout.h"

#include "core/base/tolerances.h"
#include "core/fabrication/outer_chords.h"
#include "core/fabrication/pins.h"
#include "core/fabrication/sheet_supply.h"
#include "core/geometry/turning.h"
#include "core/nesting/nester.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fff {

namespace {

/// The parts of a stock, and its sheets.
struct StockParts
{
    SheetSupply supply;
    std::vector<int> parts; // that are to be laid
    std::vector<PinnedPart> pinned;
    std::size_t count = 0; // of both
};

std::vector<StockParts> byStock(const std::vector<Part> &parts, const Model &model,
                                const LayoutOptions &options)
{
    std::vector<StockParts> stocks;
    for (const auto &stock : model.document.stocks) {
        StockParts of{SheetSupply(*stock, options), {}, {}, 0};
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].stock == stock->id)
                of.parts.push_back(static_cast<int>(i));
        of.count = of.parts.size();
        if (!of.parts.empty())
            stocks.push_back(std::move(of));
    }
    return stocks;
}

/// Takes what is pinned, and sound, out of what is to be laid.
void pin(const std::vector<Part> &parts, const NestOptions &options, StockParts &stock,
         std::vector<int> &loosened)
{
    std::vector<PinnedPart> wished;
    for (const PinnedPart &one : options.pinned)
        if (std::find(stock.parts.begin(), stock.parts.end(), one.part) != stock.parts.end())
            wished.push_back(one);
    if (wished.empty())
        return;
    SoundPins sound = soundPins(parts, stock.supply, options.layout, std::move(wished));
    std::set<int> stay;
    for (const PinnedPart &one : sound.pinned)
        stay.insert(one.part);
    std::erase_if(stock.parts, [&](int part) { return stay.contains(part); });
    stock.pinned = std::move(sound.pinned);
    loosened.insert(loosened.end(), sound.loosened.begin(), sound.loosened.end());
}

nest::Turning turningOf(const NestOptions &options, int part)
{
    const auto index = static_cast<std::size_t>(part);
    return index < options.turnings.size() ? options.turnings[index] : options.turning;
}

nest::Piece pieceOf(const Part &part, nest::Turning turning, bool hasHoles, const Vec2 &room)
{
    nest::Piece piece;
    piece.outline = outerChords(part.outline);
    if (!hasHoles)
        piece.outline.holes.clear();
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
    nest::Problem problem = sheetsAround(parts, stock.supply, options.layout, stock.pinned);
    // What pieces have in place of curves may go beyond these by that much.
    const Vec2 room =
        roomOf(stock.supply.whole(), options.layout) - Vec2::Constant(2.0 * kCutChord);
    for (const int part : stock.parts)
        problem.pieces.push_back(pieceOf(parts[static_cast<std::size_t>(part)],
                                         turningOf(options, part), options.fillsHoles, room));
    return problem;
}

/// How the pieces lay, on kinds of the problem; without places where that is not known of all.
nest::Solution solutionBefore(const StockParts &stock, const NestOptions &options)
{
    std::map<int, const PinnedPart *> lay; // by part
    for (const PinnedPart &one : options.before)
        if (stock.supply.has(one.sheet))
            lay[one.part] = &one;
    nest::Solution before;
    const int last = stock.supply.kindOf(wholeSheetsOf(stock.pinned)); // of many sheets
    std::map<int, std::vector<nest::Place>> sheets;                    // by what would be a kind
    for (std::size_t i = 0; i < stock.parts.size(); ++i) {
        const auto place = lay.find(stock.parts[i]);
        if (place == lay.end())
            return before;
        sheets[stock.supply.kindOf(place->second->sheet)].push_back(
            {static_cast<int>(i), 0, place->second->turn, place->second->offset});
    }
    for (auto &[kind, places] : sheets) {
        for (nest::Place &place : places) {
            place.sheet = static_cast<int>(before.sheets.size());
            before.places.push_back(place);
        }
        before.sheets.push_back(std::min(kind, last));
    }
    return before;
}

/// Offcuts, sheets with pinned parts in their order, whether or not others came to lie there, and
/// plain ones.
void addSheets(const nest::Solution &solution, const StockParts &stock, Layout &layout)
{
    // By the kinds of the problem, of which the last is of many sheets.
    const int last = stock.supply.kindOf(wholeSheetsOf(stock.pinned));
    std::map<int, std::vector<Placement>> sheets;
    for (const PinnedPart &one : stock.pinned)
        sheets[stock.supply.kindOf(one.sheet)].push_back({one.part, one.turn, one.offset});
    for (const nest::Place &place : solution.places) {
        const int kind = solution.sheets[static_cast<std::size_t>(place.sheet)];
        sheets[kind < last ? kind : last + place.sheet].push_back(
            {stock.parts[static_cast<std::size_t>(place.piece)], place.turn, place.offset});
    }
    int next = last;
    for (auto &[key, placements] : sheets) {
        const int kind = key < last ? key : next++;
        Sheet sheet = stock.supply.sheet(stock.supply.indexOfKind(kind));
        sheet.placements = std::move(placements);
        layout.sheets.push_back(std::move(sheet));
    }
}

void addOversized(int index, const Part &part, const LayoutOptions &options, Layout &layout)
{
    const Vec2 margin = Vec2::Constant(options.margin);
    const Box2 box = sizeOf(part.outline, Vec2::Zero(), false).drawn.box;
    Sheet own{part.stock, box.size() + 2.0 * margin, {}, 0};
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
    const auto hasSpares = [&](const auto &stock) {
        return SheetSupply(*stock, options.layout).spareCount() > 0;
    };
    const auto &stocks = model.document.stocks;
    if (!options.pinned.empty() || !mayTurnAsBoxes(options) ||
        std::any_of(stocks.begin(), stocks.end(), hasSpares))
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

bool isOfOversized(const Sheet &sheet, const Layout &layout)
{
    return !sheet.placements.empty() &&
           std::find(layout.oversized.begin(), layout.oversized.end(),
                     sheet.placements.front().part) != layout.oversized.end();
}

/// How far up its parts reach, mm.
double usedHeight(const Sheet &sheet, const std::vector<Part> &parts)
{
    double height = 0.0;
    for (const Placement &placement : sheet.placements) {
        const Part &part = parts[static_cast<std::size_t>(placement.part)];
        height = std::max(height, turnedBounds(part.outline.region.outer, placement.turn).max.y() +
                                      placement.offset.y());
    }
    return height;
}

} // namespace

NestedLayout nestOut(const std::vector<Part> &parts, const Model &model, const NestOptions &options,
                     const LongWork &longWork)
{
    NestedLayout nested;
    double done = 0.0; // share of the parts
    for (StockParts &stock : byStock(parts, model, options.layout)) {
        pin(parts, options, stock, nested.loosened);
        const double share = static_cast<double>(stock.count) / static_cast<double>(parts.size());
        nest::Options of;
        of.seed = options.seed;
        of.work = static_cast<std::int64_t>(share * static_cast<double>(options.work));
        of.usesThreads = options.usesThreads;
        const LongWork part{longWork.stop,
                            [&](double within) { longWork.tell(done + share * within); }};
        const nest::Solution solution =
            stock.parts.empty() ? nest::Solution()
                                : nest::nestPieces(problemOf(parts, stock, options), of, part,
                                                   solutionBefore(stock, options));
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

std::vector<double> takenHeights(const Layout &layout, const std::vector<Part> &parts,
                                 const LayoutOptions &options)
{
    std::vector<double> heights(layout.sheets.size(), 0.0);
    std::set<StockId> seen; // from behind: the first one of a stock is its last
    for (std::size_t i = layout.sheets.size(); i-- > 0;) {
        const Sheet &sheet = layout.sheets[i];
        if (isOfOversized(sheet, layout))
            continue;
        const bool isLast = seen.insert(sheet.stock).second;
        heights[i] = isLast && !sheet.outline
                         ? std::min(sheet.size.y(), usedHeight(sheet, parts) + options.margin)
                         : sheet.size.y();
    }
    return heights;
}

TakenArea takenArea(const Layout &layout, const std::vector<Part> &parts,
                    const LayoutOptions &options)
{
    TakenArea area;
    const std::vector<double> heights = takenHeights(layout, parts, options);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const Sheet &sheet = layout.sheets[i];
        if (heights[i] > 0.0)
            (sheet.index < 0 ? area.offcuts : area.wholes) +=
                sheet.outline ? areaOf(sheet) : sheet.size.x() * heights[i];
    }
    return area;
}

double filledShare(const Layout &layout, const std::vector<Part> &parts,
                   const LayoutOptions &options)
{
    const TakenArea area = takenArea(layout, parts, options);
    const double taken = area.wholes + area.offcuts;
    double covered = 0.0;
    for (const Sheet &sheet : layout.sheets)
        if (!isOfOversized(sheet, layout))
            for (const Placement &placement : sheet.placements)
                covered += std::abs(
                    fff::area(parts[static_cast<std::size_t>(placement.part)].outline.region));
    return taken > 0.0 ? covered / taken : 0.0;
}

} // namespace fff
