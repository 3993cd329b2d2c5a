// The fit coupon: what a person reads off it is written into the stock, so its slits have to be
// what their numbers say.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/fabrication/cutting_order.h"
#include "core/fabrication/fit_coupon.h"
#include "core/fabrication/machine.h"
#include "core/model/stock.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace fff;

class TestFitCoupon : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void numbersAndClearances();
    void slitsAreAsWideAsTheirNumbersSay();
    void slatsMeasureTheKerf();
    void partsAreApartAndOnTheSheet();
    void aShortSheetHasFewerSlitsOfTheSameNumbers();
    void whatCannotBe();
    void saysWhatItIs();
    void sameBytesForSameStock();
};

namespace {

constexpr double kSame = 1e-6; // mm: what outlines are rounded to

/// Widths of what opens at the lower edge of an outline, from the left, mm.
std::vector<double> gapsAtTheEdge(const CurvedRegion &outline)
{
    const Polygon &ring = outline.region.outer;
    const double low = bounds(ring).min.y();
    std::vector<double> ends;
    for (const Vec2 &p : ring)
        if (std::abs(p.y() - low) < kSame)
            ends.push_back(p.x());
    std::sort(ends.begin(), ends.end());
    std::vector<double> gaps;
    for (std::size_t i = 2; i < ends.size(); i += 2)
        gaps.push_back(ends[i] - ends[i - 1]);
    return gaps;
}

Stock stockOf(double thickness, double kerf)
{
    Stock stock = birchPlywood();
    stock.thickness = thickness;
    stock.kerf = kerf;
    return stock;
}

/// From card to thick board, on sheets from A4 on, pressed and loose.
std::vector<Stock> kinds()
{
    std::vector<Stock> all;
    for (const double thickness : {0.3, 1.5, 3.0, 3.8, 6.4, 10.0})
        for (const Vec2 &sheet : {Vec2(297.0, 210.0), Vec2(300.0, 200.0), Vec2(600.0, 400.0)})
            for (const double kerf : {0.0, 0.15, 0.25}) {
                Stock stock = stockOf(thickness, kerf);
                stock.sheet = sheet;
                all.push_back(stock);
            }
    return all;
}

CuttingDrawing couponOf(const Stock &stock)
{
    return fitCoupon(std::vector{stock}).value();
}

Box2 boxOf(const CuttingPart &part)
{
    Box2 box;
    part.forLines([&box](const CuttingLine &line) {
        for (int i = 0; i < line.segmentCount(); ++i)
            box.extend(line.end(i));
    });
    return box;
}

} // namespace

void TestFitCoupon::numbersAndClearances()
{
    QCOMPARE(clearanceOfSlit(7), 0.0);
    QVERIFY(std::abs(clearanceOfSlit(1) + 0.3) < kSame);
    QVERIFY(std::abs(clearanceOfSlit(kCouponSlits) - 0.3) < kSame);
    for (int number = 1; number <= kCouponSlits; ++number) {
        QCOMPARE(slitOfClearance(clearanceOfSlit(number)), number);
        QCOMPARE(slitOfClearance(clearanceOfSlit(number) + 0.4 * kCouponStep), number);
    }
    QCOMPARE(slitOfClearance(-100.0), 1);
    QCOMPARE(slitOfClearance(1e9), kCouponSlits);
    QVERIFY(std::abs(kerfOfSlats(98.5) - 0.15) < kSame);
    QCOMPARE(kerfOfSlats(100.0), 0.0);
}

void TestFitCoupon::slitsAreAsWideAsTheirNumbersSay()
{
    std::mt19937 random(28);
    std::uniform_real_distribution<double> thickness(0.6, 9.0), kerf(0.0, 0.29);
    for (int i = 0; i < 30; ++i) {
        const Stock stock = stockOf(thickness(random), kerf(random));
        const CuttingDrawing drawing = couponOf(stock);
        const auto gaps = gapsAtTheEdge(drawing.sheets.at(0).parts.at(0).outline());
        QCOMPARE(gaps.size(), std::size_t(kCouponSlits));
        for (int number = 1; number <= kCouponSlits; ++number) {
            const double drawn = gaps[static_cast<std::size_t>(number - 1)];
            const double cut = drawn + stock.kerf;
            QVERIFY2(std::abs(cut - stock.thickness - clearanceOfSlit(number)) < 1e-5,
                     qPrintable(QString::number(number)));
        }
    }
}

// A disc of the kerf's diameter that runs along a slat's path leaves a piece narrower by one kerf.
void TestFitCoupon::slatsMeasureTheKerf()
{
    for (const double set : {0.0, 0.1, 0.25}) {
        const CuttingDrawing drawing = couponOf(stockOf(3.0, set));
        const auto &parts = drawing.sheets.at(0).parts;
        QCOMPARE(parts.size(), std::size_t(2 + kCouponSlats));
        double sum = 0.0;
        constexpr double kTrue = 0.18;
        for (std::size_t i = 2; i < parts.size(); ++i)
            sum += boxOf(parts[i]).size().x() - kTrue;
        QVERIFY(std::abs(kerfOfSlats(sum) - kTrue) < kSame);
    }
}

void TestFitCoupon::partsAreApartAndOnTheSheet()
{
    for (const Stock &stock : kinds()) {
        const CuttingDrawing drawing = couponOf(stock);
        const CuttingSheet &sheet = drawing.sheets.at(0);
        for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
            const Box2 box = boxOf(sheet.parts[i]);
            QVERIFY(box.min.minCoeff() > 4.9 && (sheet.size - box.max).minCoeff() > 4.9);
            for (std::size_t k = 0; k < i; ++k) {
                Box2 near = boxOf(sheet.parts[k]);
                near.min -= Vec2::Constant(2.0);
                near.max += Vec2::Constant(2.0);
                QVERIFY(!box.intersects(near));
            }
        }
        QVERIFY(sheet.size.maxCoeff() <= stock.sheet.maxCoeff() + kSame);
    }
}

void TestFitCoupon::aShortSheetHasFewerSlitsOfTheSameNumbers()
{
    Stock stock = stockOf(3.0, 0.1);
    stock.sheet = {100.0, 150.0};
    const CuttingDrawing drawing = couponOf(stock);
    const auto gaps = gapsAtTheEdge(drawing.sheets.at(0).parts.at(0).outline());
    QVERIFY(gaps.size() >= 3 && gaps.size() < kCouponSlits);
    QVERIFY(drawing.sheets.at(0).size.x() <= 150.0 && drawing.sheets.at(0).size.y() <= 100.0);
    // Steps as ever, and the stock's own thickness among them.
    QVERIFY(std::any_of(gaps.begin(), gaps.end(),
                        [](double drawn) { return std::abs(drawn + 0.1 - 3.0) < 1e-5; }));
}

void TestFitCoupon::whatCannotBe()
{
    const auto closed = fitCoupon(std::vector{stockOf(0.1, 0.2)});
    QVERIFY(!closed && closed.error().code == ErrorCode::ClosedSlit);
    Stock tiny = stockOf(3.0, 0.1);
    tiny.sheet = {30.0, 30.0};
    const auto small = fitCoupon(std::vector{tiny});
    QVERIFY(!small && small.error().code == ErrorCode::BadValue && small.error().place == "sheet");
    // Foil: slits that the kerf closes are not there, the others are.
    const CuttingDrawing foil = couponOf(stockOf(0.3, 0.15));
    const auto gaps = gapsAtTheEdge(foil.sheets.at(0).parts.at(0).outline());
    QVERIFY(gaps.size() < kCouponSlits && gaps.front() > 0.0);
    QVERIFY(fitCoupon({}).value().sheets.empty());
}

void TestFitCoupon::saysWhatItIs()
{
    const auto engraved = [](const Stock &stock) {
        double length = 0.0;
        const CuttingDrawing drawing = couponOf(stock);
        for (const ToolLine &line : toolLines(drawing.sheets.at(0)))
            if (line.purpose == Purpose::Engrave)
                length += lengthOf(line);
        return length;
    };
    Stock stock = stockOf(3.0, 0.1);
    QVERIFY(engraved(stock) > 50.0);
    // Letters that nobody has drawn are left out, not all of it.
    stock.name = "\xE7\xB4\x99 ply";
    QVERIFY(engraved(stock) > 50.0);
    // However long a name is, it stays on the piece.
    stock.name = std::string(300, 'W');
    const CuttingDrawing drawing = couponOf(stock);
    const CuttingSheet &sheet = drawing.sheets.at(0);
    const Box2 piece = boxOf(sheet.parts.at(0));
    for (const ToolLine &line : toolLines(sheet))
        if (line.purpose == Purpose::Engrave || line.purpose == Purpose::Number)
            for (const CubicBezier &curve : line.curves)
                QVERIFY(piece.contains(curve.p0) && piece.contains(curve.p3));
}

void TestFitCoupon::sameBytesForSameStock()
{
    const Stock stock = stockOf(3.0, 0.1);
    const CuttingDrawing one = couponOf(stock), two = couponOf(stock);
    const auto lines = toolLines(one.sheets.at(0)), others = toolLines(two.sheets.at(0));
    QCOMPARE(lines.size(), others.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
        QVERIFY(lines[i].start() == others[i].start());
}

FFF_TEST(TestFitCoupon)
#include "tst_fit_coupon.moc"
