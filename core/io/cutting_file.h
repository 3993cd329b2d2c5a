// From an analysed model to the file that is cut. Used by the window's Export and by the command
// line's `export`, so that both write the same.
#pragma once

#include "core/analysis/cutting.h"

namespace fff::io {

struct CuttingFileOptions : CuttingOptions
{
    bool isFilePerSheet = false; // else all sheets in one drawing, a group each
};

struct CuttingFile : Cutting
{
    std::string svg;                 // all sheets; empty where each has a file of its own
    std::vector<std::string> sheets; // the files of the sheets in their order, else empty
};

/// Errors  as makeCutting().
Result<CuttingFile> makeCuttingFile(const Analysis &analysis,
                                    const CuttingFileOptions &options = {});

} // namespace fff::io
