#include "core/io/fff_loads.h"

#include "core/io/fff_operations.h"
#include "core/model/load_names.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <iterator>

namespace fff::io {

namespace {

void writeCommon(JsonWriter &json, const Load &load)
{
    if (load.spread != Spread::Point) {
        json.member("spread", nameOf(load.spread));
        if (load.spread != Spread::Hanging)
            json.member("width", load.width);
    }
    if (!load.name.empty())
        json.member("name", load.name);
    if (!load.isRepeated)
        json.member("repeated", false);
}

void writeWeight(JsonWriter &json, const Load &weight)
{
    json.member("mass", weight.mass);
    if (weight.height > 0.0)
        json.member("height", weight.height);
    if (!weight.preset.empty())
        json.member("preset", weight.preset);
    if (weight.filled > 0.0)
        json.member("filled", weight.filled);
}

void writeList(JsonWriter &json, const Document &document, LoadKind kind)
{
    json.beginArray();
    for (const Load &load : document.loads) {
        if (load.kind != kind)
            continue;
        json.beginObject();
        json.member("id", load.id.value);
        json.key("section");
        writeRef(json, load.section);
        json.member("position", load.position);
        if (kind == LoadKind::Push)
            json.member("force", load.push);
        else
            writeWeight(json, load);
        writeCommon(json, load);
        json.endObject();
    }
    json.endArray();
}

class Reader
{
public:
    explicit Reader(const ReferenceReaders &readers) : m_readers(readers) {}

    Load read(const JsonCursor &cursor, LoadKind kind) const
    {
        Load load;
        load.kind = kind;
        load.id = LoadId{m_readers.readId(cursor.member("id"))};
        load.section = m_readers.readRef(cursor.member("section"));
        load.position = cursor.member("position").point2();
        readSpread(cursor, load);
        if (const JsonCursor name = cursor.member("name"); name.exists())
            load.name = name.text();
        if (const JsonCursor repeated = cursor.member("repeated"); repeated.exists())
            load.isRepeated = repeated.truth();
        if (kind == LoadKind::Push)
            readPush(cursor.member("force"), load);
        else
            readWeight(cursor, load);
        return load;
    }

private:
    static void readSpread(const JsonCursor &cursor, Load &load)
    {
        const JsonCursor spread = cursor.member("spread");
        if (!spread.exists())
            return;
        const std::optional<Spread> named = spreadNamed(spread.text());
        if (!named || (load.isPush() && *named == Spread::Hanging))
            spread.failExpected(load.isPush()
                                    ? QT_TRANSLATE_NOOP("Error", "point, patch or edge")
                                    : QT_TRANSLATE_NOOP("Error", "point, patch, edge or hanging"));
        else
            load.spread = *named;
        if (const JsonCursor width = cursor.member("width"); width.exists())
            load.width = within(width, kLeastSpread, kMostSpread,
                                QT_TRANSLATE_NOOP("Error", "a width from 1 to 10000 mm"));
    }

    static void readPush(const JsonCursor &cursor, Load &load)
    {
        const std::vector<JsonCursor> parts =
            cursor.exists() ? cursor.items() : std::vector<JsonCursor>();
        if (parts.size() == 3)
            load.push = {parts[0].number(), parts[1].number(), parts[2].number()};
        if (load.push.isZero(0.0) || !(load.push.norm() <= kMaxPush))
            cursor.failExpected(
                QT_TRANSLATE_NOOP("Error", "a force [x, y, z] above 0, at most 1000000 N"));
    }

    static void readWeight(const JsonCursor &cursor, Load &load)
    {
        load.mass = cursor.member("mass").positive();
        if (const JsonCursor height = cursor.member("height"); height.exists())
            load.height = within(height, 0.0, kMostSpread,
                                 QT_TRANSLATE_NOOP("Error", "a height from 0 to 10000 mm"));
        if (const JsonCursor preset = cursor.member("preset"); preset.exists())
            load.preset = preset.text();
        if (const JsonCursor filled = cursor.member("filled"); filled.exists())
            load.filled =
                within(filled, 0.0, load.mass, QT_TRANSLATE_NOOP("Error", "a part of its mass"));
    }

    /// The least where it is not in its range, which is said.
    static double within(const JsonCursor &cursor, double least, double most, const char *expected)
    {
        const double value = cursor.number();
        if (value >= least && value <= most)
            return value;
        cursor.failExpected(expected);
        return least;
    }

    const ReferenceReaders &m_readers;
};

} // namespace

void writeLoads(JsonWriter &json, const Document &document)
{
    json.key("weights");
    writeList(json, document, LoadKind::Weight);
    if (std::any_of(document.loads.begin(), document.loads.end(),
                    [](const Load &load) { return load.isPush(); })) {
        json.key("pushes");
        writeList(json, document, LoadKind::Push);
    }
}

std::vector<Load> readLoads(const JsonCursor &weights, const JsonCursor &pushes,
                            const ReferenceReaders &readers)
{
    const Reader reader(readers);
    std::vector<Load> loads;
    const auto add = [&](const JsonCursor &list, LoadKind kind) {
        if (list.exists())
            for (const JsonCursor &item : list.items())
                loads.push_back(reader.read(item, kind));
    };
    add(weights, LoadKind::Weight);
    add(pushes, LoadKind::Push);
    // As they were put on: two lists in a file, one in a document.
    std::stable_sort(loads.begin(), loads.end(),
                     [](const Load &a, const Load &b) { return a.id < b.id; });
    return loads;
}

} // namespace fff::io
