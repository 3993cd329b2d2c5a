// Cutting files other than SVG. If this fails, a machine or its program gets what it does not
// understand, or something else than what was drawn. What other programs read of them is in
// tests/app/check_cutting_files.py.
#include "core/analysis/cutting.h"
#include "core/fabrication/machine.h"
#include "core/io/dxf_writer.h"
#include "core/io/gcode_writer.h"
#include "core/io/lightburn_writer.h"
#include "core/io/parts_csv.h"
#include "core/io/pdf_tiles.h"
#include "core/io/pdf_writer.h"
#include "core/io/svg_writer.h"
#include "core/io/threemf_writer.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

#include <map>
#include <sstream>

using namespace fff;
using namespace fff::test;

class TestCuttingFormats : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void gcodeOfAPlate();
    void dxfOfAPlate_data();
    void dxfOfAPlate();
    void lightBurnOfAPlate();
    void csvOfAPlate();
    void namesBreakNothing_data();
    void namesBreakNothing();
    void theMachineDecides();
    void severalSheets();
    void tilesCoverAndOverlap_data();
    void tilesCoverAndOverlap();
    void paperKeepsItsMargins();
    void sameInputSameBytes();
};

namespace {

/// One plate of 40 × 30 mm in the lower left corner of its sheet, without a number and a kerf.
CuttingDrawing plateDrawing(const std::string &name = "Plate", DrawingOptions options = {},
                            int count = 1, const Vec2 &sheet = {60, 50})
{
    Document document = onSheets(newDocument(), sheet);
    for (int i = 0; i < count; ++i)
        document = withSection(document, plateOf(0, 0, 40, 30), front(50.0 * i));
    for (const SectionPointer &section : std::vector(document.sections))
        document = *renameSection(document, section->id, name);
    const Analysis analysis = analysed(document);
    std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    const std::vector<ListedPart> list = partList(parts, analysis.model);
    const Layout layout = layOut(parts, analysis.model, {});
    CuttingDrawing drawing = cuttingDrawing(layout, std::move(parts), {}, analysis.model, options);
    drawing.list = list;
    return drawing;
}

DrawingOptions withoutBar()
{
    DrawingOptions options;
    options.hasReference = false;
    return options;
}

/// Group codes and values.
std::vector<std::pair<int, std::string>> groupsOf(const std::string &dxf)
{
    std::vector<std::pair<int, std::string>> groups;
    std::istringstream lines(dxf);
    std::string code, value;
    while (std::getline(lines, code) && std::getline(lines, value))
        groups.emplace_back(std::stoi(code), value);
    return groups;
}

bool isWellFormed(const std::string &xml)
{
    QXmlStreamReader reader(QByteArray::fromStdString(xml));
    while (!reader.atEnd())
        reader.readNext();
    return !reader.hasError();
}

} // namespace

void TestCuttingFormats::gcodeOfAPlate()
{
    QCOMPARE(io::writeGCode(plateDrawing("Plate", withoutBar())),
             std::string("; FlatFitFab " FFF_VERSION ", millimetres, kerf not applied\n"
                         "; For Laser cutter. Try speeds and powers on a piece of waste first.\n"
                         "G21\nG90\nG17\n"
                         "; Sheet 1, 60 x 50 mm, lower left corner at X0 Y0\n"
                         "; Birch plywood, 3 mm\n"
                         "; Part 1\n"
                         "G0 X5 Y5\n"
                         "M4 S1000\n"
                         "G1 X45 Y5 F600\n"
                         "G1 X45 Y35\n"
                         "G1 X5 Y35\n"
                         "G1 X5 Y5\n"
                         "M5\n"
                         "M5\nG0 X0 Y0\nM2\n"));
}

void TestCuttingFormats::dxfOfAPlate_data()
{
    QTest::addColumn<io::DxfVersion>("version");
    QTest::addColumn<std::string>("code");
    QTest::newRow("2000") << io::DxfVersion::R2000 << std::string("AC1015");
    QTest::newRow("R12") << io::DxfVersion::R12 << std::string("AC1009");
}

void TestCuttingFormats::dxfOfAPlate()
{
    QFETCH(io::DxfVersion, version);
    QFETCH(std::string, code);
    const auto groups = groupsOf(io::writeDxf(plateDrawing("Plate", withoutBar()), version));
    std::map<std::string, std::string> variables;
    std::set<std::string> layers;
    std::vector<Vec2> vertices;
    bool isEntity = false;
    int closed = 0;
    for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
        if (groups[i].first == 9)
            variables[groups[i].second] = groups[i + 1].second;
        if (groups[i] == std::pair(2, std::string("ENTITIES")))
            isEntity = true;
        if (isEntity && groups[i].first == 8)
            layers.insert(groups[i].second);
        const bool isVertex = version == io::DxfVersion::R2000 ||
                              (i > 1 && groups[i - 2] == std::pair(0, std::string("VERTEX")));
        if (isEntity && groups[i].first == 10 && isVertex)
            vertices.emplace_back(std::stod(groups[i].second), std::stod(groups[i + 1].second));
        closed += isEntity && groups[i] == std::pair(70, std::string("1")) ? 1 : 0;
    }
    QCOMPARE(variables["$ACADVER"], code);
    QCOMPARE(variables["$INSUNITS"], std::string("4"));
    QCOMPARE(variables["$MEASUREMENT"], std::string("1"));
    QCOMPARE(variables["$EXTMIN"], std::string("5"));
    QCOMPARE(variables["$EXTMAX"], std::string("45"));
    QCOMPARE(layers, std::set<std::string>{"CUT"});
    QCOMPARE(closed, 1);
    QCOMPARE(vertices, (std::vector<Vec2>{{5, 5}, {45, 5}, {45, 35}, {5, 35}}));
    QCOMPARE(groups.back(), std::pair(0, std::string("EOF")));
}

void TestCuttingFormats::lightBurnOfAPlate()
{
    const std::string project = io::writeLightBurn(plateDrawing("Plate", withoutBar()));
    QVERIFY(isWellFormed(project));
    QVERIFY(project.find("<Shape Type=\"Path\" CutIndex=\"0\">\n"
                         "        <XForm>1 0 0 1 0 0</XForm>\n"
                         "        <VertList>V5 5c0x1c1x1V45 5c0x1c1x1V45 35c0x1c1x1V5 "
                         "35c0x1c1x1</VertList>\n"
                         "        <PrimList>L0 1L1 2L2 3L3 0</PrimList>\n") != std::string::npos);
    QCOMPARE(QString::fromStdString(project).count(QStringLiteral("<Shape ")), 1);
    QCOMPARE(QString::fromStdString(project).count(QStringLiteral("<CutSetting ")), 4);
}

void TestCuttingFormats::csvOfAPlate()
{
    QCOMPARE(io::writePartsCsv(plateDrawing("Plate, \"left\"\nor right")),
             std::string("number,section,sheet,stock,thickness_mm,width_mm,height_mm,area_mm2,"
                         "cut_mm,engraved_mm,scored_mm,seconds\r\n"
                         "1,\"Plate, \"\"left\"\"\nor right\",1,Birch plywood,3.000,40.000,30.000,"
                         "1200.00,140.00,0.00,0.00,14.0\r\n"));
}

void TestCuttingFormats::namesBreakNothing_data()
{
    QTest::addColumn<std::string>("name");
    QTest::newRow("markup") << std::string("a<b>&\"c'");
    QTest::newRow("lines") << std::string("a\nM3 S1000\r\nG1 X900");
    QTest::newRow("a comment's end") << std::string("a) (b; c");
    QTest::newRow("an emoji") << std::string("\xF0\x9F\xA6\x81 \xC3\xBC");
    QTest::newRow("a control character") << std::string("a\x01\x0B"
                                                        "b");
    QTest::newRow("broken UTF-8") << std::string("a\xff"
                                                 "b");
    QTest::newRow("long") << std::string(500, 'x');
}

// Names are in no line that a machine follows, and in XML as what they are.
void TestCuttingFormats::namesBreakNothing()
{
    QFETCH(std::string, name);
    CuttingDrawing drawing = plateDrawing(name);
    drawing.stocks.front().name = name;
    QVERIFY(isWellFormed(io::writeSvg(drawing)));
    QVERIFY(isWellFormed(io::writeLightBurn(drawing)));
    CuttingDrawing plain = plateDrawing();
    const auto moves = [](const std::string &gcode) {
        std::string moved;
        std::istringstream lines(gcode);
        for (std::string line; std::getline(lines, line);)
            if (!line.starts_with(';'))
                moved += line + '\n';
        return moved;
    };
    QCOMPARE(moves(io::writeGCode(drawing)), moves(io::writeGCode(plain)));
    const auto isPlain = [](const std::string &text) {
        return std::all_of(text.begin(), text.end(),
                           [](char c) { return (c >= ' ' && c <= '~') || c == '\n'; });
    };
    QVERIFY(isPlain(io::writeGCode(drawing)));
    for (const io::DxfVersion version : {io::DxfVersion::R2000, io::DxfVersion::R12}) {
        const std::string dxf = io::writeDxf(drawing, version);
        QVERIFY(isPlain(dxf));
        QCOMPARE(groupsOf(dxf).size(), groupsOf(io::writeDxf(plain, version)).size());
    }
    const QString csv = QString::fromStdString(io::writePartsCsv(drawing));
    QCOMPARE(csv.count(QStringLiteral("1200.00,")), 1);
}

// Colours and strokes, layers, and the lines before and behind.
void TestCuttingFormats::theMachineDecides()
{
    auto machine = std::make_shared<Machine>();
    machine->stroke = 0.025;
    machine->hasGuides = false;
    Machine::Process &cut = machine->processes[static_cast<std::size_t>(Purpose::OuterCut)];
    cut.colour = 0x0000FF;
    cut.layer = 7;
    cut.speed = 5.0;
    cut.power = 0.5;
    machine->gcode.head = {"G21", "$H"};
    machine->gcode.on = "M3";
    machine->gcode.mostPower = 255.0;
    DrawingOptions options;
    options.machine = machine;
    const CuttingDrawing drawing = plateDrawing("Plate", options);
    const auto has = [](const std::string &text, const char *part) {
        return text.find(part) != std::string::npos;
    };
    const std::string svg = io::writeSvg(drawing);
    QVERIFY(has(svg, "stroke=\"#0000ff\"") && has(svg, "stroke-width=\"0.025\""));
    QVERIFY(!has(svg, "reference"));
    QVERIFY(has(io::writeLightBurn(drawing), "CutIndex=\"7\""));
    QVERIFY(has(io::writeDxf(drawing), "2\nCUT\n70\n0\n62\n5\n"));
    const std::string gcode = io::writeGCode(drawing);
    QVERIFY(has(gcode, "\nG21\n$H\n") && has(gcode, "\nM3 S127.5\n") && has(gcode, " F300\n"));
}

// Wrong: the second sheet is cut over the first one.
void TestCuttingFormats::severalSheets()
{
    const CuttingDrawing drawing = plateDrawing("Plate", {}, 2);
    QCOMPARE(drawing.sheets.size(), std::size_t(2));
    QVERIFY(io::writeGCode(drawing).find("M5\nM0\n; Sheet 2") != std::string::npos);
    const auto groups = groupsOf(io::writeDxf(drawing));
    const auto high = std::find(groups.begin(), groups.end(), std::pair(9, std::string("$EXTMAX")));
    QCOMPARE((high + 1)->second, std::string("100")); // the bar
    QCOMPARE((high + 2)->second, std::string("130")); // two sheets, it, and gaps
    QCOMPARE(QString::fromStdString(io::writeLightBurn(drawing)).count(QStringLiteral("<Shape ")),
             5);
    QCOMPARE(QString::fromLatin1(QByteArray::fromStdString(io::writePdf(drawing)))
                 .count(QStringLiteral("/Type /Page ")),
             3);
}

void TestCuttingFormats::tilesCoverAndOverlap_data()
{
    QTest::addColumn<Vec2>("size");
    QTest::addColumn<int>("count");
    QTest::newRow("on one") << Vec2(100, 150) << 1;
    QTest::newRow("just on one") << Vec2(190, 271) << 1;
    QTest::newRow("turned") << Vec2(277, 184) << 1;
    QTest::newRow("just too wide") << Vec2(191, 271) << 2;
    QTest::newRow("a sheet") << Vec2(600, 400) << 8;
    QTest::newRow("long") << Vec2(9000, 20) << 34;
}

void TestCuttingFormats::tilesCoverAndOverlap()
{
    QFETCH(Vec2, size);
    QFETCH(int, count);
    Box2 box;
    box.extend(Vec2(-7, 3));
    box.extend(Vec2(Vec2(-7, 3) + size));
    const io::PdfTiles tiles = io::tilesOver(box, {210, 297});
    QCOMPARE(static_cast<int>(tiles.tiles.size()), count);
    QCOMPARE(tiles.columns * tiles.rows, count);
    std::set<std::string> names;
    Box2 covered;
    for (const io::PdfTile &tile : tiles.tiles) {
        names.insert(tile.name());
        covered.extend(tile.corner);
        covered.extend(Vec2(tile.corner + tiles.room()));
        // The next one begins before this one ends, by the overlap.
        for (const io::PdfTile &other : tiles.tiles)
            if (other.row == tile.row && other.column == tile.column + 1)
                QVERIFY(std::abs(tile.corner.x() + tiles.room().x() - io::kPaperOverlap -
                                 other.corner.x()) < 1e-9);
    }
    QCOMPARE(names.size(), tiles.tiles.size());
    QVERIFY(names.contains("A1"));
    QVERIFY((covered.min.array() <= box.min.array() + 1e-9).all() &&
            (covered.max.array() >= box.max.array() - 1e-9).all());
    QCOMPARE((io::PdfTile{26, 4, Vec2::Zero()}).name(), std::string("AA5"));
}

/// What printers leave white took the box to measure and the page's name, 3 mm from the edge.
void TestCuttingFormats::paperKeepsItsMargins()
{
    const QByteArray pdf = QByteArray::fromStdString(
        io::writePdf(plateDrawing("Plate", {}, 8, {600, 400}), io::PdfPaper::A4));
    const QRegularExpression number(QStringLiteral("-?[0-9]+\\.?[0-9]*"));
    int pages = 0;
    for (qsizetype at = pdf.indexOf("\nstream\n"); at >= 0;
         at = pdf.indexOf("\nstream\n", at + 1)) {
        ++pages;
        const qsizetype from = at + 8;
        const QByteArray packed = pdf.mid(from, pdf.indexOf("\nendstream", from) - from);
        const QByteArray page = qUncompress(QByteArray("\0\1\0\0", 4) + packed);
        QVERIFY(page.contains("Sheet 1, page"));
        bool isClipped = false;
        for (const QByteArray &line : page.split('\n')) {
            isClipped = (isClipped || line.startsWith("q ")) && line != "Q";
            const bool isText = line.startsWith("BT "), isEdge = line.endsWith(" l S"),
                       isBox = line.endsWith(" re S");
            if (isClipped || !(isText || isEdge || isBox))
                continue;
            std::vector<double> numbers;
            auto found = number.globalMatch(
                QString::fromLatin1(isText ? line.mid(line.indexOf("Tf ")) : line));
            while (found.hasNext())
                numbers.push_back(found.next().captured().toDouble());
            std::vector<Vec2> points{{numbers.at(0), numbers.at(1)}};
            if (!isText)
                points.emplace_back(numbers.at(2), numbers.at(3));
            if (isBox)
                points[1] += points[0];
            for (const Vec2 &p : points)
                QVERIFY2(p.minCoeff() >= 10.0 && (Vec2(297, 297) - p).minCoeff() >= 10.0,
                         line.constData());
        }
    }
    QVERIFY(pages > 1);
}

void TestCuttingFormats::sameInputSameBytes()
{
    const CuttingDrawing a = plateDrawing("Plate", {}, 3), b = plateDrawing("Plate", {}, 3);
    QVERIFY(io::writeDxf(a) == io::writeDxf(b));
    QVERIFY(io::writePdf(a) == io::writePdf(b));
    QVERIFY(io::writePdf(a, io::PdfPaper::A4) == io::writePdf(b, io::PdfPaper::A4));
    QVERIFY(io::writeLightBurn(a) == io::writeLightBurn(b));
    QVERIFY(io::writeGCode(a) == io::writeGCode(b));
}

FFF_TEST(TestCuttingFormats)
#include "tst_cutting_formats.moc"
