// Cutting files in true size: SVG in millimetres.
#pragma once

#include "core/fabrication/cutting_drawing.h"

#include <string>

namespace fff::io {

/// One drawing of all sheets, stacked from top to bottom, 10 mm apart.
///
///   units      root width and height in mm, viewBox "0 0 width height": one user unit is 1 mm
///   colours    those of the machine, and its width of lines; here the usual ones
///   cuts       red (#ff0000), 0.05 mm wide, no fill, every boundary a path of its own closed by Z,
///              holes of a part before its outside, as they are to be cut; curves as C, straight
///              edges as L
///   numbers    blue (#0000ff), one path a part of open subpaths
///   marks      what people drew on sections, a path a line: engraved black (#000000), scored green
///              (#00ff00)
///   guides     yellow (#ffcc00): frames of the sheets when there are several, the reference bar
///   groups     <g id="sheet-1"> holds <g id="part-7">, whose <title> is its section's name
///   metadata   the program's version, each stock with its thickness, clearance and kerf, and
///              whether the kerf is applied already
///
/// Coordinates of cuts are rounded to 1e-6 mm, those of numbers to 1e-3 mm; y downwards. UTF-8,
/// same bytes for same input. Colours and the rest follow what laser programs read; see
/// core/README.md.
std::string writeSvg(const CuttingDrawing &drawing);

} // namespace fff::io
