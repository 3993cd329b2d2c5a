#include "app/cli/analysed_file.h"

#include "core/operations/evaluate.h"

namespace fff::cli {

AnalysedFile analysedFile(const char *verbName, const QStringList &arguments)
{
    QCommandLineParser parser;
    return analysedFile(verbName, arguments, parser);
}

AnalysedFile analysedFile(const char *verbName, const QStringList &arguments,
                          QCommandLineParser &parser)
{
    AnalysedFile result;
    parser.addOption(
        {QStringLiteral("json"),
         QCoreApplication::translate("CommandLine", "Prints JSON, for other programs.")});
    addDocumentOptions(parser);
    const Verb &verb = verbNamed(verbName);
    const Arguments parsed = parse(parser, verb, arguments, 1);
    result.status = parsed.status;
    if (result.status)
        return result;
    const auto options = documentOptions(parser, verb, result.status);
    if (!options)
        return result;
    result.file = parsed.files.first();
    Loaded loaded = load(result.file, *options, verb);
    result.status = loaded.status;
    if (result.status)
        return result;
    result.format = std::move(loaded.format);
    result.warnings = std::move(loaded.warnings);
    AnalysisCaches caches;
    result.analysis = analyse(evaluate(std::move(loaded.document)), caches);
    result.asJson = parser.isSet(QStringLiteral("json"));
    return result;
}

} // namespace fff::cli
