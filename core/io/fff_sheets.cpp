#include "core/io/fff_sheets.h"

#include "core/io/fff_operations.h"

#include <QtCore/QCoreApplication>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

namespace fff::io {

namespace {

using Layout = JsonWriter::Layout;

constexpr const char *kOncePerPart =
    QT_TRANSLATE_NOOP("Error", "each part once, in the order of sections");
constexpr const char *kOncePerSection =
    QT_TRANSLATE_NOOP("Error", "each section once, in their order");

bool isBefore(const PinnedPlace &a, const PinnedPlace &b)
{
    return std::tie(a.section, a.body) < std::tie(b.section, b.body);
}

bool isBefore(const SectionTurning &a, const SectionTurning &b)
{
    return a.section < b.section;
}

/// Nothing for a list that is not there.
template <class Wish, class Read>
std::vector<Wish> readInOrder(const JsonCursor &cursor, const char *expected, Read read)
{
    std::vector<Wish> all;
    if (!cursor.exists())
        return all;
    for (const JsonCursor &item : cursor.items()) {
        Wish wish = read(item);
        if (!all.empty() && !isBefore(all.back(), wish))
            item.failExpected(expected);
        all.push_back(std::move(wish));
    }
    return all;
}

PinnedPlace readPin(const JsonCursor &cursor, const ReferenceReaders &readers)
{
    PinnedPlace pin;
    pin.section = readers.readRef(cursor.member("section"));
    if (const JsonCursor body = cursor.member("body"); body.exists())
        pin.body = static_cast<int>(body.integer(0, kMostPinnedBodies - 1));
    const JsonCursor offcut = cursor.member("offcut");
    const bool isOffcut = offcut.exists() && offcut.truth();
    pin.sheet = static_cast<int>(
        cursor.member("sheet").integer(0, (isOffcut ? kMostSpares : kMostPinnedSheets) - 1));
    if (isOffcut)
        pin.sheet = -1 - pin.sheet;
    pin.offset = cursor.member("at").point2();
    if (const JsonCursor turn = cursor.member("turn"); turn.exists()) {
        pin.turn = turn.point2();
        if (!(std::abs(pin.turn.norm() - 1.0) <= kPinnedTurnError))
            turn.failExpected(QT_TRANSLATE_NOOP("Error", "a direction of length 1"));
    }
    return pin;
}

SectionTurning readTurning(const JsonCursor &cursor, const ReferenceReaders &readers)
{
    SectionTurning one;
    one.section = readers.readRef(cursor.member("section"));
    const JsonCursor name = cursor.member("turning");
    if (const auto turning = turningNamed(name.text()))
        one.turning = *turning;
    else
        name.failExpected(QT_TRANSLATE_NOOP("Error", "none, half, quarter or free"));
    return one;
}

} // namespace

void writePins(JsonWriter &json, const Document &document)
{
    if (document.pins.empty())
        return;
    json.key("pins");
    json.beginArray();
    for (const PinnedPlace &pin : document.pins) {
        json.beginObject(Layout::Line);
        json.key("section");
        writeRef(json, pin.section);
        if (pin.body != 0)
            json.member("body", pin.body);
        json.member("sheet", pin.sheet < 0 ? -1 - pin.sheet : pin.sheet);
        if (pin.sheet < 0)
            json.member("offcut", true);
        json.member("at", pin.offset);
        if (pin.turn != Vec2::UnitX())
            json.member("turn", pin.turn);
        json.endObject();
    }
    json.endArray();
}

void writeTurnings(JsonWriter &json, const Document &document)
{
    if (document.turnings.empty())
        return;
    json.key("turnings");
    json.beginArray();
    for (const SectionTurning &one : document.turnings) {
        json.beginObject(Layout::Line);
        json.key("section");
        writeRef(json, one.section);
        json.member("turning", nameOf(one.turning));
        json.endObject();
    }
    json.endArray();
}

std::vector<PinnedPlace> readPins(const JsonCursor &cursor, const ReferenceReaders &readers)
{
    return readInOrder<PinnedPlace>(cursor, kOncePerPart,
                                    [&](const JsonCursor &item) { return readPin(item, readers); });
}

std::vector<SectionTurning> readTurnings(const JsonCursor &cursor, const ReferenceReaders &readers)
{
    return readInOrder<SectionTurning>(cursor, kOncePerSection, [&](const JsonCursor &item) {
        return readTurning(item, readers);
    });
}

} // namespace fff::io
