#include "app/cli/command_line.h"
#include "app/cli/info.h"
#include "core/operations/evaluate.h"

namespace fff::cli {

int runInfo(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.addOption(
        {QStringLiteral("json"), QCoreApplication::translate("CommandLine", "For machines.")});
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("info");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    Loaded loaded = load(parsed.files.first(), *options, verb);
    if (loaded.status)
        return *loaded.status;
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(std::move(loaded.document)), caches);
    const InfoContext context{parsed.files.first().toStdString(), loaded.format};
    return print(parser.isSet(QStringLiteral("json")) ? infoJson(analysis, context)
                                                      : infoText(analysis, context));
}

} // namespace fff::cli
