#include "app/cli/nest.h"

#include "app/cli/cut_options.h"
#include "app/cli/cutting_warnings.h"
#include "core/analysis/cutting.h"
#include "core/analysis/lying_parts.h"
#include "core/fabrication/nested_layout.h"
#include "core/fabrication/sheet_supply.h"
#include "core/io/json_writer.h"
#include "core/nesting/nester.h"
#include "core/operations/evaluate.h"

#include <QCoreApplication>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace fff::cli {

namespace {

using io::JsonWriter;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// A model's parts as they are cut.
struct PartsToNest
{
    std::vector<Part> parts;
    Analysis analysis;
    const Model &model() const { return analysis.model; }
};

/// Nothing of what export refuses.
Result<PartsToNest> partsToNest(Document document)
{
    AnalysisCaches caches;
    Analysis analysis = analyse(evaluate(std::move(document)), caches);
    Result<CutParts> cut = cutParts(analysis, true);
    if (!cut)
        return tl::unexpected(std::move(cut.error()));
    return PartsToNest{std::move(cut->parts), std::move(analysis)};
}

bool isTooLarge(const Layout &layout, int part)
{
    return std::find(layout.oversized.begin(), layout.oversized.end(), part) !=
           layout.oversized.end();
}

/// Indices of sheets with parts that fit them.
std::vector<std::size_t> properSheets(const Layout &layout)
{
    std::vector<std::size_t> sheets;
    for (std::size_t i = 0; i < layout.sheets.size(); ++i) {
        const std::vector<Placement> &placements = layout.sheets[i].placements;
        if (!placements.empty() && !isTooLarge(layout, placements.front().part))
            sheets.push_back(i);
    }
    return sheets;
}

std::vector<std::string> namesOfTooLarge(const Layout &layout, const PartsToNest &of)
{
    std::vector<std::string> names;
    for (const int index : layout.oversized) {
        const Part &part = of.parts[static_cast<std::size_t>(index)];
        names.push_back(of.model().section(static_cast<std::size_t>(part.section))->name);
    }
    return names;
}

/// Of its parts.
std::vector<Stock> stocksOf(const PartsToNest &of)
{
    std::vector<Stock> stocks;
    for (const auto &stock : of.model().document.stocks)
        if (std::any_of(of.parts.begin(), of.parts.end(),
                        [&](const Part &part) { return part.stock == stock->id; }))
            stocks.push_back(*stock);
    return stocks;
}

double fillOf(const Sheet &sheet, const std::vector<Part> &parts)
{
    Layout alone;
    alone.sheets.push_back(sheet);
    return usedShare(alone, parts);
}

/// isMissing  there are not so many of its stock
void writeSheet(JsonWriter &json, const Sheet &sheet, bool isMissing, const PartsToNest &of)
{
    json.beginObject();
    json.member("size", sheet.size);
    const Stock *stock = of.model().document.find(sheet.stock);
    json.member("stock", stock ? stock->name : std::string());
    if (sheet.index < 0)
        json.member("offcut", -sheet.index); // which of its stock's, from 1 on
    if (isMissing)
        json.member("missing", true);
    json.member("fill", fillOf(sheet, of.parts));
    json.key("parts");
    json.beginArray();
    for (const Placement &placement : sheet.placements) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("number", of.parts[static_cast<std::size_t>(placement.part)].number);
        json.member("rotation", degreesOf(placement.turn));
        json.member("at", placement.offset);
        json.endObject();
    }
    json.endArray();
    json.endObject();
}

std::string nestJson(const NestedLayout &nested, const PartsToNest &of, const NestAsked &asked)
{
    JsonWriter json;
    json.beginObject();
    json.member("seconds", secondsOf(nested.work));
    json.member("seed", asked.seed);
    json.key("sheets");
    json.beginArray();
    const std::vector<bool> missing = areMissing(nested.layout, of.model().document);
    for (const std::size_t i : properSheets(nested.layout))
        writeSheet(json, nested.layout.sheets[i], missing[i], of);
    json.endArray();
    json.key("tooLarge");
    json.beginArray();
    for (const std::string &name : namesOfTooLarge(nested.layout, of))
        json.value(name);
    json.endArray();
    json.endObject();
    return json.take();
}

QStringList nestText(const NestedLayout &nested, const PartsToNest &of)
{
    const std::vector<std::size_t> sheets = properSheets(nested.layout);
    QStringList lines{tr("Parts: %1, sheets: %2")
                          .arg(QString::number(of.parts.size()), QString::number(sheets.size()))};
    for (const std::size_t i : sheets) {
        const Sheet &sheet = nested.layout.sheets[i];
        const Stock *stock = of.model().document.find(sheet.stock);
        //: A sheet's size, its stock, how many parts lie on it, and how much of it they cover
        lines += tr("%1 × %2 mm, %3: %4 parts, %5 % covered")
                     .arg(QString::number(sheet.size.x()), QString::number(sheet.size.y()),
                          stock ? QString::fromStdString(stock->name) : QString(),
                          QString::number(sheet.placements.size()),
                          QString::number(100.0 * fillOf(sheet, of.parts), 'f', 1));
    }
    return lines;
}

} // namespace

int nestModel(const QString &file, const DocumentOptions &documentOptions, const NestAsked &asked,
              const Verb &verb)
{
    Loaded loaded = load(file, documentOptions, verb);
    if (loaded.status)
        return *loaded.status;
    const Result<PartsToNest> of = partsToNest(std::move(loaded.document));
    if (!of)
        return report(of.error(), file);
    NestOptions options;
    options.layout.margin = asked.margin.value_or(options.layout.margin);
    options.layout.spacing = asked.spacing.value_or(options.layout.spacing);
    options.turning = asked.turning.value_or(options.turning);
    options.seed = asked.seed;
    options.work = nest::workOf(asked.seconds);
    if (const QString why = whyNoRoom(stocksOf(*of), options.layout); !why.isEmpty()) {
        printError(why);
        return BadInput;
    }
    addWishes(of->model(), bodiesOfParts(of->model(), of->parts), options);
    const NestGuard guard(asked.seconds);
    const NestedLayout nested = nestOut(of->parts, of->model(), options, guard.work());
    for (const auto &stock : of->model().document.stocks)
        if (const int missing = missingSheets(nested.layout, *stock); missing > 0)
            //: %1 is a stock, %2 a number
            printError(tr("Sheets of %1 that are missing: %2")
                           .arg(QString::fromStdString(stock->name))
                           .arg(missing));
    for (const std::string &name : namesOfTooLarge(nested.layout, *of))
        printError(tr("%1: a part is too large for its sheet.").arg(QString::fromStdString(name)));
    printWarnings(of->analysis);
    return asked.asJson ? print(nestJson(nested, *of, asked)) : printLines(nestText(nested, *of));
}

} // namespace fff::cli
