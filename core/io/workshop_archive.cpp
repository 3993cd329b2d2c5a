#include "core/io/workshop_archive.h"

#include "core/fabrication/fit_coupon.h"
#include "core/io/archive.h"
#include "core/io/coupon_words.h"
#include "core/io/file_set.h"
#include "core/io/parts_csv.h"
#include "core/io/png_writer.h"

#include <QtCore/QCoreApplication>

#include <utility>
#include <vector>

namespace fff::io {

namespace {

/// In a way of the format: what is told it, and what its name ends in.
Result<NamedBytes> fileOf(const Format &format, const CuttingDrawing &drawing,
                          const std::string &way, const FormatValues &values)
{
    const bool isList = &format == &partsCsvFormat();
    return format.writeCutting(drawing, values).map([&](std::string bytes) {
        return NamedBytes{QString::fromStdString((isList ? "parts" : "sheets") + way + '.' +
                                                 format.suffixes.front()),
                          std::move(bytes)};
    });
}

Result<void> addWays(const Format &format, const CuttingDrawing &drawing,
                     std::vector<NamedBytes> &files)
{
    const auto add = [&](const std::string &way, const FormatValues &values) {
        return fileOf(format, drawing, way, values).map([&files](NamedBytes file) {
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
Result<void> addCoupon(const CuttingDrawing &drawing, std::vector<NamedBytes> &files)
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
        files.push_back({QStringLiteral("coupon.") + format->suffix(), *std::move(bytes)});
    }
    return {};
}

} // namespace

Result<std::vector<NamedBytes>> workshopFiles(const CuttingDrawing &drawing)
{
    std::vector<NamedBytes> files;
    for (const Format *format : formatsThat(&Format::writesCutting)) {
        if (format == &workshopFormat() || format == &pngFormat())
            continue;
        if (const Result<void> added = addWays(*format, drawing, files); !added)
            return tl::unexpected(added.error());
    }
    if (const Result<void> added = addCoupon(drawing, files); !added)
        return tl::unexpected(added.error());
    return files;
}

Result<std::string> packedFiles(const std::vector<NamedBytes> &files)
{
    std::vector<PackedEntry> entries;
    for (const NamedBytes &file : files)
        entries.push_back({file.path.toStdString(), file.bytes});
    return packed(entries);
}

Result<std::string> writeWorkshopArchive(const CuttingDrawing &drawing)
{
    return workshopFiles(drawing).and_then(packedFiles);
}

const Format &workshopFormat()
{
    static const Format format = {
        .key = "zip",
        .suffixes = {"zip"},
        .title = QT_TRANSLATE_NOOP("Format", "All for the workshop, packed"),
        .titleOfFolder = QT_TRANSLATE_NOOP("Format", "All for the workshop, in a folder"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "all for a workshop"),
        .use = FileUse::Workshop,
        .isColoured = true,
        .writeCutting = [](const CuttingDrawing &drawing,
                           const FormatValues &) { return writeWorkshopArchive(drawing); },
        .writeUnpacked = workshopFiles};
    return format;
}

} // namespace fff::io
