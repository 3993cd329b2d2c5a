#include "core/io/parts_csv.h"

#include "core/fabrication/cutting_order.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <vector>

namespace fff::io {

namespace {

std::string csvText(const std::string &text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

std::string csvNumber(double value, int decimals)
{
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

/// What the list knows of each number.
std::map<int, const ListedPart *> byNumber(const CuttingDrawing &drawing)
{
    std::map<int, const ListedPart *> parts;
    for (const ListedPart &part : drawing.list)
        for (const int number : part.numbers)
            parts.emplace(number, &part);
    return parts;
}

/// Of each part of a sheet, on its own.
std::vector<ToolWay> waysOf(const CuttingSheet &sheet, const Machine &machine)
{
    std::vector<std::vector<ToolLine>> lines(sheet.parts.size());
    for (ToolLine &line : inCuttingOrder(sheet))
        lines[line.part].push_back(std::move(line));
    std::vector<ToolWay> ways;
    for (const std::vector<ToolLine> &some : lines) {
        ToolWay &way = ways.emplace_back();
        for (const ToolLine &line : some)
            way += wayAlong({line}, machine, line.start());
    }
    return ways;
}

} // namespace

std::string writePartsCsv(const CuttingDrawing &drawing)
{
    const std::map<int, const ListedPart *> known = byNumber(drawing);
    std::string out = "number,section,sheet,stock,thickness_mm,width_mm,height_mm,area_mm2,cut_mm,"
                      "engraved_mm,scored_mm,seconds\r\n";
    for (const CuttingSheet &sheet : drawing.sheets) {
        const auto stock =
            std::find_if(drawing.stocks.begin(), drawing.stocks.end(),
                         [&sheet](const Stock &one) { return one.id == sheet.stock; });
        const bool hasStock = stock != drawing.stocks.end();
        const std::vector<ToolWay> ways = waysOf(sheet, machineOf(drawing));
        for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
            const CuttingPart &part = sheet.parts[i];
            const auto listed = known.find(part.number());
            const Vec2 size = listed == known.end() ? Vec2(Vec2::Zero()) : listed->second->size;
            const double area = listed == known.end() ? 0.0 : listed->second->area;
            const std::array<std::string, 12> row = {
                std::to_string(part.number()),
                csvText(part.name()),
                std::to_string(sheet.number),
                hasStock ? csvText(stock->name) : std::string(),
                csvNumber(hasStock ? stock->thickness : 0.0, 3),
                csvNumber(size.x(), 3),
                csvNumber(size.y(), 3),
                csvNumber(area, 2),
                csvNumber(ways[i].cut, 2),
                csvNumber(ways[i].engraved, 2),
                csvNumber(ways[i].scored, 2),
                csvNumber(ways[i].seconds, 1)};
            for (std::size_t k = 0; k < row.size(); ++k)
                out.append(k > 0 ? "," : "").append(row[k]);
            out += "\r\n";
        }
    }
    return out;
}

const Format &partsCsvFormat()
{
    static const Format format = {.key = "csv",
                                  .suffixes = {"csv"},
                                  .title =
                                      QT_TRANSLATE_NOOP("Format", "Parts list for spreadsheets"),
                                  .help = QT_TRANSLATE_NOOP("CommandLine", "the list of parts"),
                                  .use = FileUse::Parts,
                                  .writeCutting = [](const CuttingDrawing &drawing,
                                                     const FormatValues &) -> Result<std::string> {
                                      return writePartsCsv(drawing);
                                  }};
    return format;
}

} // namespace fff::io
