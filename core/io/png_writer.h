// Sheets as a picture: to look at, to send along.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/formats.h"

#include <string>

namespace fff::io {

/// All sheets in one plane (stacked_sheets.h) on white, with their frames, in the machine's
/// colours. Eight pixels a mm, or as many as make no side longer than 8192; the file says how large
/// a pixel is. Errors  NotWorkedOut where there is no memory for it.
Result<std::string> writePng(const CuttingDrawing &drawing);

const Format &pngFormat();

} // namespace fff::io
