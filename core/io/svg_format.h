// SVG among the formats (core/io/formats.h): read by svg_reader.h, written by svg_writer.h.
#pragma once

#include "core/io/formats.h"

namespace fff::io {

/// Drawings, also packed with gzip (`.svgz`), and cutting files. Errors when reading: those of
/// readSvg(), and of uncompressed() (core/io/compressed.h) for more than kMaxFileSize when it is
/// unpacked.
const Format &svgFormat();

} // namespace fff::io
