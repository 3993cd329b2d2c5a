// Cutting files for CAD and machines that read DXF.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/dxf_text.h"
#include "core/io/formats.h"

#include <string>

namespace fff::io {

/// All sheets in one plane (stacked_sheets.h), mm, y up.
///
///   units     $INSUNITS 4, $MEASUREMENT 1, and the box of all that is drawn. Programs that trust
///             no units get millimetres
///   layers    CUT, CUT_INNER, SCORE, ENGRAVE (what is drawn, and numbers), GUIDE (frames of
///   several
///             sheets, the bar), all declared, colours by layer: those of the machine, or the
///             nearest of AutoCAD's first seven
///   lines     in cutting order, sheet by sheet, each one polyline, closed where it is, none twice:
///             LWPOLYLINE, in R12 POLYLINE. Curves are arcs within kArcError as bulges; no splines,
///             which readers flatten each in its own way
///   no text, no blocks, no edge without length. What is known of stocks and kerf stands in
///   comments
///
/// Coordinates to 1e-6 mm. ASCII, same bytes for same input.
std::string writeDxf(const CuttingDrawing &drawing, DxfVersion version = DxfVersion::R2000);

const Format &dxfFormat();

} // namespace fff::io
