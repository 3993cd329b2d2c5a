// Sections for a mesh, suggested: a model with the mesh as its template.
#include "app/cli/output.h"
#include "core/analysis/suggesting/suggestion.h"
#include "core/io/template_file.h"
#include "core/operations/evaluate.h"
#include "core/session/message_text.h"

#include <QFileInfo>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// The value of an option as a whole number, where it was given. Prints and sets `status` when it
/// is none within the limits.
std::optional<std::int64_t> wholeNumber(const QCommandLineParser &parser, const Verb &verb,
                                        const char *option, std::int64_t least, std::int64_t most,
                                        std::optional<int> &status)
{
    const QString name = QLatin1String(option);
    if (status || !parser.isSet(name))
        return std::nullopt;
    bool isNumber = false;
    const qlonglong value = parser.value(name).toLongLong(&isNumber);
    if (isNumber && value >= least && value <= most)
        return value;
    status = wrongUse(
        verb, tr("--%1: found \"%2\", expected a whole number from %3 to %4.")
                  .arg(name, parser.value(name), QString::number(least), QString::number(most)));
    return std::nullopt;
}

struct SuggestOptions
{
    SuggestionOptions what;
    double size = 0.0; // mm; 0: as the mesh's file says
};

std::optional<SuggestOptions> suggestOptions(const QCommandLineParser &parser, const Verb &verb,
                                             std::optional<int> &status)
{
    constexpr double kLeastSize = 0.001; // mm
    constexpr std::int64_t kMostSeed = 999'999'999;
    SuggestOptions options;
    if (const auto count = wholeNumber(parser, verb, "count", 1, kMostSuggested, status))
        options.what.count = static_cast<int>(*count);
    if (const auto seed = wholeNumber(parser, verb, "seed", 0, kMostSeed, status))
        options.what.seed = static_cast<std::uint64_t>(*seed);
    if (!status)
        options.size = number(parser, verb, "size", kLeastSize, status).value_or(0.0);
    return status ? std::nullopt : std::optional(options);
}

/// The mesh in an empty document.
Result<Document> documentWithMesh(Document document, const QString &file, double size)
{
    io::TemplateFileOptions options;
    options.size = size;
    const Result<io::LoadedTemplate> loaded = io::readTemplateFile(file, options);
    if (!loaded)
        return tl::unexpected(loaded.error());
    return loaded->addedTo(std::move(document));
}

} // namespace

int runSuggest(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("count"), tr("How many sections (8)."), QStringLiteral("N")});
    parser.addOption({QStringLiteral("seed"), tr("Another number gives other sections (1)."),
                      QStringLiteral("N")});
    parser.addOption({QStringLiteral("size"), tr("Scales the mesh to this largest extent first."),
                      QStringLiteral("MM")});
    addOutputOptions(parser);
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("suggest");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    if (const QString reason = whyNoOutput(parser); !reason.isEmpty())
        return wrongUse(verb, reason);
    std::optional<int> status;
    const std::optional<SuggestOptions> options = suggestOptions(parser, verb, status);
    if (!options)
        return *status;
    const auto ofDocument = documentOptions(parser, verb, status);
    if (!ofDocument)
        return *status;
    Document empty = newDocument();
    if (const auto wrong = applyOptions(empty, *ofDocument, verb))
        return *wrong;
    const QString &file = parsed.files.first();
    const Result<Document> document = documentWithMesh(std::move(empty), file, options->size);
    if (!document)
        return report(document.error());
    const Result<Suggestion> made =
        suggestSections(evaluate(*document), document->templates.front()->id, options->what);
    if (!made)
        return report(made.error());
    for (const Message &message : made->messages)
        printError(tr("%1: %2").arg(QFileInfo(file).fileName(), messageText(message)));
    return made->sections.empty() ? static_cast<int>(BadInput)
                                  : writeOutput(parser, verb, made->document, file);
}

} // namespace fff::cli
