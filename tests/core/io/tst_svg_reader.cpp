// Drawings of other programs: if one of these fails, somebody's drawing comes in another size or
// shape, or a broken one is taken, or refused without saying where.
#include <QTest> // first: it defines macros that others look for

#include "core/assembly/assembly.h"
#include "core/assembly/cut_section.h"
#include "core/base/tolerances.h"
#include "core/fabrication/layout.h"
#include "core/geometry/figure.h"
#include "core/geometry/outlines.h"
#include "core/io/compressed.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/svg_reader.h"
#include "core/io/svg_writer.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <cmath>

using namespace fff;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// What the first comment of a file says that it holds.
QMap<QString, QString> expectedOf(const QByteArray &content)
{
    static const QRegularExpression comment(QStringLiteral("<!-- expect (.*) -->"));
    QMap<QString, QString> expected;
    const QString words = comment.match(QString::fromUtf8(content)).captured(1);
    for (const QString &word : words.split(u' ', Qt::SkipEmptyParts))
        expected.insert(word.section(u'=', 0, 0), word.section(u'=', 1));
    return expected;
}

const QMap<ErrorCode, QString> kNames{{ErrorCode::BadSyntax, QStringLiteral("BadSyntax")},
                                      {ErrorCode::BadValue, QStringLiteral("BadValue")},
                                      {ErrorCode::BadCount, QStringLiteral("BadCount")}};

std::vector<CurvePath> pathsOf(const io::SvgDrawing &drawing)
{
    std::vector<CurvePath> paths;
    for (const io::SvgDrawing::Line &line : drawing.lines)
        paths.push_back(line.path);
    return paths;
}

Vec2 sizeOf(const io::SvgDrawing &drawing)
{
    Box2 box;
    for (const io::SvgDrawing::Line &line : drawing.lines)
        for (const Vec2 &p : line.path.flatten(1e-4))
            box.extend(p);
    return box.size();
}

} // namespace

class TestSvgReader : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void otherProgramsFiles_data();
    void otherProgramsFiles();
    void whatWeWroteComesBackAsItWas();
    void aCuttingFileIsKnown();
    void packedAndOtherwiseEncodedFiles_data();
    void packedAndOtherwiseEncodedFiles();
    void aPackedFileEndsAtItsLimit();
    void errorsOfOtherEncodingsNameTheLine();
    void whatIsReadIsNotCopiedForEveryCommand();
};

void TestSvgReader::otherProgramsFiles_data()
{
    QTest::addColumn<QString>("path");
    const QDir folder(QStringLiteral(FFF_TEST_DATA "/drawings"));
    const QStringList names = folder.entryList({QStringLiteral("*.svg")}, QDir::Files, QDir::Name);
    QVERIFY2(names.size() >= 60, "files are missing");
    for (const QString &name : names)
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

void TestSvgReader::otherProgramsFiles()
{
    QFETCH(QString, path);
    const QByteArray content = contentOf(path);
    const QMap<QString, QString> expected = expectedOf(content);
    const std::string name = QFileInfo(path).fileName().toStdString();
    const Result<io::SvgDrawing> drawing =
        io::readSvg({content.constData(), static_cast<std::size_t>(content.size())}, name);
    if (expected.contains(QStringLiteral("error")) || expected.isEmpty()) {
        QVERIFY(!drawing);
        const QString wanted = expected.value(QStringLiteral("error"), QStringLiteral("BadSyntax"));
        QCOMPARE(kNames.value(drawing.error().code), wanted);
        // One sentence, which names the file.
        const QString sentence = io::errorText(drawing.error());
        QVERIFY2(sentence.startsWith(QString::fromStdString(name)), qPrintable(sentence));
        QCOMPARE(sentence.count(u'\n'), 0);
        const QString words = expected.value(QStringLiteral("says")).replace(u'.', u' ');
        QVERIFY2(sentence.contains(words), qPrintable(sentence));
        return;
    }
    QVERIFY2(drawing, drawing ? "" : qPrintable(io::errorText(drawing.error())));
    const auto number = [&expected](const char *key, int otherwise) {
        return expected.value(QString::fromLatin1(key), QString::number(otherwise)).toInt();
    };
    QCOMPARE(std::ssize(drawing->lines), number("lines", 1));
    const auto open = std::count_if(drawing->lines.begin(), drawing->lines.end(),
                                    [](const auto &line) { return !line.path.isClosed(); });
    QCOMPARE(open, number("open", 0));
    QCOMPARE(drawing->texts, number("texts", 0));
    QCOMPARE(drawing->pictures, number("pictures", 0));
    if (const QString size = expected.value(QStringLiteral("size")); !size.isEmpty()) {
        const Vec2 wanted(size.section(u'x', 0, 0).toDouble(), size.section(u'x', 1).toDouble());
        const Vec2 is = sizeOf(*drawing);
        QVERIFY2((is - wanted).norm() < 2e-3,
                 qPrintable(QStringLiteral("%1 x %2").arg(is.x()).arg(is.y())));
    }
    const std::vector<CurvePath> lines = joined(pathsOf(*drawing), kDrawnGap);
    if (expected.contains(QStringLiteral("joined")))
        QCOMPARE(std::ssize(lines), number("joined", 0));
    const std::vector<Outline> outlines = *outlinesOf(lines);
    if (expected.contains(QStringLiteral("pieces")))
        QCOMPARE(std::ssize(outlines), number("pieces", 0));
    if (expected.contains(QStringLiteral("holes")))
        QCOMPARE(std::ssize(outlines.front().holes), number("holes", 0));
    if (const QString area = expected.value(QStringLiteral("area")); !area.isEmpty()) {
        double is = 0.0;
        for (const Outline &outline : outlines) {
            is += outline.outer.signedArea();
            for (const Contour &hole : outline.holes)
                is += hole.signedArea();
        }
        QVERIFY2(std::abs(is - area.toDouble()) < 5e-2, qPrintable(QString::number(is)));
    }
}

/// A shape that is written and read again is the same to 1e-6 mm: curves, holes and straight edges.
void TestSvgReader::whatWeWroteComesBackAsItWas()
{
    Figure star = newFigure(*figureKind("star"));
    Figure hole = newFigure(*figureKind("circle"));
    hole.numbers = {7.0};
    hole.centre = {1.0, 2.0};
    const Result<ShapePointer> shape = Shape::make(*contourOf(star), {*contourOf(hole)});
    QVERIFY(shape);
    NewSection section;
    section.shape = *shape;
    const Result<Document> document = addSection(newDocument(), section);
    QVERIFY(document);
    const Model model = evaluate(*document);
    const Assembly assembly = assemble(model);
    const std::vector<CutSectionPointer> cuts{
        std::make_shared<const CutSection>(**shape, std::vector<Slit>(), nullptr)};
    const std::vector<Part> parts = makeParts(model, assembly, bodiesOf(model, cuts));
    LayoutOptions options;
    options.turnsFreely = false;
    Layout layout = layOut(parts, model, options);
    QCOMPARE(layout.sheets.size(), std::size_t(1));
    layout.sheets[0].placements[0].turn = Vec2::UnitX();
    layout.sheets[0].placements[0].offset = {100.0, 100.0};
    const std::string svg =
        io::writeSvg(cuttingDrawing(layout, parts, {}, model, {.hasReference = false}));

    const Result<io::SvgDrawing> drawing = io::readSvg(svg);
    QVERIFY(drawing);
    const std::vector<Outline> outlines = *outlinesOf(pathsOf(*drawing));
    QCOMPARE(outlines.size(), std::size_t(1));
    QCOMPARE(outlines[0].holes.size(), std::size_t(1));
    const auto compare = [](const Contour &read, const Contour &written, const Vec2 &shift) {
        QCOMPARE(read.points().size(), written.points().size());
        // The reader may begin elsewhere on it.
        double best = 1e9;
        for (std::size_t from = 0; from < read.points().size(); from += 3) {
            double worst = 0.0;
            for (std::size_t i = 0; i < read.points().size(); ++i)
                worst = std::max(worst, (read.points()[(from + i) % read.points().size()] + shift -
                                         written.points()[i])
                                            .norm());
            best = std::min(best, worst);
        }
        QVERIFY2(best <= 1e-6 * std::sqrt(2.0), qPrintable(QString::number(best)));
    };
    Box2 box;
    for (const Vec2 &p : (*shape)->contour().flatten(kCutChord).points)
        box.extend(p);
    compare(outlines[0].outer, (*shape)->contour(), box.min);
    compare(outlines[0].holes[0], (*shape)->holes()[0], box.min);
}

void TestSvgReader::packedAndOtherwiseEncodedFiles_data()
{
    QTest::addColumn<QString>("path");
    const QDir folder(QStringLiteral(FFF_TEST_DATA "/packed"));
    for (const QString &name : folder.entryList(QDir::Files, QDir::Name))
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

// Wrong: a drawing that another program packed would have to be unpacked by hand, or a damaged one
// would come in halves. All of them hold a rectangle of 10 mm x 20 mm.
void TestSvgReader::packedAndOtherwiseEncodedFiles()
{
    QFETCH(QString, path);
    const Result<io::SvgDrawing> drawing = io::readDrawing(path);
    const QString name = QFileInfo(path).fileName();
    if (name.startsWith(QStringLiteral("broken"))) {
        QVERIFY(!drawing);
        QVERIFY(io::errorText(drawing.error()).startsWith(name));
        return;
    }
    QVERIFY2(drawing, drawing ? "" : qPrintable(io::errorText(drawing.error())));
    QCOMPARE(drawing->lines.size(), std::size_t(1));
    QVERIFY((sizeOf(*drawing) - Vec2(10.0, 20.0)).norm() < 1e-9);
}

// Wrong: a few kilobytes that stand for gigabytes would take all of the memory.
void TestSvgReader::aPackedFileEndsAtItsLimit()
{
    const std::string packed =
        contentOf(QStringLiteral(FFF_TEST_DATA "/packed/in-two.svgz")).toStdString();
    QVERIFY(io::isCompressed(packed));
    const Result<std::string> whole = io::uncompressed(packed, 10'000, "in-two.svgz");
    QVERIFY(whole);
    QVERIFY(io::uncompressed(packed, whole->size(), "in-two.svgz"));
    const Result<std::string> tooLarge = io::uncompressed(packed, whole->size() - 1, "in-two.svgz");
    QVERIFY(!tooLarge);
    QCOMPARE(tooLarge.error().code, ErrorCode::BadCount);
}

void TestSvgReader::errorsOfOtherEncodingsNameTheLine()
{
    const QString text =
        QStringLiteral("<svg>\n<title>Flügel</title>\n<path d=\"M0 0L1 x\"/></svg>");
    const QByteArray utf16(reinterpret_cast<const char *>(text.utf16()), 2 * text.size());
    const Result<io::SvgDrawing> drawing = io::readSvg(utf16.toStdString(), "wing.svg");
    QVERIFY(!drawing);
    QCOMPARE(drawing.error().place, std::string("wing.svg:3"));
}

// Wrong: each command of a path would cost the rest of the path. This one would take minutes.
void TestSvgReader::whatIsReadIsNotCopiedForEveryCommand()
{
    std::string text = "<svg width=\"9mm\" height=\"9mm\" viewBox=\"0 0 9 9\"><path d=\"M0 0";
    constexpr int kCommands = 300'000;
    for (int i = 1; i < kCommands; ++i)
        text += "L" + std::to_string(i) + " " + std::to_string(i % 7);
    const Result<io::SvgDrawing> drawing = io::readSvg(text + "\" stroke=\"red\"/></svg>");
    QVERIFY(drawing);
    QCOMPARE(drawing->lines.front().path.segmentCount(), kCommands - 1);
}

void TestSvgReader::aCuttingFileIsKnown()
{
    const Result<io::SvgDrawing> ours =
        io::readSvg("<svg width=\"10mm\" height=\"10mm\" viewBox=\"0 0 10 10\"><metadata>"
                    "<fff:cutting xmlns:fff=\"urn:flatfitfab:cutting\"/></metadata>"
                    "<path stroke=\"#FF0000\" fill=\"none\" d=\"M0 0H5V5Z\"/></svg>");
    QVERIFY(ours);
    QVERIFY(ours->isCuttingFile);
    QCOMPARE(ours->lines[0].stroke, std::string("#ff0000"));
    QVERIFY(!ours->lines[0].isFilled);
}

FFF_TEST(TestSvgReader)
#include "tst_svg_reader.moc"
