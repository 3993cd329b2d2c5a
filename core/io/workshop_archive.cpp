#include "core/io/workshop_archive.h"

#include "core/fabrication/fit_coupon.h"
#include "core/io/archive.h"
#include "core/io/coupon_words.h"
#include "core/io/parts_csv.h"
#include "core/io/png_writer.h"

#include <QtCore/QCoreApplication>

#include <utility>
#include <vector>

namespace fff::io {

namespace {

struct WorkshopFile
{
    std::string name, bytes;
};

/// In a way of the format: what is told it, and what its name ends in.
Result<WorkshopFile> fileOf(const Format &format, const CuttingDrawing &drawing,
                            const std::string &way, const FormatValues &values)
{
    const bool isList = &format == &partsCsvFormat();
    return format.writeCutting(drawing, values).map([&](std::string bytes) {
        return WorkshopFile{(isList ? "parts" : "sheets") + way + '.' + format.suffixes.front(),
                            std::move(bytes)};
    });
}

Result<void> addWays(const Format &format, const CuttingDrawing &drawing,
                     std::vector<WorkshopFile> &files)
{
    const auto add = [&](const std::string &way, const FormatValues &values) {
        return fileOf(format, drawing, way, values).map([&files](WorkshopFile file) {
            files.push_back(std::move(file));
        });
    };
    if (const Result<void> added = add({}, {}); !added)
        return added;
    for (const FormatOption &option : format.options)
        for (std::size_t i = 1; i < option.choices.size(); ++i)
            if (*option.choices[i].title != '\0')
                if (const Result<void> added = add(std::string("-") + option.choices[i].name,
                                                   {{option.name, static_cast<double>(i)}});
                    !added)
                    return added;
    return {};
}

/// In the usual way of each format of drawings. None where there can be no coupon: the sheets are
/// what was asked for.
Result<void> addCoupon(const CuttingDrawing &drawing, std::vector<WorkshopFile> &files)
{
    const auto coupon = fitCoupon(drawing.stocks, drawing.machine, couponWords());
    if (!coupon)
        return {};
    for (const Format *format : formatsThat(&Format::writesCutting)) {
        if (format == &workshopFormat() || format == &pngFormat() || format == &partsCsvFormat())
            continue;
        Result<std::string> bytes = format->writeCutting(*coupon, {});
        if (!bytes)
            return tl::unexpected(std::move(bytes.error()));
        files.push_back({std::string("coupon.") + format->suffixes.front(), *std::move(bytes)});
    }
    return {};
}

} // namespace

Result<std::string> writeWorkshopArchive(const CuttingDrawing &drawing)
{
    std::vector<WorkshopFile> files;
    for (const Format *format : formatsThat(&Format::writesCutting)) {
        if (format == &workshopFormat() || format == &pngFormat())
            continue;
        if (const Result<void> added = addWays(*format, drawing, files); !added)
            return tl::unexpected(added.error());
    }
    if (const Result<void> added = addCoupon(drawing, files); !added)
        return tl::unexpected(added.error());
    std::vector<PackedEntry> entries;
    for (const WorkshopFile &file : files)
        entries.push_back({file.name, file.bytes});
    return packed(entries);
}

const Format &workshopFormat()
{
    static const Format format = {
        .key = "zip",
        .suffixes = {"zip"},
        .title = QT_TRANSLATE_NOOP("Format", "All for the workshop, packed"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "all for a workshop"),
        .writeCutting = [](const CuttingDrawing &drawing, const FormatValues &) {
            return writeWorkshopArchive(drawing);
        }};
    return format;
}

} // namespace fff::io
