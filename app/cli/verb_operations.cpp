#include "app/cli/command_line.h"
#include "core/io/json_writer.h"
#include "core/operations/evaluate.h"
#include "core/session/operation_text.h"

#include <QTextStream>

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

std::string kindsText()
{
    QString text;
    QTextStream out(&text);
    for (const OperationKind *kind : operationKinds()) {
        out << kind->key << ": " << operationText(kind->summary) << '\n';
        for (const InputSpec &input : kind->inputs)
            out << "    " << QString::fromLatin1(input.role).leftJustified(14)
                << operationText(input.label) << '\n';
        const Operation standard = newOperation(*kind);
        for (const ParameterSpec &spec : kind->parameters) {
            out << "    " << QString::fromLatin1(spec.key).leftJustified(14)
                << operationText(spec.label) << ": " << QString::fromStdString(rangeText(spec));
            if (spec.unit == Unit::Length || spec.unit == Unit::Angle || spec.unit == Unit::Share)
                out << ' ' << unitName(spec.unit);
            out << '\n';
        }
    }
    return text.toStdString();
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

std::string modelText(const Model &model)
{
    QString text;
    QTextStream out(&text);
    if (model.document.operations.empty())
        out << tr("The model has no operations.") << '\n';
    for (const OperationPointer &operation : model.document.operations) {
        const OperationResult *result = model.resultOf(operation->id);
        const int count = result ? countOf(*result) : 0;
        const QString made =
            count == 1 ? tr("1 section")
                       : QCoreApplication::translate("CommandLine", "%n sections", nullptr, count);
        out << QString::fromStdString(operation->name) << ": " << kindName(*operation) << ", "
            << (operation->isOn ? made : tr("off")) << '\n';
        if (result)
            for (const OperationNotice &notice : result->notices)
                out << "    " << noticeText(notice, *operation) << '\n';
    }
    return text.toStdString();
}

} // namespace

int runOperations(const QStringList &arguments)
{
    const Verb &verb = verbNamed("operations");
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("json"), tr("For machines.")});
    addDocumentOptions(parser);
    // Without a file: what there is.
    const bool hasFile = std::any_of(arguments.begin(), arguments.end(),
                                     [](const QString &text) { return !text.startsWith(u'-'); });
    const Arguments found = parse(parser, verb, arguments, hasFile ? 1 : 0);
    if (found.status)
        return *found.status;
    const bool asJson = parser.isSet(QStringLiteral("json"));
    if (!hasFile)
        return print(asJson ? kindsJson() : kindsText());
    std::optional<int> status;
    const std::optional<DocumentOptions> options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const Loaded loaded = load(found.files.front(), *options, verb);
    if (loaded.status)
        return *loaded.status;
    const Model model = evaluate(loaded.document);
    return print(asJson ? modelJson(model, found.files.front()) : modelText(model));
}

} // namespace fff::cli
