// What is shown before it is cut is what is written: the paths of the preview against those that a
// reader of our own finds in the file.
#include <QTest>

#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "tests/core/analysed.h"
#include "tests/test_program.h"
#include "ui/dialogs/sheet_painting.h"
#include "ui/dialogs/sheet_paths.h"

#include <QApplication>
#include <QXmlStreamReader>

using namespace fff;
using namespace fff::ui;

class TestSheetPaths : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreTheWriters_data();
    void theyAreTheWriters();
    void bridgesAreWhereTheFileHasThem_data() { theyAreTheWriters_data(); }
    void bridgesAreWhereTheFileHasThem();
    void numbersAreReadInside_data() { theyAreTheWriters_data(); }
    void numbersAreReadInside();
    void theBarIsWhereTheFileHasIt();
};

namespace {

using Points = QList<QPointF>; // of a path, in its order

/// "M x y C … L … Z", every number absolute; a closed one ends where it began.
QList<Points> pointsIn(const QString &data)
{
    QList<Points> paths;
    double x = 0.0;
    bool hasX = false;
    for (const QString &word : data.split(u' ', Qt::SkipEmptyParts)) {
        if (word == QLatin1String("M"))
            paths += Points();
        else if (word == QLatin1String("Z")) {
            if (paths.last().last() != paths.last().first())
                paths.last() += paths.last().first();
        } else if (word != QLatin1String("C") && word != QLatin1String("L")) {
            if (hasX)
                paths.last() += QPointF(x, word.toDouble());
            x = word.toDouble();
            hasX = !hasX;
        }
    }
    return paths;
}

struct WrittenPart
{
    QString name;
    QHash<QString, QList<Points>> byColour;
};

/// Sheet by sheet; coordinates as they stand in the file.
QList<QList<WrittenPart>> partsIn(const std::string &svg)
{
    QList<QList<WrittenPart>> sheets;
    QXmlStreamReader reader(QByteArray::fromStdString(svg));
    while (!reader.atEnd()) {
        if (reader.readNext() != QXmlStreamReader::StartElement)
            continue;
        const QString id = reader.attributes().value(QLatin1String("id")).toString();
        if (id.startsWith(QLatin1String("sheet-")))
            sheets += QList<WrittenPart>();
        else if (id.startsWith(QLatin1String("part-")))
            sheets.last() += WrittenPart();
        else if (reader.name() == QLatin1String("title"))
            sheets.last().last().name = reader.readElementText();
        else if (reader.name() == QLatin1String("path"))
            sheets.last()
                .last()
                .byColour[reader.attributes().value(QLatin1String("stroke")).toString()] +=
                pointsIn(reader.attributes().value(QLatin1String("d")).toString());
    }
    return sheets;
}

QList<Points> pointsOf(const QPainterPath &path)
{
    QList<Points> paths;
    for (int i = 0; i < path.elementCount(); ++i) {
        if (path.elementAt(i).isMoveTo())
            paths += Points();
        paths.last() += QPointF(path.elementAt(i));
    }
    return paths;
}

/// bottom  y of the sheet's lower edge in the file
void compare(const QPainterPath &shown, const QList<Points> &written, double bottom)
{
    const QList<Points> paths = pointsOf(shown);
    QCOMPARE(paths.size(), written.size());
    for (qsizetype i = 0; i < paths.size(); ++i) {
        QCOMPARE(paths[i].size(), written[i].size());
        for (qsizetype k = 0; k < paths[i].size(); ++k) {
            const QPointF off =
                paths[i][k] - QPointF(written[i][k].x(), bottom - written[i][k].y());
            QVERIFY2(off.manhattanLength() < 2e-3, "as far as files are rounded");
        }
    }
}

Cutting cuttingOf(const QString &sample)
{
    const auto loaded =
        io::readDocument(QStringLiteral(FFF_SOURCES "/resources/samples/%1.fff").arg(sample));
    return *makeCutting(test::analysed(loaded->document));
}

} // namespace

void TestSheetPaths::theyAreTheWriters_data()
{
    QTest::addColumn<QString>("sample");
    for (const char *sample : {"bridge", "dinosaur", "gears", "cutlery_man", "organiser"})
        QTest::newRow(sample) << QString::fromLatin1(sample);
}

// Wrong: one sees something else than what the laser does.
void TestSheetPaths::theyAreTheWriters()
{
    QFETCH(QString, sample);
    const Cutting cutting = cuttingOf(sample);
    const std::vector<SheetPaths> sheets = sheetPaths(cutting.drawing);
    const auto written = partsIn(*io::svgFormat().writeCutting(cutting.drawing, {}));
    QCOMPARE(static_cast<qsizetype>(sheets.size()), written.size());
    double bottom = 0.0; // sheets lie below one another, 10 mm apart
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        bottom += sheets[i].size.height() + (i > 0 ? 10.0 : 0.0);
        const QList<WrittenPart> &parts = written[static_cast<qsizetype>(i)];
        QCOMPARE(static_cast<qsizetype>(sheets[i].parts.size()), parts.size());
        for (qsizetype k = 0; k < parts.size(); ++k) {
            const PartPaths &shown = sheets[i].parts[static_cast<std::size_t>(k)];
            QCOMPARE(shown.name, parts[k].name);
            compare(shown.cuts, parts[k].byColour.value(QStringLiteral("#ff0000")), bottom);
            compare(shown.label, parts[k].byColour.value(QStringLiteral("#0000ff")), bottom);
            compare(shown.engraved, parts[k].byColour.value(QStringLiteral("#000000")), bottom);
            compare(shown.scored, parts[k].byColour.value(QStringLiteral("#00ff00")), bottom);
        }
    }
}

// Wrong: a number that lies over the edge of its part, or over another part.
// Wrong: a preview of closed outlines, and parts that stay in their sheet.
void TestSheetPaths::bridgesAreWhereTheFileHasThem()
{
    QFETCH(QString, sample);
    CuttingDrawing drawing = cuttingOf(sample).drawing;
    CutFinish finish;
    finish.tabs = 3;
    finish.tabWidth = 0.5;
    finish.lead = 1.0;
    for (CuttingSheet &sheet : drawing.sheets)
        sheet.finish = finish;
    const std::vector<SheetPaths> sheets = sheetPaths(drawing);
    const auto written = partsIn(*io::svgFormat().writeCutting(drawing, {}));
    double bottom = 0.0;
    int opened = 0;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        bottom += sheets[i].size.height() + (i > 0 ? 10.0 : 0.0);
        for (std::size_t k = 0; k < sheets[i].parts.size(); ++k) {
            const PartPaths &shown = sheets[i].parts[k];
            const WrittenPart &part = written[static_cast<qsizetype>(i)][static_cast<qsizetype>(k)];
            compare(cutLines(shown), part.byColour.value(QStringLiteral("#ff0000")), bottom);
            opened += shown.followed.toSubpathPolygons().size() > // each gap makes one more
                      shown.cuts.toSubpathPolygons().size();
        }
    }
    QVERIFY2(opened > 0, "a sample whose parts have room for no bridge");
}

void TestSheetPaths::numbersAreReadInside()
{
    QFETCH(QString, sample);
    for (const SheetPaths &sheet : sheetPaths(cuttingOf(sample).drawing)) {
        for (const PartPaths &part : sheet.parts) {
            QVERIFY(!part.hasNumber || part.cuts.contains(part.roomiest));
            for (const double scale : {0.3, 1.0, 2.0}) {
                const QTransform transform = QTransform::fromScale(scale, -scale);
                const int size = digitsThatFit(part, transform, QApplication::font());
                QVERIFY(size == 0 || (size >= kLeastDigits && size <= kMostDigits));
                if (size > 0) // at least as high as wide it is inside
                    QVERIFY(part.cuts.contains(part.roomiest + QPointF(0.0, 0.3 * size / scale)));
            }
        }
    }
}

void TestSheetPaths::theBarIsWhereTheFileHasIt()
{
    const Cutting cutting = cuttingOf(QStringLiteral("bridge"));
    const std::string svg = *io::svgFormat().writeCutting(cutting.drawing, {});
    const auto at = svg.find("reference-100mm-10mm");
    QVERIFY(at != std::string::npos);
    QXmlStreamReader reader(QByteArray::fromStdString(svg.substr(svg.find("<rect", at))));
    reader.readNextStartElement();
    const auto number = [&reader](const char *name) {
        return reader.attributes().value(QLatin1String(name)).toDouble();
    };
    const double bottom = number("y") - 10.0; // of the sheet above
    const QRectF bar = referenceBar();
    QCOMPARE(bar.size(), QSizeF(number("width"), number("height")));
    QCOMPARE(bar.left(), number("x"));
    QCOMPARE(bottom - bar.bottom(), number("y"));
}

FFF_TEST_WITH(TestSheetPaths, fff::testing::runWithin<TestSheetPaths, QApplication>)
#include "tst_sheet_paths.moc"
