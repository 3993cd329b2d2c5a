#include "core/io/svg_format.h"

#include "core/io/compressed.h"
#include "core/io/document_file.h"
#include "core/io/svg_reader.h"
#include "core/io/svg_writer.h"

#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

bool looksLikeXml(std::string_view bytes)
{
    const std::string_view text = withoutByteOrderMark(bytes);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && text[begin] == '<';
}

Result<SvgDrawing> read(std::string_view bytes, const std::string &name)
{
    if (!isCompressed(bytes))
        return readSvg(bytes, name);
    const Result<std::string> text =
        uncompressed(bytes, static_cast<std::size_t>(kMaxFileSize), name);
    return text ? readSvg(*text, name) : tl::unexpected(text.error());
}

} // namespace

const Format &svgFormat()
{
    static const Format format = {
        .key = "svg",
        .suffixes = {"svg", "svgz"},
        .title = QT_TRANSLATE_NOOP("Format", "SVG, true to size"),
        .titleOfSheets = QT_TRANSLATE_NOOP("Format", "SVG, one for each sheet"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "cutting files, true to size"),
        .isColoured = true,
        .recognises =
            [](std::string_view bytes) { return isCompressed(bytes) || looksLikeXml(bytes); },
        .readDrawing = read,
        .writeCutting = [](const CuttingDrawing &drawing, const FormatValues &)
            -> Result<std::string> { return writeSvg(drawing); }};
    return format;
}

} // namespace fff::io
