#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/halfplane_clip.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Contour rectangle(double x, double y, double width, double height)
{
    return polygonContour(rectangleAt(x, y, width, height));
}

double areaOf(const Contour &contour, const std::vector<Contour> &holes)
{
    double area = std::abs(contour.signedArea());
    for (const Contour &hole : holes)
        area -= std::abs(hole.signedArea());
    return area;
}

double areaOf(const std::vector<ClippedPiece> &pieces)
{
    double area = 0.0;
    for (const ClippedPiece &piece : pieces)
        area += areaOf(piece.outer, piece.holes);
    return area;
}

double lowest(const Contour &contour, const Halfplane &halfplane)
{
    double height = std::numeric_limits<double>::infinity();
    for (int i = 0; i < contour.segmentCount(); ++i)
        for (int k = 0; k <= 100; ++k)
            height = std::min(height, halfplane.height(contour.segment(i).at(k / 100.0)));
    return height;
}

double lowest(const std::vector<ClippedPiece> &pieces, const Halfplane &halfplane)
{
    double height = std::numeric_limits<double>::infinity();
    for (const ClippedPiece &piece : pieces) {
        height = std::min(height, lowest(piece.outer, halfplane));
        for (const Contour &hole : piece.holes)
            height = std::min(height, lowest(hole, halfplane));
    }
    return height;
}

bool isSame(const std::vector<ClippedPiece> &a, const std::vector<ClippedPiece> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const ClippedPiece &p, const ClippedPiece &q) {
                          return p.outer == q.outer && p.holes == q.holes;
                      });
}

Halfplane at(double angle, const Vec2 &point)
{
    return {point, Vec2(-std::sin(angle), std::cos(angle))};
}

const Halfplane kAbove; // y >= 0

} // namespace

class TestHalfplaneClip : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cases_data();
    void cases();
    void whatIsInsideStaysBitForBit();
    void curvesStayCurves();
    void lawsHold_data();
    void lawsHold();
};

void TestHalfplaneClip::cases_data()
{
    QTest::addColumn<Contour>("contour");
    QTest::addColumn<std::vector<Contour>>("holes");
    QTest::addColumn<std::vector<double>>("areas"); // of the pieces with their holes left out
    QTest::addColumn<int>("holesLeft");
    const auto row = [](const char *name, const Contour &contour, const std::vector<Contour> &holes,
                        const std::vector<double> &areas, int holesLeft = 0) {
        QTest::newRow(name) << contour << holes << areas << holesLeft;
    };
    const auto legs = [](double crotch) {
        return polygonContour(
            {{0, -5}, {4, -5}, {4, crotch}, {10, crotch}, {10, -5}, {13, -5}, {13, 20}, {0, 20}});
    };
    row("all above", rectangle(0, 1, 10, 10), {}, {100.0});
    row("all below", rectangle(0, -11, 10, 10), {}, {});
    row("all below with holes", rectangle(0, -11, 10, 10), {rectangle(2, -9, 2, 2)}, {});
    row("stands on the line", rectangle(0, 0, 10, 10), {}, {100.0});
    row("hangs from the line", rectangle(0, -10, 10, 10), {}, {});
    row("half above", rectangle(0, -5, 10, 10), {}, {50.0});
    row("line through two corners", polygonContour({{-5, 0}, {0, -5}, {5, 0}, {0, 5}}), {}, {25.0});
    row("corner touches from above", polygonContour({{0, 0}, {5, 5}, {-5, 5}}), {}, {25.0});
    row("corner touches from below", polygonContour({{0, 0}, {-5, -5}, {5, -5}}), {}, {});
    row("two legs cut below the crotch", legs(3), {}, {13.0 * 20.0 - 6.0 * 3.0});
    row("two legs cut at the crotch", legs(0), {}, {13.0 * 20.0});
    row("body cut above the crotch", legs(-2), {}, {13.0 * 20.0});
    row("only legs are above",
        polygonContour({{0, -5}, {13, -5}, {13, 6}, {10, 6}, {10, -2}, {4, -2}, {4, 6}, {0, 6}}),
        {}, {24.0, 18.0});
    row("tower on a slab whose top is in the line",
        polygonContour({{0, -3}, {10, -3}, {10, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 0}, {0, 0}}), {},
        {10.0});
    row("step whose tread is in the line",
        polygonContour({{0, -3}, {4, -3}, {4, 0}, {10, 0}, {10, 5}, {0, 5}}), {}, {50.0});
    row("hole cut open by the line", rectangle(0, -5, 10, 10), {rectangle(4, -2, 2, 4)}, {46.0});
    row("hole wholly above", rectangle(0, -5, 10, 10), {rectangle(4, 1, 2, 2)}, {46.0}, 1);
    row("hole wholly below", rectangle(0, -5, 10, 10), {rectangle(4, -3, 2, 2)}, {50.0});
    row("hole whose lower edge is in the line", rectangle(0, -5, 10, 10), {rectangle(4, 0, 2, 2)},
        {46.0});
    row("hole whose upper edge is in the line", rectangle(0, -5, 10, 10), {rectangle(4, -2, 2, 2)},
        {50.0});
    row("hole of the other winding", rectangle(0, -5, 10, 10), {rectangle(4, -2, 2, 4).reversed()},
        {46.0});
    row("hole that takes the piece apart", rectangle(0, -5, 10, 10), {rectangle(3, -2, 4, 6)},
        {34.0});
    row("holes go with their piece",
        polygonContour(
            {{0, -5}, {30, -5}, {30, 10}, {12, 10}, {12, -1}, {10, -1}, {10, 10}, {0, 10}}),
        {rectangle(4, 4, 2, 2), rectangle(20, 4, 2, 2), rectangle(24, 4, 2, 2)}, {172.0, 96.0}, 3);
    row("clockwise contour", rectangle(0, -5, 10, 10).reversed(), {}, {50.0});
    row("hole touches the contour's side where the line cuts both", rectangle(0, -5, 10, 10),
        {polygonContour({{0, 0}, {3, -2}, {3, 2}})}, {47.0});
    row("comb whose gaps end at the line", comb(4), {}, {60.0, 60.0, 60.0, 60.0});
}

void TestHalfplaneClip::cases()
{
    QFETCH(Contour, contour);
    QFETCH(std::vector<Contour>, holes);
    QFETCH(std::vector<double>, areas);
    QFETCH(int, holesLeft);
    const auto pieces = *clip(contour, holes, kAbove);
    QCOMPARE(pieces.size(), areas.size());
    int left = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        QVERIFY(std::abs(areaOf(pieces[i].outer, pieces[i].holes) - areas[i]) < 1e-6);
        left += static_cast<int>(pieces[i].holes.size());
    }
    QCOMPARE(left, holesLeft);
    QVERIFY(pieces.empty() || lowest(pieces, kAbove) >= -1e-9);
}

/// A contour that is not cut keeps its control points, its winding and where it starts.
void TestHalfplaneClip::whatIsInsideStaysBitForBit()
{
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        const Contour contour = blob(random, 7, 50.0);
        const std::vector<Contour> holes{circle({0, 0}, 5.0)}; // counter-clockwise
        const Halfplane halfplane = at(0.3 * i, Vec2(-std::sin(0.3 * i), std::cos(0.3 * i)) * -80);
        const auto pieces = *clip(contour, holes, halfplane);
        QCOMPARE(pieces.size(), std::size_t(1));
        QVERIFY(pieces.front().outer == contour && pieces.front().holes == holes);
    }
    // Control points lie beyond the line, the curve touches it.
    const Contour arch =
        *Contour::fromSegments({{{-10, 10}, {-10, -10.0 / 3}, {10, -10.0 / 3}, {10, 10}},
                                CubicBezier::line({10, 10}, {-10, 10})});
    const auto pieces = *clip(arch, {}, kAbove);
    QCOMPARE(pieces.size(), std::size_t(1));
    QVERIFY(pieces.front().outer == arch);
}

/// Chords instead of arcs would make facets at every foot.
void TestHalfplaneClip::curvesStayCurves()
{
    const Contour disc = circle({0, 5}, 20.0);
    const auto pieces = *clip(disc, {}, kAbove);
    QCOMPARE(pieces.size(), std::size_t(1));
    const Contour &outer = pieces.front().outer;
    QCOMPARE(outer.segmentCount(), 5);
    int edges = 0;
    for (int i = 0; i < outer.segmentCount(); ++i) {
        const CubicBezier curve = outer.segment(i);
        if (curve.isStraight(1e-9)) {
            ++edges;
            QVERIFY(std::abs(curve.p0.y()) <= 1e-9 && std::abs(curve.p3.y()) <= 1e-9);
            QVERIFY(curve.p0.x() < curve.p3.x());
        }
    }
    QCOMPARE(edges, 1);
}

void TestHalfplaneClip::lawsHold_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 60; ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

/// Both sides together are the whole; clipping again changes nothing; nothing stays beyond the
/// line; the general boolean says the same.
void TestHalfplaneClip::lawsHold()
{
    QFETCH(unsigned, seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const Contour contour = seed % 3 == 0   ? spiral()
                            : seed % 3 == 1 ? blob(random, 9, 50.0)
                                            : comb(5);
    std::vector<Contour> holes;
    if (seed % 3 == 1)
        holes = {circle({0, 0}, 8.0), circle({18, 0}, 6.0), circle({-16, 5}, 5.0).reversed()};
    Halfplane halfplane = at(3.2 * any(random), Vec2(20.0 * any(random), 20.0 * any(random)));
    if (seed % 4 == 0) // through a control point, at a right angle to an axis
        halfplane = at(std::numbers::pi / 2 * (seed % 16 / 4), contour.points().front());
    const Halfplane other{halfplane.point, -halfplane.inward};

    const auto above = *clip(contour, holes, halfplane), below = *clip(contour, holes, other);
    const double whole = areaOf(contour, holes);
    QVERIFY2(std::abs(areaOf(above) + areaOf(below) - whole) < 1e-3 + 1e-9 * whole,
             qPrintable(QString::number(areaOf(above) + areaOf(below) - whole)));
    if (!above.empty())
        QVERIFY2(lowest(above, halfplane) >= -1e-9,
                 qPrintable(QString::number(lowest(above, halfplane))));
    for (std::size_t i = 0; i < above.size(); ++i) {
        QVERIFY(i == 0 || areaOf(above[i - 1].outer, above[i - 1].holes) >=
                              areaOf(above[i].outer, above[i].holes));
        const auto again = *clip(above[i].outer, above[i].holes, halfplane);
        QVERIFY(isSame(again, {above[i]}));
        const Result<ResolvedContour> resolved = resolveCrossings(above[i].outer);
        QVERIFY(resolved && !resolved->wasCrossing);
    }
    const Vec2 along = 500.0 * halfplane.along(), out = -500.0 * halfplane.inward;
    const Vec2 &p = halfplane.point;
    const auto oracle =
        *subtract(contour, holes, {{p + along, p - along, p - along + out, p + along + out}}, 1e-3);
    QCOMPARE(above.size(), oracle.size());
    for (std::size_t i = 0; i < above.size(); ++i)
        QVERIFY(std::abs(areaOf(above[i].outer, above[i].holes) -
                         areaOf(oracle[i].outer, oracle[i].holes)) < 0.05);
}

FFF_TEST(TestHalfplaneClip)
#include "tst_halfplane_clip.moc"
