// From an analysed model to the file that is cut. Used by the window's Export and by the command
// line's `export`, so that both write the same.
#pragma once

#include "core/analysis/cutting.h"
#include "core/io/file_set.h"
#include "core/io/formats.h"
#include "core/io/svg_format.h"

namespace fff::io {

struct CuttingFileOptions : CuttingOptions
{
    bool isFilePerSheet = false;         // else all sheets in one drawing, a group each
    const Format *format = &svgFormat(); // one that writes cutting files
    FormatValues values = {};            // of its options
    // Of a format that packs several files: each by itself, and what else goes with them.
    bool isUnpacked = false;
    std::vector<NamedBytes> enclosed = {};
};

struct CuttingFile : Cutting
{
    std::string whole;               // all sheets; empty where each has a file of its own
    std::vector<std::string> sheets; // the files of the sheets in their order, else empty
    std::vector<NamedBytes> several; // by names in a folder: where they are asked for unpacked
};

/// Errors  as makeCutting(), and those of the format.
Result<CuttingFile> makeCuttingFile(const Analysis &analysis, const CuttingFileOptions &options);
/// As is usual.
Result<CuttingFile> makeCuttingFile(const Analysis &analysis);

} // namespace fff::io
