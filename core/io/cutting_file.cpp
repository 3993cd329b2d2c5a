#include "core/io/cutting_file.h"

#include "core/io/workshop_archive.h"

namespace fff::io {

namespace {

Result<void> addSeveral(CuttingFile &file, const CuttingFileOptions &options)
{
    Result<std::vector<NamedBytes>> several = options.format->writeUnpacked(file.drawing);
    if (!several)
        return tl::unexpected(std::move(several.error()));
    several->insert(several->end(), options.enclosed.begin(), options.enclosed.end());
    if (options.isUnpacked) {
        file.several = *std::move(several);
        return {};
    }
    return packedFiles(*several).map([&file](std::string bytes) { file.whole = std::move(bytes); });
}

} // namespace

Result<CuttingFile> makeCuttingFile(const Analysis &analysis, const CuttingFileOptions &options)
{
    Result<Cutting> cutting = makeCutting(analysis, options);
    if (!cutting)
        return tl::unexpected(std::move(cutting.error()));
    CuttingFile file{*std::move(cutting), {}, {}, {}};
    if (options.format->writeUnpacked && (options.isUnpacked || !options.enclosed.empty())) {
        const Result<void> added = addSeveral(file, options);
        if (!added)
            return tl::unexpected(added.error());
        return file;
    }
    if (!options.isFilePerSheet) {
        Result<std::string> whole = options.format->writeCutting(file.drawing, options.values);
        if (!whole)
            return tl::unexpected(std::move(whole.error()));
        file.whole = *std::move(whole);
        return file;
    }
    for (std::size_t i = 0; i < file.drawing.sheets.size(); ++i) {
        Result<std::string> sheet =
            options.format->writeCutting(onSheet(file.drawing, i), options.values);
        if (!sheet)
            return tl::unexpected(std::move(sheet.error()));
        file.sheets.push_back(*std::move(sheet));
    }
    return file;
}

Result<CuttingFile> makeCuttingFile(const Analysis &analysis)
{
    const CuttingFileOptions usual;
    return makeCuttingFile(analysis, usual);
}

} // namespace fff::io
