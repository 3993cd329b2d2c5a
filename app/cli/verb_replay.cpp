#include "app/cli/mesh_options.h"
#include "app/cli/output.h"

#include "core/interaction/interaction.h"
#include "core/session/replay.h"
#include "core/session/session_host.h"

namespace fff::cli {

int runReplay(const QStringList &arguments)
{
    QCommandLineParser parser;
    const auto tr = [](const char *text) {
        return QCoreApplication::translate("CommandLine", text);
    };
    parser.addOption({QStringLiteral("from"), tr("The model to start from; without it a new one."),
                      QStringLiteral("FILE")});
    addTemplateOption(parser);
    addOutputOptions(parser);
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("replay");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    if (const QString reason = whyNoOutput(parser); !reason.isEmpty())
        return wrongUse(verb, reason);

    std::optional<int> status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;

    Session session;
    SessionHost host(session);
    Interaction interaction(host);
    Document document = newDocument();
    if (parser.isSet(QStringLiteral("from"))) {
        Loaded loaded = load(parser.value(QStringLiteral("from")), *options, verb);
        if (loaded.status)
            return *loaded.status;
        document = std::move(loaded.document);
    } else if (const auto wrong = applyOptions(document, *options, verb)) {
        return *wrong;
    }
    if (const auto wrong = addTemplates(document, parser, verb))
        return *wrong;
    session.reset(std::move(document));

    const Result<std::string> script = io::readFile(parsed.files.first());
    if (!script)
        return report(script.error());
    const Result<void> run = replay(QByteArray::fromStdString(*script), session, interaction);
    if (!run) {
        Error error = run.error();
        error.place =
            parsed.files.first().toStdString() + (error.place.empty() ? "" : ":") + error.place;
        return report(error);
    }
    return writeOutput(parser, verb, session.committed().document, parsed.files.first());
}

} // namespace fff::cli
