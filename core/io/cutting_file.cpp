#include "core/io/cutting_file.h"

#include "core/io/svg_writer.h"

namespace fff::io {

Result<CuttingFile> makeCuttingFile(const Analysis &analysis, const CuttingFileOptions &options)
{
    Result<Cutting> cutting = makeCutting(analysis, options);
    if (!cutting)
        return tl::unexpected(std::move(cutting.error()));
    CuttingFile file{*std::move(cutting), {}, {}};
    if (!options.isFilePerSheet) {
        file.svg = writeSvg(file.drawing);
        return file;
    }
    for (std::size_t i = 0; i < file.drawing.sheets.size(); ++i)
        file.sheets.push_back(writeSvg(onSheet(file.drawing, i)));
    return file;
}

} // namespace fff::io
