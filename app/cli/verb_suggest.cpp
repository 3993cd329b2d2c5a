// Sections for a mesh, suggested: a model with the mesh as its template.
#include "app/cli/mesh_options.h"
#include "core/analysis/suggesting/suggestion.h"
#include "core/operations/evaluate.h"
#include "core/session/message_text.h"

#include <QFileInfo>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

SuggestionOptions askedSuggestion(const QCommandLineParser &parser, const Verb &verb,
                                  std::optional<int> &status)
{
    constexpr int kMostSeed = 999'999'999;
    SuggestionOptions options;
    if (const auto count = wholeNumber(parser, verb, "count", 1, kMostSuggested, status))
        options.count = *count;
    if (status)
        return options;
    if (const auto seed = wholeNumber(parser, verb, "seed", 0, kMostSeed, status))
        options.seed = static_cast<std::uint64_t>(*seed);
    return options;
}

} // namespace

int runSuggest(const QStringList &arguments)
{
    QCommandLineParser parser;
    addMeshModelOptions(parser);
    parser.addOption({QStringLiteral("count"), tr("How many sections (8)."), QStringLiteral("N")});
    parser.addOption({QStringLiteral("seed"), tr("Another number gives other sections (1)."),
                      QStringLiteral("N")});
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("suggest");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    const SuggestionOptions asked = askedSuggestion(parser, verb, status);
    if (status)
        return *status;
    const QString &file = parsed.files.first();
    MeshModel started = readMeshModel(file, parser, verb);
    if (started.status)
        return *started.status;
    const TemplateId of = started.document.templates.front()->id;
    const Result<Suggestion> made =
        suggestSections(evaluate(std::move(started.document)), of, asked);
    if (!made)
        return report(made.error());
    for (const Message &message : made->messages)
        printError(tr("%1: %2").arg(QFileInfo(file).fileName(), messageText(message)));
    return made->sections.empty() ? static_cast<int>(BadInput)
                                  : writeMeshModel(made->document, parser);
}

} // namespace fff::cli
