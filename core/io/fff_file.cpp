#include "core/io/fff_file.h"

#include "core/io/fff_format.h"

#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

bool looksLikeFff(std::string_view bytes)
{
    const std::string_view text = withoutByteOrderMark(bytes);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    // Text has no zero bytes; what has is a picture, a program or the like.
    return begin != std::string_view::npos && text[begin] == '{' &&
           text.find('\0') == std::string_view::npos;
}

} // namespace

const Format &fffFormat()
{
    static const Format format = {
        .key = "fff",
        .suffixes = {"fff"},
        .title = QT_TRANSLATE_NOOP("Format", "FlatFitFab models"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "the model itself"),
        .recognises = looksLikeFff,
        .readModel = [](std::string_view bytes, const std::string &name,
                        const ReadOptions &) { return readFff(bytes, name); },
        .writeModel = [](const Document &document,
                         const FormatValues &) { return writeFff(document); }};
    return format;
}

} // namespace fff::io
