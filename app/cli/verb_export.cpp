#include "app/cli/output.h"

namespace fff::cli {

int runExport(const QStringList &arguments)
{
    QCommandLineParser parser;
    addOutputOptions(parser);
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("export");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    if (const QString reason = whyNoOutput(parser); !reason.isEmpty())
        return wrongUse(verb, reason);
    std::optional<int> status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const Loaded loaded = load(parsed.files.first(), *options, verb);
    return loaded.status ? *loaded.status
                         : writeOutput(parser, verb, loaded.document, parsed.files.first());
}

} // namespace fff::cli
