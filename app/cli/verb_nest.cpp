// The parts of a model close together on its sheets, or a problem of strip packing.
#include "app/cli/nest.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace fff::cli {

namespace {

using nest::Turning;

constexpr double kMostSeconds = 3600.0;
constexpr double kMostSeed = 4294967295.0;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

std::optional<Turning> turningNamed(const QString &name)
{
    if (name == QStringLiteral("none"))
        return Turning::None;
    if (name == QStringLiteral("180"))
        return Turning::Half;
    if (name == QStringLiteral("90"))
        return Turning::Quarter;
    return name == QStringLiteral("free") ? std::optional(Turning::Free) : std::nullopt;
}

void addNestOptions(QCommandLineParser &parser)
{
    const auto add = [&](const char *name, const QString &text, const char *value) {
        parser.addOption({QLatin1String(name), text, QLatin1String(value)});
    };
    parser.addOption({QStringLiteral("json"), tr("Prints JSON, for other programs.")});
    add("seconds", tr("How long to search (10); 0 takes the first layout."), "S");
    add("seed", tr("Another number gives another layout, the same one the same."), "N");
    add("rotations", tr("How parts may be turned: none, 180, 90 or free."), "HOW");
    add("margin", tr("From the sheet's edge to the nearest cut."), "MM");
    add("spacing", tr("Between neighbouring cuts."), "MM");
}

/// Nothing, and `status` to return, when an option makes no sense.
std::optional<NestAsked> nestAsked(const QCommandLineParser &parser, const Verb &verb,
                                   std::optional<int> &status)
{
    NestAsked asked;
    asked.asJson = parser.isSet(QStringLiteral("json"));
    asked.seconds =
        number(parser, verb, "seconds", 0.0, status, kMostSeconds).value_or(kNestSeconds);
    if (!status) {
        const double seed = number(parser, verb, "seed", 0.0, status, kMostSeed).value_or(1.0);
        asked.seed = static_cast<std::uint64_t>(std::max(0.0, seed));
    }
    if (!status)
        asked.margin = number(parser, verb, "margin", 0.0, status);
    if (!status)
        asked.spacing = number(parser, verb, "spacing", 0.0, status);
    if (const QString name = parser.value(QStringLiteral("rotations"));
        !status && parser.isSet(QStringLiteral("rotations"))) {
        asked.turning = turningNamed(name);
        if (!asked.turning)
            status = wrongUse(
                verb, tr("--rotations: found \"%1\", expected none, 180, 90 or free.").arg(name));
    }
    return status ? std::nullopt : std::optional(asked);
}

} // namespace

int runNest(const QStringList &arguments)
{
    QCommandLineParser parser;
    addNestOptions(parser);
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("nest");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    const auto asked = nestAsked(parser, verb, status);
    if (!asked)
        return *status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const QString file = parsed.files.first();
    return QFileInfo(file).suffix().compare(QStringLiteral("json"), Qt::CaseInsensitive) == 0
               ? nestInstance(file, *asked)
               : nestModel(file, *options, *asked, verb);
}

} // namespace fff::cli
