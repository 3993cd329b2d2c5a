#include "core/io/fff_operations.h"

#include "core/io/loaded_document.h"
#include "core/operations/operation_kind.h"

#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

using Layout = JsonWriter::Layout;

constexpr std::int64_t kMaxVersion = 1'000'000;

void writeParameters(JsonWriter &json, const Operation &operation)
{
    json.key("parameters");
    json.beginObject();
    for (const auto &[key, value] : operation.parameters) {
        json.key(key);
        std::visit([&json](const auto &v) { json.value(v); }, value);
    }
    json.endObject();
}

void writeInputs(JsonWriter &json, const Operation &operation)
{
    json.key("inputs");
    json.beginObject();
    for (const auto &[role, inputs] : operation.inputs) {
        json.key(role);
        json.beginArray();
        for (const OperationInput &input : inputs) {
            json.beginObject(Layout::Line);
            json.key("section");
            writeRef(json, input.section);
            json.member("name", input.name);
            json.endObject();
        }
        json.endArray();
    }
    json.endObject();
}

void writeExceptions(JsonWriter &json, const Operation &operation)
{
    if (operation.exceptions.empty())
        return;
    json.key("exceptions");
    json.beginArray();
    for (const auto &[key, exception] : operation.exceptions) {
        json.beginObject(Layout::Line);
        json.member("instance", key);
        if (exception.state != Exception::State::Made)
            json.member("state",
                        exception.state == Exception::State::Hidden ? "hidden" : "detached");
        if (exception.stock.isValid())
            json.member("stock", exception.stock.value);
        json.endObject();
    }
    json.endArray();
}

ParameterValue readValue(const JsonCursor &cursor, const ParameterSpec *spec)
{
    ParameterValue value = 0.0;
    if (cursor.isBool())
        value = cursor.truth();
    else if (cursor.isText())
        value = cursor.text();
    else
        value = cursor.number();
    if (spec && !isAllowed(*spec, value))
        cursor.fail(ErrorCode::BadValue, {cursor.shown(), rangeText(*spec)});
    return value;
}

Exception readException(const JsonCursor &cursor, const OperationSurroundings &surroundings)
{
    Exception exception;
    if (const JsonCursor state = cursor.member("state"); state.exists()) {
        const std::string name = state.text();
        if (name == "hidden")
            exception.state = Exception::State::Hidden;
        else if (name == "detached")
            exception.state = Exception::State::Detached;
        else
            state.failExpected(QT_TRANSLATE_NOOP("Error", "hidden or detached"));
    }
    if (const JsonCursor stock = cursor.member("stock"); stock.exists())
        exception.stock = surroundings.readStock(stock);
    return exception;
}

} // namespace

void writeRef(JsonWriter &json, const SectionRef &ref)
{
    if (ref.drawn.isValid()) {
        json.value(ref.drawn.value);
        return;
    }
    json.beginObject(Layout::Line);
    json.member("operation", ref.operation.value);
    json.member("instance", ref.key);
    json.endObject();
}

void writeOperation(JsonWriter &json, const Operation &operation)
{
    json.beginObject();
    json.member("id", operation.id.value);
    json.member("kind", operation.kind);
    json.member("version", operation.version);
    json.member("name", operation.name);
    if (!operation.isOn)
        json.member("on", false);
    if (operation.subject.isValid())
        json.member("template", operation.subject.value);
    if (operation.stock.isValid())
        json.member("stock", operation.stock.value);
    writeInputs(json, operation);
    writeParameters(json, operation);
    writeExceptions(json, operation);
    json.endObject();
}

Operation readOperation(const JsonCursor &cursor, const OperationSurroundings &surroundings)
{
    Operation operation;
    operation.kind = cursor.member("kind").text();
    operation.version = static_cast<int>(cursor.member("version").integer(1, kMaxVersion));
    operation.name = cursor.member("name").text();
    const OperationKind *kind = operationKind(operation.kind);
    if (!kind || operation.version > kind->version) {
        cursor.fail(ErrorCode::Unsupported, {io::quoted(operation.kind)});
        return operation;
    }
    if (const JsonCursor on = cursor.member("on"); on.exists())
        operation.isOn = on.truth();
    // One that is gone leaves the operation without a template, which it says.
    if (const JsonCursor subject = cursor.member("template"); subject.exists())
        operation.subject = TemplateId{surroundings.readGivenId(subject)};
    if (const JsonCursor stock = cursor.member("stock"); stock.exists())
        operation.stock = surroundings.readStock(stock);
    for (const auto &[role, list] : cursor.member("inputs").members()) {
        std::vector<OperationInput> &inputs = operation.inputs[role];
        for (const JsonCursor &item : list.items())
            inputs.push_back(
                {surroundings.readRef(item.member("section")), item.member("name").text()});
    }
    for (const auto &[key, value] : cursor.member("parameters").members())
        operation.parameters.emplace(key, readValue(value, kind->parameter(key)));
    if (const JsonCursor exceptions = cursor.member("exceptions"); exceptions.exists()) {
        for (const JsonCursor &item : exceptions.items()) {
            const Exception exception = readException(item, surroundings);
            const bool isNew =
                operation.exceptions.emplace(item.member("instance").text(), exception).second;
            if (!isNew || exception.isEmpty())
                item.failExpected(
                    QT_TRANSLATE_NOOP("Error", "something other than made, each instance once"));
        }
    }
    return operation;
}

} // namespace fff::io
