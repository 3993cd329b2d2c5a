// The list of parts for a workshop: CSV.
#pragma once

#include "core/fabrication/cutting_drawing.h"
#include "core/io/formats.h"

#include <string>

namespace fff::io {

/// A row for each part that lies on a sheet, sheet by sheet as they are cut, under a row of names:
///
///   number, section, sheet, stock     as engraved; names as they are
///   thickness_mm, width_mm, height_mm, area_mm2     as designed: without the kerf
///   cut_mm, engraved_mm, scored_mm, seconds         along the paths of the file, by the machine's
///                                                   speeds, without the ways between parts
///
/// Commas, a point in numbers, quotes where a text has a comma, a quote or a line's end, each row
/// closed by CR LF. UTF-8, same bytes for same input. Source  RFC 4180.
std::string writePartsCsv(const CuttingDrawing &drawing);

const Format &partsCsvFormat();

} // namespace fff::io
