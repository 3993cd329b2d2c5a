#include "core/base/tolerances.h"
#include "core/io/svg_writer.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

using namespace fff;
using namespace fff::test;

namespace {

/// One element as it was read back.
struct Element
{
    QString name;
    QXmlStreamAttributes attributes;
    QString text;
    QString group; // id of the nearest <g> around it

    QString operator[](const char *key) const
    {
        return attributes.value(QLatin1String(key)).toString();
    }
};

/// All elements; none when it is not well-formed.
std::vector<Element> read(const std::string &svg)
{
    std::vector<Element> elements;
    QStringList groups;
    QXmlStreamReader xml(QByteArray::fromStdString(svg));
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement()) {
            elements.push_back({xml.qualifiedName().toString(),
                                xml.attributes(),
                                {},
                                groups.isEmpty() ? QString() : groups.last()});
            if (xml.name() == QLatin1String("g"))
                groups.push_back(xml.attributes().value(QLatin1String("id")).toString());
        } else if (xml.isEndElement() && xml.name() == QLatin1String("g")) {
            groups.pop_back();
        } else if (xml.isCharacters() && !xml.isWhitespace()) {
            elements.back().text += xml.text();
        }
    }
    return xml.hasError() ? std::vector<Element>{} : elements;
}

std::vector<Element> named(const std::vector<Element> &all, const char *name)
{
    std::vector<Element> result;
    for (const Element &e : all) {
        if (e.name == QLatin1String(name))
            result.push_back(e);
    }
    return result;
}

/// Box of all numbers of a path, taken in pairs: of its points and handles.
Box2 boxOf(const QString &d)
{
    Box2 box;
    static const QRegularExpression kNumbers(QStringLiteral("-?[0-9.]+"));
    auto it = kNumbers.globalMatch(d);
    while (it.hasNext()) {
        const double x = it.next().captured().toDouble();
        box.extend({x, it.next().captured().toDouble()});
    }
    return box;
}

struct Drawing
{
    Model model;
    std::vector<Part> parts;
    Layout layout;

    std::string svg(const DrawingOptions &options = {}, bool hasMarks = true) const
    {
        std::vector<Engraving> engravings;
        for (const Part &part : parts)
            if (hasMarks)
                engravings.push_back(engrave(part, {}));
        return io::writeSvg(cuttingDrawing(layout, parts, engravings, model, options));
    }
};

Drawing drawingOf(const Model &model)
{
    Drawing drawing{model, partsOf(model), {}};
    drawing.layout = layOut(drawing.parts, model, {});
    return drawing;
}

Drawing crossedPlates()
{
    const ShapePointer disc = *Shape::make(circle({0, 30}, 30), {circle({-15, 30}, 5)});
    return drawingOf(twoSections(disc, front(), polygonShape(rectangle(-40, 0, 40, 50)), side()));
}

} // namespace

class TestSvgWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rootIsInMillimetres();
    void partHasItsTrueSize();
    void drawingIsNotMirrored();
    void cutsAreClosedAndMarksOpen();
    void holesComeBeforeTheOutside();
    void curvesAreCurvesAndLinesLines();
    void groupsCarryTheSectionsNames();
    void namesAreEscaped_data();
    void namesAreEscaped();
    void severalSheetsAreFramedAndStacked();
    void referenceBarIsBelowTheSheets();
    void metadataSaysWhatWasApplied();
    void numbersArePlain();
    void marksCanBeLeftOut();
    void goldenFile();
};

// Wrong: programs would read the file at 72, 90 or 96 dots an inch and cut another size.
void TestSvgWriter::rootIsInMillimetres()
{
    DrawingOptions options;
    options.hasReference = false;
    const auto elements = read(crossedPlates().svg(options));
    QVERIFY(!elements.empty());
    QCOMPARE(elements[0].name, QStringLiteral("svg"));
    QCOMPARE(elements[0]["width"], QStringLiteral("600mm"));
    QCOMPARE(elements[0]["height"], QStringLiteral("400mm"));
    QCOMPARE(elements[0]["viewBox"], QStringLiteral("0 0 600 400"));
}

// Wrong: what is cut would not be as large as what was drawn.
void TestSvgWriter::partHasItsTrueSize()
{
    for (const Element &path : named(read(crossedPlates().svg()), "path")) {
        if (path["stroke"] != QStringLiteral("#ff0000") || path.group != QStringLiteral("part-2"))
            continue;
        const Vec2 size = boxOf(path["d"]).size();
        QVERIFY((size - Vec2(80, 50)).norm() < 1e-5 || (size - Vec2(50, 80)).norm() < 1e-5);
        return;
    }
    QFAIL("no outline of part 2");
}

// Wrong: y downwards without flipping would cut the mirror image.
void TestSvgWriter::drawingIsNotMirrored()
{
    const Model model = evaluate(
        withSection(newDocument(),
                    polygonShape({{0, 0}, {40, 0}, {40, 5}, {5, 5}, {5, 20}, {0, 20}}), front()));
    const auto paths = named(read(drawingOf(model).svg({}, false)), "path");
    QCOMPARE(paths.size(), 1U);
    // The foot of the L points right, its stem is left; the sheet's lower left corner is at 0, 400.
    QCOMPARE(paths[0]["d"],
             QStringLiteral("M 5 395 L 45 395 L 45 390 L 10 390 L 10 375 L 5 375 Z"));
}

// Wrong: an open cut leaves the part hanging, a closed mark gets cut out.
void TestSvgWriter::cutsAreClosedAndMarksOpen()
{
    int cuts = 0, marks = 0;
    for (const Element &path : named(read(crossedPlates().svg()), "path")) {
        const bool isCut = path["stroke"] == QStringLiteral("#ff0000");
        QVERIFY(isCut || path["stroke"] == QStringLiteral("#0000ff"));
        QCOMPARE(path["d"].count(QLatin1Char('Z')), isCut ? 1 : 0);
        QCOMPARE(path["d"].endsWith(QLatin1Char('Z')), isCut);
        const int chains = path["d"].count(QLatin1Char('M'));
        if (isCut)
            QCOMPARE(chains, 1);
        else
            marks += chains;
        cuts += isCut ? 1 : 0;
    }
    QCOMPARE(cuts, 3);
    QVERIFY(marks >= 4);
}

// Wrong: the part falls before its holes are cut, and moves.
void TestSvgWriter::holesComeBeforeTheOutside()
{
    std::vector<double> widths;
    for (const Element &path : named(read(crossedPlates().svg()), "path")) {
        if (path.group == QStringLiteral("part-1") && path["stroke"] == QStringLiteral("#ff0000"))
            widths.push_back(boxOf(path["d"]).size().x());
    }
    QCOMPARE(widths.size(), 2U);
    QVERIFY(widths[0] < widths[1]);
}

// Wrong: a circle would be cut with corners, a slit with wavy walls.
void TestSvgWriter::curvesAreCurvesAndLinesLines()
{
    for (const Element &path : named(read(crossedPlates().svg()), "path")) {
        if (path["stroke"] != QStringLiteral("#ff0000"))
            continue;
        const bool isPlate = path.group == QStringLiteral("part-2");
        QCOMPARE(path["d"].contains(QLatin1Char('C')), !isPlate);
        QVERIFY(path["d"].count(QLatin1Char('C')) <= 6);
        if (isPlate) // four corners and a slit's four
            QCOMPARE(path["d"].count(QLatin1Char('L')), 7);
    }
}

// Wrong: nobody could tell in a cutting program which part is which.
void TestSvgWriter::groupsCarryTheSectionsNames()
{
    const auto titles = named(read(crossedPlates().svg()), "title");
    QCOMPARE(titles.size(), 2U);
    for (const Element &title : titles)
        QCOMPARE(title.text, title.group == QStringLiteral("part-1") ? QStringLiteral("Section 1")
                                                                     : QStringLiteral("Section 2"));
}

void TestSvgWriter::namesAreEscaped_data()
{
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("expected");
    QTest::newRow("markup") << QByteArray("a<b>&\"c'") << QStringLiteral("a<b>&\"c'");
    QTest::newRow("other scripts") << QByteArray("R\xc3\xbc"
                                                 "cken \xe6\x9d\xbf")
                                   << QString::fromUtf8("R\xc3\xbc"
                                                        "cken \xe6\x9d\xbf");
    QTest::newRow("a control character") << QByteArray("a\x01"
                                                       "b")
                                         << QString::fromUtf8("a\xef\xbf\xbd"
                                                              "b");
    QTest::newRow("broken UTF-8") << QByteArray("a\xff"
                                                "b")
                                  << QString::fromUtf8("a\xef\xbf\xbd"
                                                       "b");
}

// Wrong: a section's name would make the file unreadable.
void TestSvgWriter::namesAreEscaped()
{
    QFETCH(QByteArray, name);
    QFETCH(QString, expected);
    Model model = crossedPlates().model;
    model.document =
        *renameSection(model.document, model.document.sections[0]->id, name.toStdString());
    const auto titles = named(read(drawingOf(model).svg()), "title");
    QCOMPARE(titles.size(), 2U);
    QVERIFY(titles[0].text == expected || titles[1].text == expected);
}

// Wrong: the second plate would be cut over the first one.
void TestSvgWriter::severalSheetsAreFramedAndStacked()
{
    Drawing drawing = crossedPlates();
    LayoutOptions options;
    options.sheet = Vec2(90, 95);
    drawing.layout = layOut(drawing.parts, drawing.model, options);
    QCOMPARE(drawing.layout.sheets.size(), 2U);
    DrawingOptions svgOptions;
    svgOptions.hasReference = false;
    const auto elements = read(drawing.svg(svgOptions));
    QCOMPARE(elements[0]["viewBox"], QStringLiteral("0 0 90 200"));
    const auto frames = named(elements, "rect");
    QCOMPARE(frames.size(), 2U);
    QCOMPARE(frames[0].group, QStringLiteral("sheet-1"));
    QCOMPARE(frames[1].group, QStringLiteral("sheet-2"));
    QCOMPARE(frames[1]["y"], QStringLiteral("105"));
    QCOMPARE(frames[1]["stroke"], QStringLiteral("#ffcc00"));
    Box2 first, second;
    for (const Element &path : named(elements, "path")) {
        const int part = path.group.mid(5).toInt() - 1;
        (drawing.layout.sheets[0].placements[0].part == part ? first : second)
            .extend(boxOf(path["d"]));
    }
    QVERIFY(first.max.y() <= 95.0 - 5.0 + kCutChord);
    QVERIFY(second.min.y() >= 105.0 + 5.0 - kCutChord);
}

// Wrong: the bar would be cut across a part, or the size could not be checked.
void TestSvgWriter::referenceBarIsBelowTheSheets()
{
    const auto elements = read(crossedPlates().svg());
    QCOMPARE(elements[0]["viewBox"], QStringLiteral("0 0 600 420"));
    const auto bars = named(elements, "rect");
    QCOMPARE(bars.size(), 1U);
    QCOMPARE(bars[0]["y"], QStringLiteral("410"));
    QCOMPARE(bars[0]["width"], QStringLiteral("100"));
    QCOMPARE(bars[0]["height"], QStringLiteral("10"));
}

// Wrong: somebody would compensate the kerf a second time.
void TestSvgWriter::metadataSaysWhatWasApplied()
{
    DrawingOptions options;
    for (const bool applied : {false, true}) {
        options.isKerfApplied = applied;
        const auto elements = read(crossedPlates().svg(options));
        const auto cutting = named(elements, "fff:cutting");
        QCOMPARE(cutting.size(), 1U);
        QCOMPARE(cutting[0]["kerf-applied"],
                 applied ? QStringLiteral("yes") : QStringLiteral("no"));
        QVERIFY(!cutting[0]["version"].isEmpty());
        const auto stocks = named(elements, "fff:stock");
        QCOMPARE(stocks.size(), 1U);
        QCOMPARE(stocks[0]["name"], QStringLiteral("Birch plywood"));
        QCOMPARE(stocks[0]["thickness"], QStringLiteral("3"));
        QCOMPARE(stocks[0]["kerf"], QStringLiteral("0.2"));
        QCOMPARE(stocks[0]["clearance"], QStringLiteral("0"));
    }
}

// Wrong: exponents and long tails of digits trip simple readers.
void TestSvgWriter::numbersArePlain()
{
    const QString svg = QString::fromStdString(crossedPlates().svg());
    static const QRegularExpression kLongTail(QStringLiteral("\\d\\.\\d{7}"));
    static const QRegularExpression kExponent(QStringLiteral("\\d[eE][-+]?\\d"));
    static const QRegularExpression kNegativeZero(QStringLiteral("[ \"]-0[ \"]"));
    for (const QRegularExpression &unwanted : {kLongTail, kExponent, kNegativeZero})
        QVERIFY2(!unwanted.match(svg).hasMatch(), qPrintable(unwanted.match(svg).captured()));
}

// Wrong: visible faces would carry numbers that were switched off.
void TestSvgWriter::marksCanBeLeftOut()
{
    for (const Element &path : named(read(crossedPlates().svg({}, false)), "path"))
        QCOMPARE(path["stroke"], QStringLiteral("#ff0000"));
}

// Wrong: the format changed without anybody meaning it.
void TestSvgWriter::goldenFile()
{
    QFile golden(QStringLiteral(FFF_TEST_DATA "/svg/crossed_plates.svg"));
    const bool isThere = golden.open(QIODevice::ReadOnly);
    const QByteArray expected = isThere ? golden.readAll() : QByteArray();
    QByteArray actual = QByteArray::fromStdString(crossedPlates().svg());
    actual.replace("version=\"" FFF_VERSION "\"", "version=\"VERSION\"");
    if (actual != expected) {
        QFile file(QCoreApplication::applicationDirPath() +
                   QStringLiteral("/crossed_plates.actual.svg"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(actual);
        QFAIL(qPrintable(
            QStringLiteral("differs from the golden file; see %1").arg(file.fileName())));
    }
}

FFF_TEST(TestSvgWriter)
#include "tst_svg_writer.moc"
