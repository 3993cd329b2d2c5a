#include "core/io/fff_annotations.h"

#include "core/io/fff_operations.h"
#include "core/model/figures.h"
#include "core/model/named_numbers.h"

#include <QtCore/QCoreApplication>
#include <algorithm>

namespace fff::io {

namespace {

using Layout = JsonWriter::Layout;

constexpr int kPointsPerLine = 3; // one segment: its start and two handles

void writeAnchor(JsonWriter &json, const Anchor &anchor)
{
    json.beginObject(Layout::Line);
    if (anchor.section != SectionRef()) {
        json.key("section");
        writeRef(json, anchor.section);
    }
    json.member("at", anchor.at);
    json.endObject();
}

void writeMark(JsonWriter &json, const Mark &mark)
{
    json.beginObject();
    json.member("kind", mark.kind == Mark::Kind::Scored ? "scored" : "engraved");
    if (mark.lettering) {
        json.key("lettering");
        json.beginObject(Layout::Line);
        json.member("text", mark.lettering->text);
        json.member("height", mark.lettering->height);
        json.member("at", mark.lettering->at);
        json.member("turn", mark.lettering->turn);
        json.endObject();
    }
    json.key("paths");
    json.beginArray();
    for (const CurvePath &path : mark.paths) {
        json.beginArray(Layout::Block, kPointsPerLine);
        for (const Vec2 &point : path.points())
            json.value(point);
        json.endArray();
    }
    json.endArray();
    json.endObject();
}

MarkPointer readMark(const JsonCursor &cursor)
{
    auto mark = std::make_shared<Mark>();
    const JsonCursor kind = cursor.member("kind");
    const std::string name = kind.text();
    if (name == "scored")
        mark->kind = Mark::Kind::Scored;
    else if (name != "engraved")
        kind.failExpected(QT_TRANSLATE_NOOP("Error", "engraved or scored"));
    if (const JsonCursor lettering = cursor.member("lettering"); lettering.exists())
        mark->lettering =
            Lettering{lettering.member("text").text(), lettering.member("height").positive(),
                      lettering.member("at").point2(), lettering.member("turn").number()};
    const JsonCursor paths = cursor.member("paths");
    for (const JsonCursor &item : paths.items()) {
        std::vector<Vec2> points = item.points();
        const std::size_t count = points.size();
        Result<CurvePath> path = CurvePath::fromPoints(std::move(points));
        if (path)
            mark->paths.push_back(*std::move(path));
        else
            item.fail(
                path.error().code,
                {std::to_string(count),
                 QT_TRANSLATE_NOOP("Error", "three control points per segment and one more")});
    }
    if (mark->paths.empty())
        paths.failExpected(QT_TRANSLATE_NOOP("Error", "at least one line"));
    return mark;
}

} // namespace

void writeFrame(JsonWriter &json, const Frame &frame)
{
    json.key("frame");
    json.beginObject();
    json.member("origin", frame.origin);
    json.member("x", frame.x);
    json.member("y", frame.y);
    json.endObject();
}

void writeFigures(JsonWriter &json, const Section &section)
{
    if (section.figures.empty())
        return;
    json.key("figures");
    json.beginArray();
    for (const Figure &figure : section.figures) {
        const FigureKind *kind = figureKind(figure.kind);
        json.beginObject(Layout::Line);
        json.member("kind", figure.kind);
        json.member("centre", figure.centre);
        json.member("turn", figure.turn);
        json.key("numbers");
        json.beginObject(Layout::Line);
        for (std::size_t i = 0; kind && i < figure.numbers.size(); ++i)
            json.member(kind->numbers[i].key, figure.numbers[i]);
        json.endObject();
        json.endObject();
    }
    json.endArray();
}

void writeMarks(JsonWriter &json, const Section &section)
{
    if (section.marks.empty())
        return;
    json.key("marks");
    json.beginArray();
    for (const MarkPointer &mark : section.marks)
        writeMark(json, *mark);
    json.endArray();
}

void writeDimensions(JsonWriter &json, const Document &document)
{
    if (document.dimensions.empty())
        return;
    json.key("dimensions");
    json.beginArray();
    for (const Dimension &dimension : document.dimensions) {
        json.beginObject(Layout::Line);
        json.member("id", dimension.id.value);
        json.key("from");
        writeAnchor(json, dimension.from);
        json.key("to");
        writeAnchor(json, dimension.to);
        json.endObject();
    }
    json.endArray();
}

void writeNumbers(JsonWriter &json, const Document &document)
{
    if (document.numbers.empty())
        return;
    json.key("numbers");
    json.beginArray();
    for (const NamedNumber &number : document.numbers) {
        json.beginObject(Layout::Line);
        json.member("name", number.name);
        json.member("expression", number.expression);
        json.member("value", number.value);
        json.endObject();
    }
    json.endArray();
}

std::vector<Figure> readFigures(const JsonCursor &cursor, const ShapePointer &shape)
{
    std::vector<Figure> figures;
    if (!cursor.exists())
        return figures;
    for (const JsonCursor &item : cursor.items()) {
        Figure figure;
        figure.kind = item.member("kind").text();
        figure.centre = item.member("centre").point2();
        figure.turn = item.member("turn").number();
        const FigureKind *kind = figureKind(figure.kind);
        bool isWhole = kind != nullptr;
        for (std::size_t i = 0; kind && i < kind->numbers.size(); ++i) {
            const JsonCursor number = item.member("numbers").member(kind->numbers[i].key);
            isWhole = isWhole && number.exists();
            figure.numbers.push_back(number.exists() ? number.number() : 0.0);
        }
        if (isWhole && shape && boundaryOf(*shape, figure) >= 0)
            figures.push_back(std::move(figure));
    }
    return figures;
}

std::vector<MarkPointer> readMarks(const JsonCursor &cursor)
{
    std::vector<MarkPointer> marks;
    if (cursor.exists())
        for (const JsonCursor &item : cursor.items())
            marks.push_back(readMark(item));
    return marks;
}

std::vector<Dimension> readDimensions(const JsonCursor &cursor, const ReferenceReaders &readers)
{
    const auto readAnchor = [&readers](const JsonCursor &item) {
        Anchor anchor;
        if (const JsonCursor section = item.member("section"); section.exists())
            anchor.section = readers.readRef(section);
        anchor.at = item.member("at").point3();
        return anchor;
    };
    std::vector<Dimension> dimensions;
    if (!cursor.exists())
        return dimensions;
    for (const JsonCursor &item : cursor.items()) {
        Dimension dimension;
        dimension.id = DimensionId{readers.readId(item.member("id"))};
        dimension.from = readAnchor(item.member("from"));
        dimension.to = readAnchor(item.member("to"));
        if (dimension.from == dimension.to)
            item.failExpected(QT_TRANSLATE_NOOP("Error", "two different places"));
        dimensions.push_back(dimension);
    }
    return dimensions;
}

std::vector<NamedNumber> readNumbers(const JsonCursor &cursor)
{
    Document names;
    if (!cursor.exists())
        return {};
    for (const JsonCursor &item : cursor.items()) {
        const JsonCursor name = item.member("name");
        NamedNumber number{name.text(), item.member("expression").text(),
                           item.member("value").number()};
        if (!isNumberName(number.name) || findNumber(names, number.name))
            name.failExpected(QT_TRANSLATE_NOOP("Error", "a word of letters and digits, once"));
        names.numbers.push_back(std::move(number));
    }
    return std::move(names.numbers);
}

} // namespace fff::io
