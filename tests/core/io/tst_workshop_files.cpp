// What a workshop gets besides the sheets, and cuts with tabs and leads in each format. If this
// fails, a file says something else than another one of the same parts.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/cutting.h"
#include "core/fabrication/cutting_order.h"
#include "core/fabrication/fit_coupon.h"
#include "core/fabrication/machine.h"
#include "core/io/archive.h"
#include "core/io/formats.h"
#include "core/io/gcode_writer.h"
#include "core/io/svg_writer.h"
#include "core/io/workshop_archive.h"
#include "core/model/materials.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace fff;
using namespace fff::test;

class TestWorkshopFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void finishedCutsAreTheSameInAllFormats();
    void plainCutsAreAsTheyWere();
    void theArchiveHasACoupon();
    void noCouponIsNoFault();
    void eachFormatWritesTheCoupon();
};

namespace {

/// Two plates, 40 × 30 mm.
CuttingDrawing twoPlates(const CutFinish &finish, double thickness = 3.0)
{
    Document document = onSheets(newDocument(), {120, 60});
    for (int i = 0; i < 2; ++i)
        document = withSection(document, plateOf(0, 0, 40, 30), front(50.0 * i));
    const Analysis analysis = analysed(document);
    std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    LayoutOptions layout;
    layout.spacing = 10.0;
    layout.margin = 10.0;
    DrawingOptions options;
    options.hasReference = false;
    options.finish = finish;
    const Layout laid = layOut(parts, analysis.model, layout);
    CuttingDrawing drawing = cuttingDrawing(laid, std::move(parts), {}, analysis.model, options);
    for (Stock &stock : drawing.stocks) {
        stock.thickness = thickness;
        stock.sheet = {600.0, 400.0}; // there is room for a coupon
    }
    return drawing;
}

double cutAlong(const CuttingDrawing &drawing)
{
    double length = 0.0;
    for (const CuttingSheet &sheet : drawing.sheets)
        length += wayAlong(inCuttingOrder(sheet), usualMachine()).cut;
    return length;
}

/// Of G1 moves; plates have no arcs.
double lengthOfGCode(const std::string &gcode)
{
    static const QRegularExpression move(QStringLiteral("^G([01]) X(-?[\\d.]+) Y(-?[\\d.]+)"));
    std::istringstream lines(gcode);
    Vec2 at = Vec2::Zero();
    double length = 0.0;
    for (std::string line; std::getline(lines, line);) {
        const auto found = move.match(QString::fromStdString(line));
        if (!found.hasMatch())
            continue;
        const Vec2 to(found.captured(2).toDouble(), found.captured(3).toDouble());
        length += found.captured(1) == QStringLiteral("1") ? (to - at).norm() : 0.0;
        at = to;
    }
    return length;
}

/// Of M, L and Z.
double lengthOfSvg(const std::string &svg)
{
    static const QRegularExpression path(QStringLiteral(" d=\"([^\"]*)\"")),
        step(QStringLiteral("([MLZ])\\s*(?:(-?[\\d.]+) (-?[\\d.]+))?"));
    double length = 0.0;
    auto paths = path.globalMatch(QString::fromStdString(svg));
    while (paths.hasNext()) {
        Vec2 start = Vec2::Zero(), at = Vec2::Zero();
        auto steps = step.globalMatch(paths.next().captured(1));
        while (steps.hasNext()) {
            const auto one = steps.next();
            const QString letter = one.captured(1);
            const Vec2 to = letter == QStringLiteral("Z")
                                ? start
                                : Vec2(one.captured(2).toDouble(), one.captured(3).toDouble());
            if (letter == QStringLiteral("M"))
                start = to;
            else
                length += (to - at).norm();
            at = to;
        }
    }
    return length;
}

} // namespace

void TestWorkshopFiles::finishedCutsAreTheSameInAllFormats()
{
    for (const CutFinish &finish : {CutFinish{3, 0.5, 0.0, false}, CutFinish{0, 0.3, 3.0, false},
                                    CutFinish{4, 1.0, 2.0, true}}) {
        const CuttingDrawing drawing = twoPlates(finish);
        const double expected = 2.0 * (140.0 - finish.tabs * finish.tabWidth + 2.0 * finish.lead);
        QVERIFY2(std::abs(cutAlong(drawing) - expected) < 1e-6,
                 qPrintable(QString::number(cutAlong(drawing))));
        constexpr double kRounding = 0.01; // mm, of some dozens of numbers with four decimals
        QVERIFY(std::abs(lengthOfGCode(io::writeGCode(drawing)) - expected) < kRounding);
        QVERIFY2(std::abs(lengthOfSvg(io::writeSvg(drawing)) - expected) < kRounding,
                 io::writeSvg(drawing).c_str());
    }
}

void TestWorkshopFiles::plainCutsAreAsTheyWere()
{
    QVERIFY(std::abs(lengthOfSvg(io::writeSvg(twoPlates({}))) - 280.0) < 1e-6);
    // A machine that wants tabs has them, unless something else is asked for.
    Machine machine;
    machine.finish.tabs = 2;
    CuttingDrawing drawing;
    drawing.machine = std::make_shared<const Machine>(machine);
    QCOMPARE(machineOf(drawing).finish.tabs, 2);
}

void TestWorkshopFiles::theArchiveHasACoupon()
{
    const auto packed = io::writeWorkshopArchive(twoPlates({}));
    QVERIFY(packed);
    const auto names = io::entryNames(*packed, "a.zip");
    QVERIFY(names);
    for (const char *name : {"sheets.svg", "parts.csv", "coupon.svg", "coupon.dxf", "coupon.pdf",
                             "coupon.lbrn2", "coupon.gcode"})
        QVERIFY2(std::find(names->begin(), names->end(), name) != names->end(), name);
    QVERIFY(packed == io::writeWorkshopArchive(twoPlates({})));
}

// Foil has no slits to draw: the sheets are there all the same.
void TestWorkshopFiles::noCouponIsNoFault()
{
    const auto packed = io::writeWorkshopArchive(twoPlates({}, 0.01));
    QVERIFY(packed);
    const auto names = io::entryNames(*packed, "a.zip");
    QVERIFY(names && std::none_of(names->begin(), names->end(), [](const std::string &name) {
                return name.starts_with("coupon");
            }));
    QVERIFY(std::find(names->begin(), names->end(), "sheets.svg") != names->end());
}

void TestWorkshopFiles::eachFormatWritesTheCoupon()
{
    std::vector<Stock> stocks{birchPlywood(), flatfabAcrylic()};
    stocks[0].id = StockId{1};
    stocks[1].id = StockId{2};
    const auto coupon = fitCoupon(stocks);
    QVERIFY(coupon);
    QCOMPARE(coupon->sheets.size(), std::size_t(2));
    for (const io::Format *format : io::formatsThat(&io::Format::writesCutting)) {
        const auto bytes = format->writeCutting(*coupon, {});
        QVERIFY2(bytes && bytes->size() > 100, format->key);
    }
}

FFF_TEST(TestWorkshopFiles)
#include "tst_workshop_files.moc"
