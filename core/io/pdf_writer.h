// Cutting files on paper, or for machines that take PDF.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/formats.h"

#include <string>

namespace fff::io {

enum class PdfPaper {
    Sheets, // a page as large as each sheet
    A4,     // the sheets in tiles, for scissors
    Letter  // the same
};

/// In true size; colours and the width of lines by the machine, on paper wide enough to be seen.
///
///   sheets  a page each, the lines in cutting order; behind them, where the drawing has a bar to
///           measure, a page with it
///   tiles   of what is drawn on each sheet, on paper with margins of 10 mm: pages called A1, B1, …
///           A2 from the upper left; each has its name, that of its sheet, and a box of 50 mm to
///           measure. Neighbours share 10 mm: along dashed lines in the middle of that both are cut
///           off and glued, and crosses on them lie on each other. Pages with nothing on them are
///           left out; upright or not, whichever takes fewer
///
/// Curves are the drawing's cubics, to 1 µm. The words are those of the language that is set, in
/// Latin-1. Same bytes for same input.
std::string writePdf(const CuttingDrawing &drawing, PdfPaper paper = PdfPaper::Sheets);

const Format &pdfFormat();

} // namespace fff::io
