#include "app/cli/command_line.h"
#include "app/cli/value_trial_text.h"
#include "core/io/json_writer.h"
#include "core/model/value_names.h"
#include "core/operations/driven.h"
#include "core/session/message_text.h"
#include "core/values/number_text.h"
#include "core/values/presets.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace fff::cli {

namespace {

using io::JsonWriter;

constexpr double kMostTrialSeed = 1e9;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// Without what radians leave of rounding: 30, not 29.999999999999996.
double inDegrees(double angle)
{
    constexpr double kDigits = 1e9;
    return std::round(degrees(angle) * kDigits) / kDigits;
}

void writeWorth(JsonWriter &json, const Worth &worth)
{
    if (worth.type == Worth::Type::Text)
        json.value(worth.text);
    else if (worth.type == Worth::Type::Truth)
        json.value(worth.number != 0.0);
    else if (worth.powers == kAnglePowers)
        json.value(inDegrees(worth.number));
    else
        json.value(worth.number);
}

double shownIn(ValueKind kind, double number)
{
    return kind == ValueKind::Angle ? inDegrees(number) : number;
}

void writeRange(JsonWriter &json, const Value &value)
{
    for (const auto &[key, bound] :
         {std::pair{"least", value.range.least}, std::pair{"most", value.range.most},
          std::pair{"step", value.range.step}})
        if (bound)
            json.member(key, shownIn(value.kind, *bound));
    if (value.choices.empty())
        return;
    json.key("choices");
    json.beginArray(JsonWriter::Layout::Line);
    for (const std::string &choice : value.choices)
        json.value(choice);
    json.endArray();
}

void writeNamedValue(JsonWriter &json, const Value &value, const Driven &model)
{
    json.beginObject(JsonWriter::Layout::Line);
    json.member("name", value.name);
    json.member("kind", nameIn(kValueKindNames, value.kind));
    json.member("typed", value.typed);
    if (const Worth *worth = model.values.worth(value.id)) {
        json.key("value");
        writeWorth(json, *worth);
    }
    if (const ExpressionError *error = model.values.error(value.id))
        json.member("error", messageText(error->message).toStdString());
    writeRange(json, value);
    if (!value.note.empty())
        json.member("note", value.note);
    if (!value.group.empty())
        json.member("group", value.group);
    json.member("shown", value.isShown);
    json.endObject();
}

void writePreset(JsonWriter &json, const Preset &preset, const Values &values)
{
    json.beginObject(JsonWriter::Layout::Line);
    json.member("name", preset.name);
    json.key("settings");
    json.beginObject(JsonWriter::Layout::Line);
    for (const Setting &setting : preset.settings)
        if (const Value *value = values.find(setting.value))
            json.member(value->name.c_str(), setting.typed);
    json.endObject();
    json.endObject();
}

void writeDrivenNumber(JsonWriter &json, const Binding &binding, const Driven &model)
{
    json.beginObject(JsonWriter::Layout::Line);
    json.member("place", keyOf(binding.place));
    json.member("name", messageText(nameOf(model.document, binding.place)).toStdString());
    json.member("typed", binding.typed);
    json.key("value");
    writeWorth(json, binding.result);
    for (const DrivingError &error : model.errors)
        if (error.place == binding.place)
            json.member("error", messageText(error.sentence).toStdString());
    json.endObject();
}

std::string valuesJson(const Driven &model, const QString &file,
                       const std::optional<ValueTrials> &tried)
{
    JsonWriter json;
    json.beginObject();
    json.member("file", file.toStdString());
    if (model.document.opensForAdjusting)
        json.member("opensForAdjusting", true);
    json.key("values");
    json.beginArray();
    for (const ValuePointer &known : model.document.values.list)
        writeNamedValue(json, known->value, model);
    json.endArray();
    if (!model.document.values.presets.empty()) {
        json.key("presets");
        json.beginArray();
        for (const PresetPointer &preset : model.document.values.presets)
            writePreset(json, *preset, model.document.values);
        json.endArray();
    }
    json.key("driven");
    json.beginArray();
    for (const BindingPointer &pointer : model.document.bindings)
        writeDrivenNumber(json, pointer->binding, model);
    json.endArray();
    if (tried)
        writeTrials(json, *tried);
    json.endObject();
    return json.take();
}

QString worthText(const Worth &worth)
{
    return argumentText(argumentOf(worth));
}

QString rangeOf(const Value &value, const Worth &like)
{
    const auto text = [&like](const std::optional<double> &bound) {
        Worth worth = like;
        worth.number = bound.value_or(0.0);
        return bound ? worthText(worth) : QStringLiteral("…");
    };
    if (!value.range.least && !value.range.most)
        return {};
    return QStringLiteral(" (%1 – %2)").arg(text(value.range.least), text(value.range.most));
}

QStringList valuesText(const Driven &model)
{
    QStringList lines;
    for (const ValuePointer &known : model.document.values.list) {
        const Value &value = known->value;
        const Worth *worth = model.values.worth(value.id);
        QString line = QString::fromStdString(value.name) + QStringLiteral(" = ");
        if (worth)
            line += worthText(*worth) + rangeOf(value, *worth);
        else
            line += messageText(model.values.error(value.id)->message);
        if (!known->typed || !known->typed->isConstant())
            line += QStringLiteral("  [%1]").arg(QString::fromStdString(value.typed));
        if (!value.note.empty())
            line += QStringLiteral("  ") + QString::fromStdString(value.note);
        lines += line;
    }
    QStringList presets;
    for (const PresetPointer &preset : model.document.values.presets)
        presets += QString::fromStdString(preset->name);
    if (const Preset *used = presetInUse(model.document.values))
        //: %1 are names of presets of values, %2 is the one that is set
        lines += tr("Presets: %1. It is set to %2.")
                     .arg(presets.join(QStringLiteral(", ")), QString::fromStdString(used->name));
    else if (!presets.isEmpty())
        lines += tr("Presets: %1").arg(presets.join(QStringLiteral(", ")));
    for (const BindingPointer &pointer : model.document.bindings) {
        const Binding &binding = pointer->binding;
        lines += QStringLiteral("%1: %2  [%3]")
                     .arg(messageText(nameOf(model.document, binding.place)),
                          worthText(binding.result), QString::fromStdString(binding.typed));
    }
    for (const DrivingError &error : model.errors)
        lines += messageText(error.sentence);
    if (lines.isEmpty())
        lines += tr("The model has no values with names.");
    return lines;
}

} // namespace

int runValues(const QStringList &arguments)
{
    const Verb &verb = verbNamed("values");
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("json"), tr("Prints JSON, for other programs.")});
    parser.addOption(
        {QStringLiteral("try"), tr("Tries the ranges of the values that others can adjust.")});
    parser.addOption({QStringLiteral("seed"),
                      tr("Another number tries other places, the same one the same."),
                      QStringLiteral("N")});
    addDocumentOptions(parser);
    const Arguments found = parse(parser, verb, arguments, 1);
    if (found.status)
        return *found.status;
    std::optional<int> status;
    const std::optional<DocumentOptions> options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const double seed = number(parser, verb, "seed", 0.0, status, kMostTrialSeed).value_or(1.0);
    if (status)
        return *status;
    Loaded loaded = load(found.files.front(), *options, verb);
    if (loaded.status)
        return *loaded.status;
    const Driven model = driven(std::move(loaded.document));
    std::optional<ValueTrials> tried;
    if (parser.isSet(QStringLiteral("try")))
        tried = triedValues(model.document, static_cast<std::uint64_t>(seed));
    const int printed = parser.isSet(QStringLiteral("json"))
                            ? print(valuesJson(model, found.files.front(), tried))
                            : printLines(tried ? trialsText(*tried) : valuesText(model));
    return printed == Done && tried && tried->failing() > 0 ? ProblemsFound : printed;
}

} // namespace fff::cli
