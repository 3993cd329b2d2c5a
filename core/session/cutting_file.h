// From an analysed model to the file that is cut: parts, kerf, layout, drawing. Used by the
// window's Export and by the command line's `export`, so that both write the same.
#pragma once

#include "core/analysis/analysis.h"
#include "core/fabrication/layout.h"

#include <optional>
#include <string>
#include <vector>

namespace fff {

struct CuttingFileOptions
{
    LayoutOptions layout;
    bool compensatesKerf = true; // each cut path offset by half its stock's kerf
    bool isFilePerSheet = false; // else all sheets in one drawing, a group each
    bool hasReference = true;    // a 100 mm bar beside the sheets, to check the printed size
};

struct CuttingFile
{
    std::string svg;                 // all sheets; empty where each has a file of its own
    std::vector<std::string> sheets; // the files of the sheets in their order, else empty
    int partCount = 0;
    int sheetCount = 0;
    double usedShare = 0.0;             // of the sheets' area that parts cover, 0 … 1
    std::vector<std::string> oversized; // names of sections with a part that fits no sheet
    std::vector<std::string> unmarked; // names of sections with a part too slim to carry its number
    std::vector<std::string> unmarkedJoints; // the same for the numbers of all its joints
    std::vector<std::string> uncut;  // with a hole or a notch that is narrower than the kerf
    std::optional<double> slitWidth; // mm, the narrowest slit as drawn, kerf taken off; of any
};

/// Errors  NothingToExport for a model without sections; as haveParts(); MarksNotCut; ClosedSlit
/// for a slit that the kerf closes, CannotOffset for a part without a path, with the section's
/// name.
Result<CuttingFile> makeCuttingFile(const Analysis &analysis,
                                    const CuttingFileOptions &options = {});

} // namespace fff
