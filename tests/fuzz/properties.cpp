#include "tests/fuzz/properties.h"

#include "core/io/error_text.h"
#include "core/io/fff_file.h"
#include "tests/one_line.h"

#include <cstdio>
#include <cstdlib>

namespace fff::fuzz {

namespace {

void requireLine(const QString &text)
{
    require(!text.trimmed().isEmpty(), "a text is not empty");
    require(test::isOneLine(text), "a text is one line");
}

} // namespace

void require(bool holds, const char *what)
{
    if (holds)
        return;
    std::fprintf(stderr, "Does not hold: %s\n", what);
    std::abort();
}

void requireClear(const Error &error)
{
    require(!error.place.empty(), "an error names a place");
    requireLine(io::errorSentence(error));
    const QString text = io::errorText(error);
    requireLine(text);
    require(text.startsWith(QString::fromStdString(error.place)), "a text begins with the place");
}

void requireRoundTrip(const Document &document)
{
    const Result<std::string> written = io::writeFffFile(document);
    if (!written)
        std::fprintf(stderr, "%s\n", io::errorText(written.error()).toUtf8().constData());
    require(written.has_value(), "what was read can be written");
    const Result<io::LoadedDocument> again = io::readFffFile(*written, "again");
    if (!again)
        std::fprintf(stderr, "%s\n", io::errorText(again.error()).toUtf8().constData());
    require(again.has_value(), "what was written can be read");
    require(again->document == document, "what was written is read as the same document");
    for (const Warning &warning : again->warnings)
        std::fprintf(stderr, "%s\n", io::warningText(warning).toUtf8().constData());
    require(again->warnings.empty(), "what was written needs no mending");
}

} // namespace fff::fuzz
