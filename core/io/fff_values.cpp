#include "core/io/fff_values.h"

#include "core/io/fff_operations.h"
#include "core/model/bindings.h"
#include "core/model/value_names.h"
#include "core/operations/drivable.h"
#include "core/values/formula.h"
#include "core/values/presets.h"

#include <QtCore/QCoreApplication>
#include <limits>
#include <map>
#include <string>

namespace fff::io {

namespace {

using Layout = JsonWriter::Layout;

void writeReading(JsonWriter &json, const Reading &reading)
{
    const Reading usual;
    if (reading.lengthUnit != usual.lengthUnit)
        json.member("lengthUnit", reading.lengthUnit);
    if (reading.massUnit != usual.massUnit)
        json.member("massUnit", reading.massUnit);
    if (reading.angleUnit != usual.angleUnit)
        json.member("angleUnit", reading.angleUnit);
    if (reading.commas != usual.commas)
        json.member("commas", "decimals");
}

Reading readReading(const JsonCursor &cursor)
{
    Reading reading;
    const auto unit = [&cursor](const char *key, double &value) {
        if (const JsonCursor member = cursor.member(key); member.exists())
            value = member.positive();
    };
    unit("lengthUnit", reading.lengthUnit);
    unit("massUnit", reading.massUnit);
    unit("angleUnit", reading.angleUnit);
    if (const JsonCursor commas = cursor.member("commas"); commas.exists()) {
        const std::string name = commas.text();
        if (name == "decimals")
            reading.commas = Commas::Decimals;
        else if (name != "groups")
            commas.failExpected(QT_TRANSLATE_NOOP("Error", "decimals or groups"));
    }
    return reading;
}

std::string readTyped(const JsonCursor &cursor)
{
    std::string typed = cursor.text();
    if (typed.size() > kLongestExpression)
        cursor.failExpected(QT_TRANSLATE_NOOP("Error", "an expression that is not that long"));
    return typed;
}

void writeValue(JsonWriter &json, const Value &value)
{
    json.beginObject(Layout::Line);
    json.member("id", value.id.value);
    json.member("name", value.name);
    json.member("kind", nameIn(kValueKindNames, value.kind));
    json.member("typed", value.typed);
    writeReading(json, value.reading);
    const auto bound = [&json](const char *key, const std::optional<double> &number) {
        if (number)
            json.member(key, *number);
    };
    bound("least", value.range.least);
    bound("most", value.range.most);
    bound("step", value.range.step);
    if (!value.choices.empty()) {
        json.key("choices");
        json.beginArray(Layout::Line);
        for (const std::string &choice : value.choices)
            json.value(choice);
        json.endArray();
    }
    if (!value.note.empty())
        json.member("note", value.note);
    if (!value.group.empty())
        json.member("group", value.group);
    if (value.isShown)
        json.member("shown", true);
    json.endObject();
}

Value readValue(const JsonCursor &cursor, const ReferenceReaders &readers)
{
    Value value;
    value.id = ValueId{readers.readId(cursor.member("id"))};
    value.name = cursor.member("name").text();
    const JsonCursor kind = cursor.member("kind");
    if (const auto known = namedIn(kValueKindNames, kind.text()))
        value.kind = *known;
    else
        kind.failExpected(QT_TRANSLATE_NOOP(
            "Error", "number, length, angle, count, mass, ratio, text, choice or switch"));
    value.typed = readTyped(cursor.member("typed"));
    value.reading = readReading(cursor);
    const auto bound = [&cursor](const char *key) {
        const JsonCursor member = cursor.member(key);
        return member.exists() ? std::optional(member.number()) : std::nullopt;
    };
    value.range = {bound("least"), bound("most"), bound("step")};
    if (const JsonCursor choices = cursor.member("choices"); choices.exists())
        for (const JsonCursor &choice : choices.items())
            value.choices.push_back(choice.text());
    if (const JsonCursor note = cursor.member("note"); note.exists())
        value.note = note.text();
    if (const JsonCursor group = cursor.member("group"); group.exists())
        value.group = group.text();
    if (const JsonCursor shown = cursor.member("shown"); shown.exists())
        value.isShown = shown.truth();
    return value;
}

void writePreset(JsonWriter &json, const Preset &preset)
{
    json.beginObject();
    json.member("name", preset.name);
    json.key("settings");
    json.beginArray();
    for (const Setting &setting : preset.settings) {
        json.beginObject(Layout::Line);
        json.member("value", setting.value.value);
        json.member("typed", setting.typed);
        writeReading(json, setting.reading);
        json.endObject();
    }
    json.endArray();
    json.endObject();
}

/// Settings of values that a newer version has are left out, and so is a preset of nothing else.
Preset readPreset(const JsonCursor &cursor, const Values &values, std::int64_t nextId)
{
    Preset preset;
    const JsonCursor name = cursor.member("name");
    preset.name = name.text();
    if (!isPresetName(preset.name) || findPreset(values, preset.name))
        name.failExpected(QT_TRANSLATE_NOOP("Error", "a name without “=”, each once"));
    std::map<ValueId, Setting> settings;
    for (const JsonCursor &item : cursor.member("settings").items()) {
        const JsonCursor value = item.member("value");
        const ValueId id{value.integer(1, nextId - 1)};
        Setting setting{id, readTyped(item.member("typed")), readReading(item)};
        if (values.indexOf(id) >= 0 && !settings.emplace(id, std::move(setting)).second)
            value.failExpected(QT_TRANSLATE_NOOP("Error", "each value once"));
    }
    for (auto &[id, setting] : settings)
        preset.settings.push_back(std::move(setting));
    return preset;
}

void writeResult(JsonWriter &json, const Worth &result)
{
    json.key("result");
    if (result.type == Worth::Type::Text)
        json.value(result.text);
    else if (result.type == Worth::Type::Truth)
        json.value(result.number != 0.0);
    else
        json.value(result.number);
}

/// As `like` is, which the number is now.
Worth readResult(const JsonCursor &cursor, const Worth &like)
{
    Worth result = like;
    if (like.type == Worth::Type::Text)
        result.text = cursor.text();
    else if (like.type == Worth::Type::Truth)
        result.number = cursor.truth() ? 1.0 : 0.0;
    else
        result.number = cursor.number();
    return result;
}

void writeBinding(JsonWriter &json, const Binding &binding)
{
    const DrivenPlace &place = binding.place;
    json.beginObject(Layout::Line);
    json.member("of", nameIn(kDrivenNames, place.of));
    if (place.of == DrivenPlace::Of::Joint) {
        json.key("a");
        writeRef(json, place.a);
        json.key("b");
        writeRef(json, place.b);
    } else {
        json.member("id", place.id);
    }
    if (hasIndex(place.of))
        json.member("index", place.index);
    json.member("field", place.field);
    json.member("typed", binding.typed);
    writeReading(json, binding.reading);
    writeResult(json, binding.result);
    json.endObject();
}

DrivenPlace readPlace(const JsonCursor &cursor, DrivenPlace::Of of, std::int64_t nextId,
                      const ReferenceReaders &readers)
{
    DrivenPlace place;
    place.of = of;
    if (of == DrivenPlace::Of::Joint) {
        place.a = readers.readRef(cursor.member("a"));
        place.b = readers.readRef(cursor.member("b"));
    } else {
        place.id = cursor.member("id").integer(1, nextId - 1);
    }
    if (hasIndex(of))
        place.index =
            static_cast<int>(cursor.member("index").integer(0, std::numeric_limits<int>::max()));
    place.field = cursor.member("field").text();
    return place;
}

} // namespace

void writeValues(JsonWriter &json, const Document &document)
{
    if (document.values.list.empty())
        return;
    json.key("values");
    json.beginArray();
    for (const ValuePointer &known : document.values.list)
        writeValue(json, known->value);
    json.endArray();
    if (document.values.presets.empty())
        return;
    json.key("presets");
    json.beginArray();
    for (const PresetPointer &preset : document.values.presets)
        writePreset(json, *preset);
    json.endArray();
}

void writeBindings(JsonWriter &json, const Document &document)
{
    if (document.bindings.empty())
        return;
    json.key("bindings");
    json.beginArray();
    for (const BindingPointer &pointer : document.bindings)
        writeBinding(json, pointer->binding);
    json.endArray();
}

Values readValues(const JsonCursor &root, std::int64_t nextId, const ReferenceReaders &readers)
{
    Values values;
    const JsonCursor cursor = root.member("values");
    if (!cursor.exists())
        return values;
    for (const JsonCursor &item : cursor.items()) {
        Value value = readValue(item, readers);
        const JsonCursor name = item.member("name");
        if (!checkName(value.name) || values.indexOf(value.name) >= 0)
            name.failExpected(
                QT_TRANSLATE_NOOP("Error", "a word of letters and digits, each once"));
        values.list.push_back(makeValue(std::move(value)));
    }
    if (const JsonCursor presets = root.member("presets"); presets.exists())
        for (const JsonCursor &item : presets.items())
            if (Preset preset = readPreset(item, values, nextId); !preset.settings.empty())
                values = withPreset(std::move(values), std::move(preset));
    return values;
}

std::vector<BindingPointer>
readBindings(const JsonCursor &cursor, const Document &document, const ReferenceReaders &readers,
             const std::function<void(const JsonCursor &item, const std::string &typed)> &lost)
{
    Document found; // of which the bindings alone are used
    if (!cursor.exists())
        return {};
    for (const JsonCursor &item : cursor.items()) {
        const auto of = namedIn(kDrivenNames, item.member("of").text());
        if (!of) {
            lost(item, readTyped(item.member("typed")));
            continue;
        }
        const DrivenPlace place = readPlace(item, *of, document.nextId, readers);
        Binding binding{
            place, ValueKind::Number, readTyped(item.member("typed")), readReading(item), {}};
        const std::optional<DrivenNumber> number = drivenNumber(document, place);
        if (!number) {
            lost(item, binding.typed);
            continue;
        }
        binding.kind = number->kind;
        binding.result = readResult(item.member("result"), number->worth);
        if (!isSameWorth(binding.result, number->worth))
            lost(item, binding.typed); // and is told from what counts when numbers are driven
        if (bindingOf(found, place))
            item.failExpected(QT_TRANSLATE_NOOP("Error", "each number once"));
        found = withBinding(std::move(found), std::move(binding));
    }
    return std::move(found.bindings);
}

} // namespace fff::io
