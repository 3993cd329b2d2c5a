// Cutting files for LightBurn.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/formats.h"

#include <string>

namespace fff::io {

/// A project (.lbrn2): all sheets in one plane (stacked_sheets.h), mm, y up.
///
///   layers    a CutSetting for each layer of the machine that something is on: its name, speed in
///             mm/s and power in percent, engraved before scored before inner before outer cuts;
///             what is not to be burnt is on T1
///   lines     in cutting order, a path each, closed where it is, none twice; curves are the
///             drawing's own cubics. Control points are absolute
///   notes     stocks, thicknesses, and whether the kerf is applied already
///
/// Coordinates to 1e-6 mm. UTF-8, same bytes for same input.
/// Source  no format is published: files of LightBurn 1.x, and what programs are known to write
/// that it opens (boxes.py).
std::string writeLightBurn(const CuttingDrawing &drawing);

const Format &lightBurnFormat();

} // namespace fff::io
