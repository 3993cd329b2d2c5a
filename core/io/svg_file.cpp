#include "core/io/svg_file.h"

#include "core/io/compressed.h"
#include "core/io/document_file.h"

#include <QtCore/QFileInfo>

namespace fff::io {

Result<SvgDrawing> readSvgFile(const QString &path)
{
    const std::string name = QFileInfo(path).fileName().toStdString();
    Result<std::string> bytes = readFile(path, name);
    if (bytes && isCompressed(*bytes))
        bytes = uncompressed(*bytes, static_cast<std::size_t>(kMaxFileSize), name);
    if (!bytes)
        return tl::unexpected(bytes.error());
    return readSvg(*bytes, name);
}

} // namespace fff::io
