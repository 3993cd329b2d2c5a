#include "core/io/nesting_instance.h"

#include "core/io/json_cursor.h"
#include "core/io/json_syntax.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QJsonDocument>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff::io {

namespace {

constexpr std::int64_t kMostOfAnItem = 10'000;
constexpr std::int64_t kMostItemId = std::int64_t(1) << 53;

/// Without the first point where it is repeated.
Polygon ringOf(const JsonCursor &at)
{
    Polygon ring = at.points();
    if (ring.size() > 1 && ring.front() == ring.back())
        ring.pop_back();
    if (ring.size() < 3)
        at.failExpected(QT_TRANSLATE_NOOP("Error", "at least three points"));
    return ring;
}

Region outlineOf(const JsonCursor &shape)
{
    const JsonCursor data = shape.member("data");
    Region outline;
    const std::string type = shape.member("type").text();
    if (type == "simple_polygon") {
        outline.outer = ringOf(data);
    } else if (type == "polygon") {
        outline.outer = ringOf(data.member("outer"));
        if (const JsonCursor inner = data.member("inner"); inner.exists())
            for (const JsonCursor &hole : inner.items())
                outline.holes.push_back(ringOf(hole));
    } else {
        shape.member("type").failExpected(QT_TRANSLATE_NOOP("Error", "simple_polygon or polygon"));
    }
    // As regions have them, however they are drawn.
    if (signedArea(outline.outer) < 0.0)
        std::reverse(outline.outer.begin(), outline.outer.end());
    for (Polygon &hole : outline.holes)
        if (signedArea(hole) > 0.0)
            std::reverse(hole.begin(), hole.end());
    return outline;
}

/// Exact for quarter turns.
Vec2 turnOf(double degrees)
{
    const double quarters = degrees / 90.0;
    if (quarters == std::round(quarters)) {
        const auto index = static_cast<std::size_t>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0));
        return nest::turnsOf(nest::Turning::Quarter)[index];
    }
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle)};
}

nest::Piece pieceOf(const JsonCursor &item)
{
    nest::Piece piece;
    piece.demand = static_cast<int>(item.member("demand").integer(0, kMostOfAnItem));
    piece.outline = outlineOf(item.member("shape"));
    const JsonCursor angles = item.member("allowed_orientations");
    piece.turnsFreely = !angles.exists() || angles.isNull();
    if (piece.turnsFreely)
        return piece;
    piece.turns.clear();
    for (const JsonCursor &angle : angles.items())
        piece.turns.push_back(turnOf(angle.number()));
    if (piece.turns.empty())
        angles.failExpected(QT_TRANSLATE_NOOP("Error", "at least one angle"));
    return piece;
}

} // namespace

Result<NestingInstance> readNestingInstance(std::string_view json, const std::string &file)
{
    Problems problems{file};
    const QJsonDocument document = parseJson(json, problems);
    if (problems.failed())
        return tl::unexpected(*problems.error);
    const JsonCursor root(document.isObject() ? QJsonValue(document.object())
                                              : QJsonValue(document.array()),
                          "$", problems);
    if (!root.isObject())
        root.failExpected(QT_TRANSLATE_NOOP("Error", "an instance of strip packing"));
    NestingInstance instance;
    if (!problems.failed()) {
        if (const JsonCursor name = root.member("name"); name.exists())
            instance.name = name.text();
        instance.problem.stripHeight = root.member("strip_height").positive();
    }
    if (!problems.failed()) {
        const std::vector<JsonCursor> items = root.member("items").items();
        for (std::size_t i = 0; i < items.size() && !problems.failed(); ++i) {
            const JsonCursor id = items[i].member("id");
            instance.ids.push_back(id.exists() ? id.integer(0, kMostItemId)
                                               : static_cast<std::int64_t>(i));
            instance.problem.pieces.push_back(pieceOf(items[i]));
        }
        if (items.empty())
            root.member("items").failExpected(QT_TRANSLATE_NOOP("Error", "at least one item"));
    }
    if (problems.failed())
        return tl::unexpected(*problems.error);
    return instance;
}

} // namespace fff::io
