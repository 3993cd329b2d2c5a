// A format that is added to the table (core/io/formats.h) by a file of its own, this one, and a
// line, an AddedFormat: where formats are read from the table, it has to be seen.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/formats.h"
#include "core/io/svg_reader.h"
#include "core/model/edits.h"

namespace fff::test {

/// A model is "knots N", N plates beside each other; a drawing "knots N", with N texts; what is cut
/// is counted.
inline const io::Format &addedFormat()
{
    static constexpr const char *kOption = "knots-in-a-row";
    static const auto countIn = [](std::string_view bytes) {
        return std::atoi(std::string(bytes.substr(6)).c_str());
    };
    static const io::Format format = {
        .key = "knots",
        .suffixes = {"knots"},
        .program = "Knots",
        .title = "Knots",
        .titleOfSheets = "Knots, one file for each sheet",
        .help = "knots to tie",
        .options = {{.name = kOption,
                     .value = "COUNT",
                     .help = "Knots in a row (7).",
                     .least = 1,
                     .most = 9}},
        .recognises = [](std::string_view bytes) { return bytes.starts_with("knots "); },
        .readModel = [](std::string_view bytes, const std::string &,
                        const io::ReadOptions &) -> Result<io::LoadedDocument> {
            Document document = newDocument();
            for (int i = 0; i < countIn(bytes); ++i) {
                NewSection section;
                section.shape =
                    *Shape::make(*Contour::fromPolygon({{0, 0}, {50, 0}, {50, 40}, {0, 40}}));
                section.frame.origin.z() = 20.0 * i;
                document = *addSection(std::move(document), std::move(section));
            }
            return io::LoadedDocument{std::move(document), {}};
        },
        .readDrawing = [](std::string_view bytes, const std::string &) -> Result<io::SvgDrawing> {
            io::SvgDrawing drawing;
            drawing.texts = countIn(bytes);
            return drawing;
        },
        .writeCutting = [](const CuttingDrawing &drawing,
                           const io::FormatValues &values) -> Result<std::string> {
            std::size_t parts = 0;
            for (const auto &sheet : drawing.sheets)
                parts += sheet.parts.size();
            const auto option = values.find(kOption);
            return std::to_string(parts) + " parts in rows of " +
                   std::to_string(option == values.end() ? 7 : static_cast<int>(option->second)) +
                   "\n";
        }};
    return format;
}

} // namespace fff::test
