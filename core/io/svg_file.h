// SVG drawings on disk.
#pragma once

#include "core/io/svg_reader.h"

#include <QtCore/QString>

namespace fff::io {

/// Reads `.svg`, and `.svgz`, which is the same packed with gzip: which of them it is is decided by
/// what is in it. Errors call it by its name without the folder.
/// Errors  those of readFile() and readSvg(), and of uncompressed() (core/io/compressed.h) for more
///         than kMaxFileSize when it is unpacked.
Result<SvgDrawing> readSvgFile(const QString &path);

} // namespace fff::io
