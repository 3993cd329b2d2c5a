// A disc as wide as the kerf along the cuts of a written file, against the parts as they were
// designed: it enters none of them, and comes to all of their edges where it can. If this fails,
// what a file cuts is not what was drawn.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/fabrication/kerf.h"
#include "core/fabrication/layout.h"
#include "core/io/document_file.h"
#include "core/io/dxf_writer.h"
#include "core/io/gcode_writer.h"
#include "core/io/lightburn_writer.h"
#include "core/io/svg_writer.h"
#include "core/operations/evaluate.h"
#include "tests/core/analysed.h"
#include "tests/core/fabrication/swept_file_oracle.h"
#include "tests/core/session/random_edits.h"
#include "tests/test_program.h"

#include <QDir>

#include <memory>
#include <optional>

using namespace fff;
using namespace fff::test;

namespace {

constexpr unsigned kMadeUp = 100, kOfARow = 10;
constexpr int kEdits = 30;

/// Of all its stocks.
Analysis withKerf(Document document, double kerf)
{
    for (auto &stock : document.stocks) {
        Stock changed = *stock;
        changed.kerf = kerf;
        stock = std::make_shared<const Stock>(changed);
    }
    return analysed(evaluate(std::move(document)));
}

/// What lies where, and the drawing of that with nothing but cuts.
struct LaidOut
{
    std::vector<Part> designed;
    Layout layout;
    CuttingDrawing drawing;
};

/// Nothing where the kerf closes something: nothing is written then.
std::optional<LaidOut> laidOut(const Analysis &analysis)
{
    LaidOut all;
    all.designed = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    auto cut = compensateKerf(all.designed, analysis.model, analysis.bodies);
    if (!cut)
        return std::nullopt;
    LayoutOptions layout;
    layout.spacing = 8.0; // no tool of these tests comes to two parts at once
    layout.margin = 8.0;
    all.layout = layOut(*cut, analysis.model, layout);
    DrawingOptions options;
    options.hasReference = false;
    options.isKerfApplied = true;
    options.finish = CutFinish();
    all.drawing = cuttingDrawing(all.layout, *std::move(cut), {}, analysis.model, options);
    return all;
}

struct FileFormat
{
    const char *name;
    std::vector<ReadCut> (*cuts)(const CuttingDrawing &sheet);
};

const FileFormat kFormats[] = {
    {"SVG",
     [](const CuttingDrawing &d) { return cutsInSvg(io::writeSvg(d), QStringLiteral("#ff0000")); }},
    {"DXF", [](const CuttingDrawing &d) { return cutsInDxf(io::writeDxf(d)); }},
    {"DXF R12",
     [](const CuttingDrawing &d) { return cutsInDxf(io::writeDxf(d, io::DxfVersion::R12)); }},
    {"LightBurn", [](const CuttingDrawing &d) { return cutsInLightBurn(io::writeLightBurn(d)); }},
    {"G-code", [](const CuttingDrawing &d) { return cutsInGCode(io::writeGCode(d)); }},
};

QString firstFault(const LaidOut &all, const Model &model, int &judged)
{
    for (std::size_t i = 0; i < all.drawing.sheets.size(); ++i) {
        const CuttingDrawing sheet = onSheet(all.drawing, i);
        std::vector<std::vector<ReadCut>> files;
        for (const FileFormat &format : kFormats)
            files.push_back(format.cuts(sheet));
        for (const Placement &placement : all.layout.sheets[i].placements) {
            const Part &part = all.designed[static_cast<std::size_t>(placement.part)];
            const auto section = static_cast<std::size_t>(part.section);
            const SweptFileOracle oracle(part.outline, placement.turn, placement.offset,
                                         0.5 * model.stockOf(section).kerf);
            for (std::size_t k = 0; k < files.size(); ++k) {
                ++judged;
                if (const QString fault = oracle.verdict(files[k]); !fault.isEmpty())
                    return QStringLiteral("%1, sheet %2, %3: %4")
                        .arg(QLatin1String(kFormats[k].name))
                        .arg(i + 1)
                        .arg(QString::fromStdString(model.section(section)->name), fault);
            }
        }
    }
    return {};
}

} // namespace

class TestSweptFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatTheOracleFinds();
    void models_data();
    void models();
    void madeUp_data();
    void madeUp();
};

// A test must be able to fail: a path that is off by a hundredth is found, either way.
void TestSweptFiles::whatTheOracleFinds()
{
    const auto plate =
        subtract(*Contour::fromPolygon({{0, 0}, {40, 0}, {40, 30}, {0, 30}}), {}, {}, 0.01)
            ->front();
    const auto cutAt = [](double by) {
        return std::vector<ReadCut>{
            {{{-by, -by}, {40 + by, -by}, {40 + by, 30 + by}, {-by, 30 + by}}, true}};
    };
    const SweptFileOracle oracle(plate, Vec2::UnitX(), Vec2::Zero(), 0.1);
    QCOMPARE(oracle.verdict(cutAt(0.1)), QString());
    QCOMPARE(oracle.verdict(cutAt(0.104)), QString());
    QCOMPARE(oracle.verdict(cutAt(0.096)), QString());
    QVERIFY(oracle.verdict(cutAt(0.09)).startsWith(QStringLiteral("the tool enters")));
    QVERIFY(oracle.verdict(cutAt(0.11)).startsWith(QStringLiteral("the tool does not come")));
    QVERIFY(oracle.verdict({}).startsWith(QStringLiteral("nothing")));
    std::vector<ReadCut> open = cutAt(0.1);
    open.front().isClosed = false; // one side is not cut
    QVERIFY(oracle.verdict(open).startsWith(QStringLiteral("the tool does not come")));
}

void TestSweptFiles::models_data()
{
    QTest::addColumn<QString>("path");
    for (const char *folder : {FFF_SHARED_MODELS, FFF_TEST_DATA "/../../resources/samples"}) {
        const QDir models(QString::fromUtf8(folder));
        for (const QFileInfo &file :
             models.entryInfoList({QStringLiteral("*.txt"), QStringLiteral("*.fff")}))
            QTest::newRow(qPrintable(file.fileName())) << file.filePath();
    }
}

void TestSweptFiles::models()
{
    QFETCH(QString, path);
    const auto read = io::readDocument(path);
    QVERIFY(read);
    const Analysis analysis = withKerf(read->document, 0.2);
    const auto all = laidOut(analysis);
    QVERIFY(all); // a laser's kerf is for every model
    int judged = 0;
    const QString fault = firstFault(*all, analysis.model, judged);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QVERIFY(judged > 0);
}

void TestSweptFiles::madeUp_data()
{
    QTest::addColumn<unsigned>("first");
    for (unsigned first = 1; first <= kMadeUp; first += kOfARow)
        QTest::addRow("seeds %u to %u", first, first + kOfARow - 1) << first;
}

// Models of a hundred random hands: crossings at all angles, slivers, holes.
void TestSweptFiles::madeUp()
{
    QFETCH(unsigned, first);
    int judged = 0;
    for (unsigned seed = first; seed < first + kOfARow; ++seed) {
        RandomEdits edits(seed);
        Document document = newDocument();
        for (int edit = 0; edit < kEdits; ++edit)
            document = edits.next(document);
        const Analysis analysis = withKerf(std::move(document), 0.2);
        const auto all = laidOut(analysis);
        if (!all)
            continue;
        const QString fault = firstFault(*all, analysis.model, judged);
        QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(fault)));
    }
    QVERIFY(judged > 0);
}

FFF_TEST(TestSweptFiles)
#include "tst_swept_files.moc"
