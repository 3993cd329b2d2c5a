// All that a workshop may ask for, in one file or in a folder.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/formats.h"

#include <string>
#include <vector>

namespace fff::io {

/// By their names in a folder: the sheets as every format of cutting files has them (formats.h) but
/// pictures and this one, under "sheets.SUFFIX", also in the ways that have titles of their own
/// ("sheets-a4.pdf"), and the list of parts as "parts.csv"; a fit coupon of
/// its stocks, where there can be one, as "coupon.SUFFIX" (fit_coupon.h). Same bytes for same
/// input. Errors  those of the formats.
Result<std::vector<NamedBytes>> workshopFiles(const CuttingDrawing &drawing);
/// As a ZIP. Names are ASCII. Errors  BadCount for more than a packed file holds.
Result<std::string> packedFiles(const std::vector<NamedBytes> &files);
/// Both.
Result<std::string> writeWorkshopArchive(const CuttingDrawing &drawing);

const Format &workshopFormat();

} // namespace fff::io
