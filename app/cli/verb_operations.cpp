#include "app/cli/command_line.h"
#include "core/io/json_writer.h"
#include "core/operations/evaluate.h"
#include "core/session/operation_text.h"

namespace fff::cli {

namespace {

using io::JsonWriter;
using Unit = ParameterSpec::Unit;
using Layout = JsonWriter::Layout;

const char *unitName(Unit unit)
{
    switch (unit) {
    case Unit::Switch:
        return "switch";
    case Unit::Choice:
        return "choice";
    case Unit::Count:
        return "count";
    case Unit::Length:
        return "mm";
    case Unit::Angle:
        return "degrees";
    case Unit::Share:
        return "percent";
    case Unit::Number:
        break;
    }
    return "number";
}

void writeValue(JsonWriter &json, const ParameterSpec *spec, const ParameterValue &value)
{
    if (const double *number = std::get_if<double>(&value); number && spec)
        json.value(spokenValue(spec->unit, *number));
    else
        std::visit([&json](const auto &v) { json.value(v); }, value);
}

void writeParameter(JsonWriter &json, const ParameterSpec &spec, const Operation &standard)
{
    json.beginObject();
    json.member("key", spec.key);
    json.member("label", spec.label);
    json.member("unit", unitName(spec.unit));
    if (const std::optional<ParameterValue> value = valueOf(spec, standard)) {
        json.key("default");
        writeValue(json, &spec, *value);
    }
    if (spec.unit == Unit::Choice) {
        json.key("choices");
        json.beginArray(Layout::Line);
        for (const ChoiceSpec &choice : spec.choices)
            json.value(choice.key);
        json.endArray();
    } else if (spec.unit != Unit::Switch) {
        json.member("least", spokenValue(spec.unit, spec.least));
        json.member("most", spokenValue(spec.unit, spec.most));
    }
    if (spec.countsIf) {
        json.key("countsIf");
        json.beginObject(Layout::Line);
        json.key(spec.countsIf);
        json.beginArray(Layout::Line);
        for (const char *value : spec.countsFor)
            json.value(value);
        json.endArray();
        json.endObject();
    }
    json.endObject();
}

std::string kindsJson()
{
    JsonWriter json;
    json.beginObject();
    json.key("kinds");
    json.beginArray();
    for (const OperationKind *kind : operationKinds()) {
        json.beginObject();
        json.member("kind", kind->key);
        json.member("version", kind->version);
        json.member("name", kind->name);
        json.member("summary", kind->summary);
        json.member("command", "operation." + std::string(kind->key));
        json.key("inputs");
        json.beginArray();
        for (const InputSpec &input : kind->inputs) {
            json.beginObject(Layout::Line);
            json.member("role", input.role);
            json.member("label", input.label);
            json.member("least", input.least);
            json.member("most", input.most);
            json.endObject();
        }
        json.endArray();
        json.key("parameters");
        json.beginArray();
        const Operation standard = newOperation(*kind);
        for (const ParameterSpec &spec : kind->parameters)
            writeParameter(json, spec, standard);
        json.endArray();
        json.endObject();
    }
    json.endArray();
    json.endObject();
    return json.take();
}

QStringList kindsText()
{
    QStringList lines;
    const auto listed = [](const char *key, const char *label) {
        return QStringLiteral("    ") + QString::fromLatin1(key).leftJustified(14) +
               operationText(label);
    };
    for (const OperationKind *kind : operationKinds()) {
        lines +=
            QStringLiteral("%1: %2").arg(QLatin1String(kind->key), operationText(kind->summary));
        for (const InputSpec &input : kind->inputs)
            lines += listed(input.role, input.label);
        const Operation standard = newOperation(*kind);
        for (const ParameterSpec &spec : kind->parameters) {
            QString line = listed(spec.key, spec.label) + QStringLiteral(": ") +
                           QString::fromStdString(rangeText(spec));
            if (spec.unit == Unit::Length || spec.unit == Unit::Angle || spec.unit == Unit::Share)
                line += u' ' + QLatin1String(unitName(spec.unit));
            lines += line;
        }
    }
    return lines;
}

std::string modelJson(const Model &model, const QString &file)
{
    JsonWriter json;
    json.beginObject();
    json.member("file", file.toStdString());
    json.key("operations");
    json.beginArray();
    for (const OperationPointer &operation : model.document.operations) {
        const OperationKind *kind = operationKind(operation->kind);
        json.beginObject();
        json.member("id", operation->id.value);
        json.member("kind", operation->kind);
        json.member("name", operation->name);
        json.member("on", operation->isOn);
        json.key("inputs");
        json.beginObject();
        for (const auto &[role, inputs] : operation->inputs) {
            json.key(role);
            json.beginArray(Layout::Line);
            for (const OperationInput &input : inputs) {
                const std::string name = model.nameOf(input.section);
                json.value(name.empty() ? input.name : name);
            }
            json.endArray();
        }
        json.endObject();
        json.key("parameters");
        json.beginObject();
        for (const auto &[key, value] : operation->parameters) {
            json.key(key);
            writeValue(json, kind ? kind->parameter(key) : nullptr, value);
        }
        json.endObject();
        const OperationResult *result = model.resultOf(operation->id);
        json.key("sections");
        json.beginArray(Layout::Line);
        if (result)
            for (const SectionPointer &section : result->sections)
                json.value(section->name);
        json.endArray();
        json.key("notices");
        json.beginArray();
        if (result)
            for (const OperationNotice &notice : result->notices)
                json.value(noticeText(notice, *operation).toStdString());
        json.endArray();
        json.endObject();
    }
    json.endArray();
    json.endObject();
    return json.take();
}

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QStringList modelText(const Model &model)
{
    QStringList lines;
    if (model.document.operations.empty())
        lines += tr("The model has no operations.");
    for (const OperationPointer &operation : model.document.operations) {
        const OperationResult *result = model.resultOf(operation->id);
        const int count = result ? countOf(*result) : 0;
        const QString made =
            count == 1 ? tr("1 section")
                       : QCoreApplication::translate("CommandLine", "%n sections", nullptr, count);
        lines += QStringLiteral("%1: %2, %3")
                     .arg(QString::fromStdString(operation->name), kindName(*operation),
                          operation->isOn ? made : tr("off"));
        if (result)
            for (const OperationNotice &notice : result->notices)
                lines += QStringLiteral("    ") + noticeText(notice, *operation);
    }
    return lines;
}

} // namespace

int runOperations(const QStringList &arguments)
{
    const Verb &verb = verbNamed("operations");
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("json"), tr("Prints JSON, for other programs.")});
    addDocumentOptions(parser);
    // Without a file: what there is.
    const bool hasFile = std::any_of(arguments.begin(), arguments.end(),
                                     [](const QString &text) { return !text.startsWith(u'-'); });
    const Arguments found = parse(parser, verb, arguments, hasFile ? 1 : 0);
    if (found.status)
        return *found.status;
    const bool asJson = parser.isSet(QStringLiteral("json"));
    if (!hasFile)
        return asJson ? print(kindsJson()) : printLines(kindsText());
    std::optional<int> status;
    const std::optional<DocumentOptions> options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const Loaded loaded = load(found.files.front(), *options, verb);
    if (loaded.status)
        return *loaded.status;
    const Model model = evaluate(loaded.document);
    return asJson ? print(modelJson(model, found.files.front())) : printLines(modelText(model));
}

} // namespace fff::cli
