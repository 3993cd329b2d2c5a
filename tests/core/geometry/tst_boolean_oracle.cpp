// subtract against CGAL's exact booleans. Alone in its file: CGAL's are slow to compile.
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPolygon = CGAL::Polygon_2<Kernel>;
using ExactSet = CGAL::Polygon_set_2<Kernel>;

ExactPolygon exact(const Polygon &polygon)
{
    ExactPolygon result;
    for (const Vec2 &p : polygon)
        result.push_back({p.x(), p.y()});
    if (result.is_clockwise_oriented())
        result.reverse_orientation();
    return result;
}

struct ExactAnswer
{
    double area = 0.0;
    std::size_t pieces = 0, holes = 0;
};

ExactAnswer exactDifference(const Polygon &outer, const std::vector<Polygon> &taken)
{
    ExactSet set(exact(outer));
    for (const Polygon &polygon : taken)
        set.difference(exact(polygon));
    ExactAnswer answer;
    std::vector<CGAL::Polygon_with_holes_2<Kernel>> pieces;
    set.polygons_with_holes(std::back_inserter(pieces));
    answer.pieces = pieces.size();
    for (const auto &piece : pieces) {
        answer.area += CGAL::to_double(piece.outer_boundary().area());
        for (const auto &hole : piece.holes()) {
            answer.area += CGAL::to_double(hole.area());
            ++answer.holes;
        }
    }
    return answer;
}

struct Cuts
{
    std::vector<Polygon> polygons;
    Cuts &add(const Polygon &polygon)
    {
        polygons.push_back(polygon);
        return *this;
    }
};

} // namespace

class TestBooleanOracle : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithExactBooleans_data();
    void agreesWithExactBooleans();
    void agreesOnRandomCuts_data();
    void agreesOnRandomCuts();
};

namespace {

void compare(const Contour &contour, const std::vector<Contour> &holes, const Cuts &cuts,
             bool countPieces)
{
    std::vector<Polygon> taken = cuts.polygons;
    for (const Contour &hole : holes)
        taken.push_back(hole.flatten(kCutChord).points);
    const ExactAnswer expected = exactDifference(contour.flatten(kCutChord).points, taken);
    const auto actual = *subtract(contour, holes, cuts.polygons, kCutChord);
    double sum = 0.0;
    std::size_t holeCount = 0;
    for (const CurvedRegion &r : actual) {
        sum += area(r.region);
        holeCount += r.holes.size();
        QCOMPARE(r.holes.size(), r.region.holes.size());
    }
    QVERIFY2(std::abs(sum - expected.area) <= 1e-6 * std::max(1.0, expected.area),
             qPrintable(QStringLiteral("%1 instead of %2")
                            .arg(sum, 0, 'g', 15)
                            .arg(expected.area, 0, 'g', 15)));
    if (countPieces) {
        QCOMPARE(actual.size(), expected.pieces);
        QCOMPARE(holeCount, expected.holes);
    }
}

} // namespace

void TestBooleanOracle::agreesWithExactBooleans_data()
{
    QTest::addColumn<std::vector<Contour>>("contours"); // the first one less the others
    QTest::addColumn<Cuts>("cuts");
    const Contour square = polygonContour(rectangleAt(0, 0, 40, 40));
    const auto row = [](const char *name, const std::vector<Contour> &contours, const Cuts &cuts) {
        QTest::newRow(name) << contours << cuts;
    };
    row("an annulus", {circle({0, 0}, 30), circle({1, 2}, 20)}, Cuts());
    row("an annulus with four slits", {circle({0, 0}, 30), circle({0, 0}, 20)},
        Cuts()
            .add(rectangleAt(-1.5, 25, 3, 10))
            .add(rectangleAt(-1.5, -35, 3, 10))
            .add(rectangleAt(25, -1.5, 10, 3))
            .add(rectangleAt(-35, -1.5, 10, 3)));
    row("an annulus cut in two", {circle({0, 0}, 30), circle({0, 0}, 20)},
        Cuts().add(rectangleAt(-40, -1, 80, 2)));
    row("a comb with its teeth cut off", {comb(20)}, Cuts().add(rectangleAt(-5, 12, 100, 3)));
    row("a spiral cut across", {spiral()}, Cuts().add(rectangleAt(-40, -1, 80, 2)));
    row("a square with overlapping holes",
        {square, circle({15, 20}, 8), circle({25, 20}, 8).reversed()}, Cuts());
    row("a hole that sticks out", {square, circle({40, 40}, 8)}, Cuts());
    row("a crossing of two mortises", {square},
        Cuts().add(rectangleAt(10, 18, 20, 3)).add(rectangleAt(18, 10, 3, 20)));
    row("a mortise inside a slit", {square},
        Cuts().add(rectangleAt(10, 10, 5, 40)).add(rectangleAt(11, 20, 2, 5)));
    row("a cut of a micron", {square}, Cuts().add(rectangleAt(20, -1, 0.001, 42)));
}

// Wrong: Clipper or the way it is used would lose or add material.
void TestBooleanOracle::agreesWithExactBooleans()
{
    QFETCH(std::vector<Contour>, contours);
    QFETCH(Cuts, cuts);
    compare(contours.front(), {contours.begin() + 1, contours.end()}, cuts, true);
}

void TestBooleanOracle::agreesOnRandomCuts_data()
{
    QTest::addColumn<int>("shape");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        // CGAL's sets want strictly simple polygons.
        const QByteArray name(shapes[i].name);
        if (!name.contains("touch") && !name.contains("twice"))
            QTest::newRow(shapes[i].name) << static_cast<int>(i);
    }
}

// Wrong: as above, in constellations nobody thought of.
void TestBooleanOracle::agreesOnRandomCuts()
{
    QFETCH(int, shape);
    const unsigned seed = 2718U + static_cast<unsigned>(shape);
    qInfo() << "seed" << seed;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-40, 40), size(0.5, 50), turn(0, 3.2);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    const Vec2 middle = contour.bounds().center();
    for (int round = 0; round < 4; ++round) {
        Cuts cuts;
        for (int i = 0; i < 6; ++i)
            cuts.add(turnedRectangle(middle + Vec2(place(random), place(random)), 3.0, size(random),
                                     turn(random)));
        compare(contour, {}, cuts, false);
    }
}

FFF_TEST(TestBooleanOracle)
#include "tst_boolean_oracle.moc"
