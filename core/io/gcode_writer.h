// Cutting files for machines that are told each move: G-code as GRBL reads it.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/formats.h"

#include <string>

namespace fff::io {

/// Sheet by sheet, mm, the sheet's lower left corner at X0 Y0.
///
///   frame     the machine's lines before and behind (Machine::GCode); before every further sheet
///             those that wait until it lies there
///   lines     in cutting order, none twice: G0 to its start, the machine's `on` with the power of
///             its purpose as S, G1, G2 and G3 along it with the feed of its purpose, `off`.
///             Guides are not followed
///   arcs      within kArcError of the curves, their centres as I and J. Those of more than 2 m
///             radius are edges, as GRBL reckons with seven digits
///   comments  behind a semicolon, ASCII: sheet, stock, thickness, kerf, the number of each part
///             before its outside
///
/// Coordinates to 1e-4 mm. Same bytes for same input.
/// Source  GRBL v1.1 documentation, commands and laser mode ($32 = 1, M4).
std::string writeGCode(const CuttingDrawing &drawing);

const Format &gcodeFormat();

} // namespace fff::io
