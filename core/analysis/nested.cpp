#include "core/analysis/nested.h"

#include "core/analysis/analysed.h"
#include "core/analysis/lying_parts.h"
#include "core/fabrication/sheet_supply.h"
#include "core/nesting/nester.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

double secondsFor(const SheetsQuestion &question)
{
    switch (question.level) {
    case NestLevel::Quick:
        break;
    case NestLevel::Good:
        return kGoodSeconds;
    case NestLevel::Best:
        return secondsOfRound(question.round);
    }
    return 0.0;
}

/// How they are laid when nothing lies there but what is pinned.
NestOptions optionsFor(const SheetsQuestion &question, const Model &model,
                       const BodiesOfParts &bodies)
{
    NestOptions options = question.nesting;
    addWishes(model, bodies, options);
    options.work = nest::workOf(secondsFor(question));
    if (question.level == NestLevel::Best)
        options.seed += static_cast<std::uint64_t>(question.round);
    return options;
}

/// Without offcuts, which are there to be used up.
std::ptrdiff_t wholeSheetCount(const Layout &layout)
{
    return std::count_if(layout.sheets.begin(), layout.sheets.end(),
                         [](const Sheet &sheet) { return sheet.index >= 0; });
}

bool isBetter(const Layout &a, const Layout &b, const std::vector<Part> &parts,
              const LayoutOptions &options)
{
    const auto key = [&](const Layout &layout) {
        return std::pair(layout.oversized.size(), takenArea(layout, parts, options));
    };
    return key(a) < key(b);
}

/// Without what lay before: null.
const Nested *before(const Nested *previous, const SheetsQuestion &question)
{
    const bool isKnown = previous && previous->layout && previous->answers(question) &&
                         previous->question->times == question.times;
    return isKnown ? previous : nullptr;
}

bool areSame(const std::shared_ptr<const Region> &a, const std::shared_ptr<const Region> &b)
{
    return a == b || (a && b && a->outer == b->outer && a->holes == b->holes);
}

/// Others than there were are there to be used up.
bool areOffcutsTheSame(const Document &before, const Document &now)
{
    return std::all_of(now.stocks.begin(), now.stocks.end(), [&](const auto &stock) {
        const Stock *was = before.find(stock->id);
        return was ? was->spares == stock->spares : stock->spares.empty();
    });
}

/// As the stocks have them now.
bool areSheetsTheSame(const Layout &layout, const Model &model, const LayoutOptions &options)
{
    const auto isOversized = [&](const Sheet &sheet) {
        return std::any_of(sheet.placements.begin(), sheet.placements.end(), [&](const auto &one) {
            return std::find(layout.oversized.begin(), layout.oversized.end(), one.part) !=
                   layout.oversized.end();
        });
    };
    return std::all_of(layout.sheets.begin(), layout.sheets.end(), [&](const Sheet &sheet) {
        const Stock *stock = model.document.find(sheet.stock);
        if (!stock || isOversized(sheet))
            return true;
        const SheetSupply supply(*stock, options);
        if (!supply.has(sheet.index))
            return false;
        const Sheet now = supply.sheet(sheet.index);
        return now.size == sheet.size && areSame(now.outline, sheet.outline);
    });
}

LyingParts lyingOf(const Nested &last)
{
    return {last.analysis->model, last.parts->parts, *last.layout};
}

bool isOnTheSameSheets(const Nested &last, const Model &model, const LayoutOptions &options)
{
    return areSheetsTheSame(*last.layout, model, options) &&
           areOffcutsTheSame(last.analysis->model.document, model.document);
}

/// What an edit has not changed stays; nothing where that is no good. On the same sheets.
std::optional<NestedLayout> afterEdit(const Nested &last, const std::vector<Part> &parts,
                                      const BodiesOfParts &bodies, const Model &model,
                                      NestOptions options)
{
    std::optional<std::vector<PinnedPart>> lying = lyingStill(lyingOf(last), parts, bodies);
    if (!lying)
        return std::nullopt;
    goBack(last.layBefore, bodies, *lying);
    std::erase_if(*lying, [&](const PinnedPart &one) { return !mayLieSo(one, options); });
    options.pinned.insert(options.pinned.end(), lying->begin(), lying->end());
    NestedLayout kept = nestOut(parts, model, options);
    if (wholeSheetCount(kept.layout) > wholeSheetCount(*last.layout) ||
        kept.layout.oversized.size() > last.layout->oversized.size())
        return std::nullopt;
    // Of those that were to stay anyway.
    const std::vector<PinnedPart> pinned = std::move(options.pinned);
    std::erase_if(kept.loosened, [&](int part) {
        return std::none_of(pinned.begin(), pinned.end(), [part](const PinnedPart &one) {
            return one.part == part && !one.yields;
        });
    });
    return kept;
}

/// How the same parts lay.
NestedLayout asTheyLay(const Nested &last)
{
    return {*last.layout, 0, last.loosened};
}

NestedLayout laid(const Nested *last, bool areSameParts, const Nested &now,
                  const BodiesOfParts &bodies, const LongWork &work)
{
    const SheetsQuestion &question = *now.question;
    const Model &model = now.analysis->model;
    const std::vector<Part> &parts = now.parts->parts;
    NestOptions options = optionsFor(question, model, bodies);
    std::optional<NestedLayout> base;
    if (last && areSameParts)
        base = asTheyLay(*last);
    else if (last && question.level == NestLevel::Quick &&
             isOnTheSameSheets(*last, model, options.layout)) {
        base = afterEdit(*last, parts, bodies, model, options);
        if (!base) // much is another than it was: a kerf, a clearance
            options.before = layBefore(lyingOf(*last), parts, bodies);
    }
    if (base && question.level == NestLevel::Quick)
        return *std::move(base);
    NestedLayout found = nestOut(parts, model, options, work);
    if (base && !isBetter(found.layout, base->layout, parts, options.layout))
        return *std::move(base);
    return found;
}

/// What follows from how they lie.
void finish(Nested &out)
{
    const LayoutOptions &options = out.question->nesting.layout;
    Result<Cutting> cutting = cuttingOf(*out.analysis, *out.parts, *out.layout, {});
    if (!cutting) {
        out.why = std::move(cutting.error());
        return;
    }
    out.filled = filledShare(*out.layout, out.parts->parts, options);
    out.cutLength = cutLength(cutting->drawing);
    out.cutting = std::make_shared<const Cutting>(*std::move(cutting));
}

} // namespace

double secondsOfRound(int round)
{
    double seconds = kGoodSeconds;
    for (int i = 0; i < round && seconds < kMostRoundSeconds; ++i)
        seconds *= 2.0;
    return std::min(seconds, kMostRoundSeconds);
}

bool SheetsQuestion::asksForTheSame(const SheetsQuestion &other) const
{
    return nesting == other.nesting && compensatesKerf == other.compensatesKerf;
}

Result<Nested> nested(const Snapshot &snapshot, const Nested *previous, Progress &progress,
                      std::stop_token stop)
{
    Nested out;
    out.question = snapshot.pointer(kSheetsAsked);
    if (!out.question)
        return out;
    out.analysis = snapshot.get(kAnalysed).analysis;
    const bool isSameModel = previous && previous->parts && previous->analysis == out.analysis &&
                             previous->parts->isKerfApplied == out.question->compensatesKerf;
    if (isSameModel) {
        out.parts = previous->parts;
    } else {
        Result<CutParts> parts = cutParts(*out.analysis, out.question->compensatesKerf);
        if (!parts) {
            out.why = std::move(parts.error());
            return out;
        }
        out.parts = std::make_shared<const CutParts>(*std::move(parts));
    }
    const BodiesOfParts bodies = bodiesOfParts(out.analysis->model, out.parts->parts);
    const LongWork work{stop, [&progress](double share) { progress.set(share); }};
    const Nested *last = before(previous, *out.question);
    NestedLayout made = laid(last, isSameModel, out, bodies, work);
    if (last)
        out.layBefore =
            layBeforePins(lyingOf(*last), last->layBefore, out.analysis->model.document);
    out.isStopped = stop.stop_requested() && out.question->level != NestLevel::Quick;
    out.loosened = std::move(made.loosened);
    out.layout = std::make_shared<const Layout>(std::move(made.layout));
    finish(out);
    return out;
}

} // namespace fff
