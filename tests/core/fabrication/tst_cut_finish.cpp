// Tabs, leads and shared cuts. If this fails, parts fall out early or a lead cuts into a part.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/fabrication/cutting_order.h"
#include "core/fabrication/machine.h"
#include "core/geometry/polygon.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

class TestCutFinish : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plainIsAsItWas();
    void tabsLeaveOutTheirWidths();
    void tabsKeepOffCornersSlitsAndNeighbours();
    void leadsStayInTheWaste();
    void leadsGoWhereThereIsRoom();
    void noSegmentTwice();
    void allOfItIsCutStill();
    void everythingAtOnce();
};

namespace {

constexpr double kLengthOff = 1e-3; // mm, per line: stations of curves are of chords

CuttingSheet finishedSheet(std::vector<Part> parts, const std::vector<Vec2> &places,
                           const CutFinish &finish)
{
    const auto source =
        std::make_shared<const CuttingPart::Source>(CuttingPart::Source{std::move(parts), {}});
    CuttingSheet sheet;
    sheet.size = {600, 400};
    sheet.finish = finish;
    for (std::size_t i = 0; i < places.size(); ++i) {
        Placement placement;
        placement.part = static_cast<int>(i);
        placement.offset = places[i];
        sheet.parts.emplace_back(source, placement, "part");
    }
    return sheet;
}

Part cutPart(const CurvedRegion &outline, int number)
{
    Part part;
    part.number = number;
    part.outline = outline;
    return part;
}

double cutOf(const CuttingSheet &sheet)
{
    return wayAlong(inCuttingOrder(sheet), usualMachine()).cut;
}

double cutAsDrawn(const CuttingSheet &sheet)
{
    CuttingSheet plain = sheet;
    plain.finish = {};
    return cutOf(plain);
}

/// Blobs with a hole each, in rows, too far apart to touch.
CuttingSheet someBlobs(std::uint32_t seed, const CutFinish &finish)
{
    std::mt19937 random(seed);
    std::vector<Part> parts;
    std::vector<Vec2> places;
    for (int i = 0; i < 12; ++i) {
        parts.push_back(
            cutPart(regionOf(blob(random, 7 + i % 4, 35.0), {circle({0, 0}, 9.0)}), i + 1));
        places.emplace_back(45.0 + 75.0 * (i % 4), 45.0 + 75.0 * (i / 4));
    }
    return finishedSheet(std::move(parts), places, finish);
}

/// Points along a line, about 0.1 mm apart.
std::vector<Vec2> pointsAlong(const std::vector<CubicBezier> &curves)
{
    std::vector<Vec2> points;
    for (const CubicBezier &curve : curves) {
        const int count = std::max(1, static_cast<int>((curve.p3 - curve.p0).norm() / 0.1));
        for (int i = 0; i <= count; ++i)
            points.push_back(curve.at(static_cast<double>(i) / count));
    }
    return points;
}

/// Outlines where they lie.
std::vector<Region> regionsOn(const CuttingSheet &sheet)
{
    std::vector<Region> regions;
    for (const CuttingPart &part : sheet.parts) {
        Region &region = regions.emplace_back();
        part.forLines([&](const CuttingLine &line) {
            Polygon ring;
            for (int i = 0; i < line.segmentCount(); ++i)
                for (int k = 0; k < 64; ++k)
                    ring.push_back(line.segment(i).at(k / 64.0));
            if (line.role() == LineRole::OuterCut)
                region.outer = ring;
            else
                region.holes.push_back(ring);
        });
    }
    return regions;
}

QString firstPointInAPart(const CuttingSheet &sheet)
{
    constexpr double kChordOff = 0.01; // mm: the rings above are chords
    const std::vector<Region> regions = regionsOn(sheet);
    for (const ToolLine &line : inCuttingOrder(sheet))
        for (const Vec2 &p : pointsAlong({line.curves.front(), line.curves.back()})) {
            if (p.minCoeff() < 0.0 || (sheet.size - p).minCoeff() < 0.0)
                return QStringLiteral("off the sheet at %1, %2").arg(p.x()).arg(p.y());
            for (const Region &region : regions) {
                if (!bounds(region.outer).contains(p) || locate(p, region) != Side::Inside)
                    continue;
                double nearest = 1e9;
                std::vector<Polygon> rings = region.holes;
                rings.push_back(region.outer);
                for (const Polygon &ring : rings)
                    for (std::size_t i = 0; i < ring.size(); ++i) {
                        const Vec2 a = ring[i], way = ring[(i + 1) % ring.size()] - a;
                        const double t = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
                        nearest = std::min(nearest, (p - a - t * way).norm());
                    }
                if (nearest > kChordOff)
                    return QStringLiteral("%1 mm within a part at %2, %3")
                        .arg(nearest)
                        .arg(p.x())
                        .arg(p.y());
            }
        }
    return {};
}

std::vector<std::pair<Vec2, Vec2>> straightCuts(const std::vector<ToolLine> &lines)
{
    std::vector<std::pair<Vec2, Vec2>> cuts;
    for (const ToolLine &line : lines)
        for (const CubicBezier &curve : line.curves)
            cuts.emplace_back(curve.p0, curve.p3);
    return cuts;
}

/// How long two edges lie on each other, mm.
double sharedLength(const std::pair<Vec2, Vec2> &a, const std::pair<Vec2, Vec2> &b)
{
    const Vec2 way = a.second - a.first, u = way.normalized();
    if (std::abs(cross(u, b.first - a.first)) > 2e-3 ||
        std::abs(cross(u, b.second - a.first)) > 2e-3)
        return 0.0;
    const auto [from, to] = std::minmax({u.dot(b.first - a.first), u.dot(b.second - a.first)});
    return std::min(to, way.norm()) - std::max(from, 0.0);
}

} // namespace

void TestCutFinish::plainIsAsItWas()
{
    for (const ToolLine &line : inCuttingOrder(someBlobs(1, {})))
        QVERIFY(line.isClosed);
}

void TestCutFinish::tabsLeaveOutTheirWidths()
{
    for (std::uint32_t seed = 1; seed <= 5; ++seed)
        for (const int tabs : {1, 2, 4, 7})
            for (const double width : {0.2, 1.0, 3.0}) {
                CutFinish finish;
                finish.tabs = tabs;
                finish.tabWidth = width;
                const CuttingSheet sheet = someBlobs(seed, finish);
                const double left = cutAsDrawn(sheet) - cutOf(sheet);
                const double all = tabs * width * static_cast<double>(sheet.parts.size());
                QVERIFY2(std::abs(left - all) < 12.0 * tabs * kLengthOff,
                         qPrintable(QStringLiteral("%1 for %2").arg(left).arg(all)));
                int open = 0;
                for (const ToolLine &line : inCuttingOrder(sheet)) {
                    open += line.isClosed ? 0 : 1;
                    QVERIFY(line.isClosed == (line.purpose == Purpose::InnerCut));
                }
                QCOMPARE(open, 12 * tabs);
            }
}

void TestCutFinish::tabsKeepOffCornersSlitsAndNeighbours()
{
    CutFinish finish;
    finish.tabs = 6;
    finish.tabWidth = 0.5;
    Part part = cutPart(regionOf(*Contour::fromPolygon(rectangleAt(0, 0, 60, 40)), {},
                                 {rectangleAt(28, -1, 4, 21)}),
                        1);
    part.joints.push_back({1, {30, 20}, {0, 1}, 4.0});
    const Part other = cutPart(regionOf(*Contour::fromPolygon(rectangleAt(0, 0, 60, 40))), 2);
    // The other one lies against the right edge.
    const CuttingSheet sheet = finishedSheet({part, other}, {{100, 100}, {160, 100}}, finish);
    const std::vector<Vec2> corners{{100, 100}, {160, 100}, {160, 140}, {100, 140}};
    std::size_t pieces = 0;
    for (const ToolLine &line : inCuttingOrder(sheet)) {
        pieces += line.part == 0 ? 1 : 0;
        for (const Vec2 &end : {line.start(), line.end()}) {
            for (const Vec2 &corner : corners)
                QVERIFY((end - corner).norm() > 0.99);
            if (line.part == 0)
                QVERIFY(std::abs(end.x() - 130.0) > 2.9 || end.y() > 120.9);
            QVERIFY(std::abs(end.x() - 160.0) > 0.1); // where both are cut
        }
    }
    QCOMPARE(pieces, std::size_t(6));
}

void TestCutFinish::leadsStayInTheWaste()
{
    for (std::uint32_t seed = 1; seed <= 6; ++seed)
        for (const double lead : {0.5, 2.0, 5.0}) {
            CutFinish finish;
            finish.lead = lead;
            const CuttingSheet sheet = someBlobs(seed, finish);
            const double more = cutOf(sheet) - cutAsDrawn(sheet);
            QVERIFY2(std::abs(more - 2.0 * lead * 24.0) < 24.0 * kLengthOff,
                     qPrintable(QString::number(more)));
            const QString fault = firstPointInAPart(sheet);
            QVERIFY2(fault.isEmpty(), qPrintable(fault));
        }
}

// Between two walls that are nearer than the lead is long there is none; at a sheet's edge neither.
void TestCutFinish::leadsGoWhereThereIsRoom()
{
    CutFinish finish;
    finish.lead = 5.0;
    const Part square = cutPart(regionOf(*Contour::fromPolygon(rectangleAt(0, 0, 20, 20))), 1);
    std::vector<Part> parts;
    std::vector<Vec2> places;
    for (int i = 0; i < 9; ++i) {
        parts.push_back(square);
        places.emplace_back(1.0 + 21.0 * (i % 3), 1.0 + 21.0 * (i / 3));
    }
    CuttingSheet sheet = finishedSheet(parts, places, finish);
    sheet.size = {64, 64};
    QCOMPARE(cutOf(sheet), cutAsDrawn(sheet));
    sheet.size = {600, 400};
    QVERIFY(cutOf(sheet) > cutAsDrawn(sheet)); // those at the right and above
    const QString fault = firstPointInAPart(sheet);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestCutFinish::noSegmentTwice()
{
    CutFinish finish;
    finish.sharesCuts = true;
    std::vector<Part> parts;
    std::vector<Vec2> places;
    std::mt19937 random(5);
    double x = 10.0;
    for (int i = 0; i < 10; ++i) { // a row of boxes of any height, each against the one before
        const double width = 10.0 + random() % 20, height = 15.0 + random() % 40;
        parts.push_back(
            cutPart(regionOf(*Contour::fromPolygon(rectangleAt(0, 0, width, height))), i + 1));
        places.emplace_back(x, 10.0 + random() % 10);
        x += width;
    }
    const auto cuts = straightCuts(inCuttingOrder(finishedSheet(parts, places, finish)));
    for (std::size_t i = 0; i < cuts.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            QVERIFY2(sharedLength(cuts[i], cuts[k]) < 0.11,
                     qPrintable(QString::number(sharedLength(cuts[i], cuts[k]))));
    // Without the wish they are as they are drawn.
    QVERIFY(inCuttingOrder(finishedSheet(parts, places, {})).size() == 10);
}

// What is left out of one is cut with the other: all points of all outlines are on some cut.
void TestCutFinish::allOfItIsCutStill()
{
    CutFinish finish;
    finish.sharesCuts = true;
    const Part square = cutPart(regionOf(*Contour::fromPolygon(rectangleAt(0, 0, 20, 20))), 1);
    std::vector<Part> parts(9, square);
    std::vector<Vec2> places;
    for (int i = 0; i < 9; ++i)
        places.emplace_back(10.0 + 20.0 * (i % 3), 10.0 + 20.0 * (i / 3));
    const CuttingSheet sheet = finishedSheet(parts, places, finish);
    // Four lines of 60 mm each way, in place of nine squares.
    QVERIFY(std::abs(cutOf(sheet) - 8.0 * 60.0) < 1e-6);
    QVERIFY(std::abs(cutAsDrawn(sheet) - 9.0 * 80.0) < 1e-6);
}

void TestCutFinish::everythingAtOnce()
{
    const CutFinish finish{3, 0.4, 2.0, true};
    for (std::uint32_t seed = 30; seed < 40; ++seed) {
        const CuttingSheet sheet = someBlobs(seed, finish);
        const double expected =
            cutAsDrawn(sheet) - 12.0 * 3 * finish.tabWidth + 24.0 * 2.0 * finish.lead;
        QVERIFY(std::abs(cutOf(sheet) - expected) < 24.0 * 3 * kLengthOff);
        const QString fault = firstPointInAPart(sheet);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
        // Same sheet, same lines.
        const auto lines = inCuttingOrder(sheet), again = inCuttingOrder(sheet);
        QCOMPARE(lines.size(), again.size());
        for (std::size_t i = 0; i < lines.size(); ++i)
            QVERIFY(lines[i].start() == again[i].start() && lines[i].end() == again[i].end());
    }
}

FFF_TEST(TestCutFinish)
#include "tst_cut_finish.moc"
