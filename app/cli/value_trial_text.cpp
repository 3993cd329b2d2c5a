#include "app/cli/value_trial_text.h"

#include "core/base/units.h"
#include "core/io/json_writer.h"
#include "core/operations/evaluate.h"
#include "core/session/message_text.h"
#include "core/values/number_text.h"

#include <QCoreApplication>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QString placeText(const ValueTrials &trials, const TriedPlace &place)
{
    QStringList values;
    for (const auto &[name, worth] : worthsAt(trials.values, place.at))
        values +=
            QString::fromStdString(name) + u' ' + argumentText(argumentOf(worth), metricUnits());
    QStringList faults;
    for (const Message &fault : place.faults)
        faults += messageText(fault);
    if (!place.wrong.isEmpty())
        faults += messageText(place.wrong);
    return QStringLiteral("  %1: %2")
        .arg(values.join(QStringLiteral(", ")), faults.join(QStringLiteral(", ")));
}

void writePlace(io::JsonWriter &json, const ValueTrials &trials, const TriedPlace &place)
{
    json.beginObject(io::JsonWriter::Layout::Line);
    json.key("values");
    json.beginObject(io::JsonWriter::Layout::Line);
    for (const auto &[name, worth] : worthsAt(trials.values, place.at)) {
        if (worth.type == Worth::Type::Text)
            json.member(name.c_str(), worth.text);
        else if (worth.type == Worth::Type::Truth)
            json.member(name.c_str(), worth.number != 0.0);
        else
            json.member(name.c_str(),
                        worth.powers == kAnglePowers ? degrees(worth.number) : worth.number);
    }
    json.endObject();
    json.member("holds", place.holds());
    for (const VerdictColumn &column : kVerdictColumns)
        json.member(column.name, nameOf(place.worstOf(column.subject)));
    if (!place.wrong.isEmpty())
        json.member("problem", messageText(place.wrong).toStdString());
    json.endObject();
}

} // namespace

ValueTrials triedValues(const Document &document, std::uint64_t seed)
{
    TrialExtent extent;
    extent.seed = seed;
    Progress progress;
    return tryValues(evaluate(document), {}, extent, progress, {}).value_or(ValueTrials());
}

QStringList trialsText(const ValueTrials &trials)
{
    if (trials.values.empty())
        return {tr("No value that others can adjust has a range and is used.")};
    QStringList lines{tr("Tried: %1 of %2 corners of the ranges, %3 variants between them.")
                          .arg(trials.corners)
                          .arg(trials.allCorners, 0, 'f', 0)
                          .arg(trials.places.size() - trials.corners)};
    const std::size_t failing = trials.failing();
    lines += failing == 0 ? tr("All of them are good.")
                          : tr("%1 of %2 fail:").arg(failing).arg(trials.places.size());
    for (const auto &[title, times] : trials.faults())
        lines += QStringLiteral("  %1: %2").arg(messageText(title)).arg(times);
    if (failing > 0)
        lines += tr("Where:");
    for (const std::size_t i : trials.worst())
        lines += placeText(trials, trials.places[i]);
    return lines;
}

void writeTrials(io::JsonWriter &json, const ValueTrials &trials)
{
    json.key("tried");
    json.beginObject();
    json.member("seed", static_cast<std::int64_t>(trials.extent.seed));
    json.member("corners", static_cast<std::int64_t>(trials.corners));
    json.member("allCorners", trials.allCorners);
    json.member("failing", static_cast<std::int64_t>(trials.failing()));
    json.key("places");
    json.beginArray();
    for (const TriedPlace &place : trials.places)
        writePlace(json, trials, place);
    json.endArray();
    json.endObject();
}

} // namespace fff::cli
