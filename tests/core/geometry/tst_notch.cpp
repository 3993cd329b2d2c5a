#include "core/base/tolerances.h"
#include "core/geometry/notch.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

double areaOf(const std::vector<CurvedRegion> &parts)
{
    double sum = 0.0;
    for (const CurvedRegion &part : parts) {
        sum += part.outer.signedArea();
        for (const Contour &hole : part.holes)
            sum += hole.signedArea();
    }
    return sum;
}

/// A slit's rectangle from the middle of its bottom to that of its mouth.
Polygon slit(const Vec2 &inner, const Vec2 &mouth, double width)
{
    const Vec2 half = 0.5 * width * perpendicular((mouth - inner).normalized());
    return {inner - half, mouth - half, mouth + half, inner + half};
}

/// The same control points, to rounding.
bool isSameCurve(const Contour &a, const Contour &b)
{
    return a.points().size() == b.points().size() &&
           std::equal(a.points().begin(), a.points().end(), b.points().begin(),
                      [](const Vec2 &p, const Vec2 &q) { return (p - q).norm() <= kClipSlack; });
}

} // namespace

class TestNotch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sameAsTheBoolean_data();
    void sameAsTheBoolean();
    void combOfSlits();
    void startInsideASlit();
    void holesGoAlong();
    void whatIsNotPlainIsLeft_data();
    void whatIsNotPlainIsLeft();
};

void TestNotch::sameAsTheBoolean_data()
{
    QTest::addColumn<int>("shape");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        QTest::newRow(shapes[i].name) << static_cast<int>(i);
}

// Wrong: a part would be cut differently by the quick way than by the one that always works.
void TestNotch::sameAsTheBoolean()
{
    QFETCH(int, shape);
    Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    if (contour.signedArea() < 0.0)
        contour = contour.reversed();
    if (!isPlain(contour, {}, kCutChord))
        return; // the caller's duty
    std::mt19937 random(20140506);
    const Box2 box = contour.bounds();
    std::uniform_real_distribution<double> share(-0.1, 1.1), width(0.2, 5.0);
    int taken = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<Polygon> cuts;
        for (int i = 0; i < 1 + round % 3; ++i) {
            const auto point = [&] {
                return Vec2(box.min + Vec2(share(random), share(random)).cwiseProduct(box.size()));
            };
            cuts.push_back(slit(point(), point(), width(random)));
        }
        const auto quick = cutNotches(contour, {}, cuts, kCutChord);
        if (!quick)
            continue;
        ++taken;
        const std::vector<CurvedRegion> parts = *subtract(contour, {}, cuts, kCutChord);
        QCOMPARE(parts.size(), std::size_t(1));
        QVERIFY(std::abs(areaOf(parts) - areaOf({*quick})) <= 1e-6 * contour.signedArea());
        // The boolean drops what is shorter than its grid.
        const QByteArray name = QTest::currentDataTag();
        if (!name.contains("below the grid") && !name.contains("handle on its tip"))
            QVERIFY(isSameCurve(parts.front().outer, quick->outer));
        // The boolean's chords are on its grid: walls as long as the needle are moved by that.
        QVERIFY(std::abs(area(parts.front().region) - area(quick->region)) <=
                1e-6 * contour.signedArea() + kClipSlack * box.size().sum());
    }
    const QByteArray name = QTest::currentDataTag();
    QVERIFY(taken > 0 || name.contains("needle") || name.contains("tiny"));
}

// Wrong: sections of egg crates would take the slow way, or lose slits.
void TestNotch::combOfSlits()
{
    const Contour strip = polygonContour(rectangleAt(0, 0, 1000, 40));
    std::vector<Polygon> cuts;
    for (int i = 1; i < 100; ++i)
        cuts.push_back(i % 2 ? slit({10.0 * i, 20}, {10.0 * i, 40.05}, 3)
                             : slit({10.0 * i, 20}, {10.0 * i, -0.05}, 3));
    const auto quick = cutNotches(strip, {}, cuts, kCutChord);
    QVERIFY(quick);
    QCOMPARE(quick->outer.segmentCount(), 4 + 4 * 99);
    QVERIFY(std::abs(quick->outer.signedArea() - (40000.0 - 99 * 60.0)) < 1e-6);
    QVERIFY(isSameCurve(subtract(strip, {}, cuts, kCutChord)->front().outer, quick->outer));
}

// Wrong: a slit over the point where the contour starts would leave it out or double it.
void TestNotch::startInsideASlit()
{
    const Contour disc = circle({0, 0}, 30);
    const std::vector<Polygon> cuts{slit({10, 0.3}, {31, 0.3}, 3), slit({0, 10}, {0, 31}, 3)};
    const auto quick = cutNotches(disc, {}, cuts, kCutChord);
    QVERIFY(quick);
    const auto parts = *subtract(disc, {}, cuts, kCutChord);
    QVERIFY(std::abs(areaOf(parts) - quick->outer.signedArea()) < 1e-6);
    QCOMPARE(quick->outer.segmentCount(), parts.front().outer.segmentCount());
}

void TestNotch::holesGoAlong()
{
    const Contour plate = polygonContour(rectangleAt(0, 0, 100, 60));
    const Contour hole = circle({70, 30}, 10).reversed();
    const auto quick = cutNotches(plate, {hole}, {slit({20, 30}, {20, 61}, 4)}, kCutChord);
    QVERIFY(quick);
    QCOMPARE(quick->holes.size(), std::size_t(1));
    QVERIFY(quick->holes.front() == hole);
    QCOMPARE(quick->region.holes.size(), std::size_t(1));
    QVERIFY(!cutNotches(plate, {hole}, {slit({70, 30}, {70, 61}, 4)}, kCutChord));
}

void TestNotch::whatIsNotPlainIsLeft_data()
{
    QTest::addColumn<std::vector<Polygon>>("cuts");
    QTest::newRow("inside") << std::vector<Polygon>{slit({40, 30}, {60, 30}, 4)};
    QTest::newRow("outside") << std::vector<Polygon>{slit({140, 30}, {160, 30}, 4)};
    QTest::newRow("right through") << std::vector<Polygon>{slit({50, -1}, {50, 61}, 4)};
    QTest::newRow("with a wall along an edge") << std::vector<Polygon>{slit({20, 58}, {40, 58}, 4)};
    QTest::newRow("with its bottom on the edge")
        << std::vector<Polygon>{slit({20, 60}, {20, 80}, 4)};
    QTest::newRow("with a wall through a corner")
        << std::vector<Polygon>{slit({99, 30}, {99, 61}, 2)};
    QTest::newRow("two across each other")
        << std::vector<Polygon>{slit({50, 20}, {50, 61}, 4), slit({30, 30}, {101, 30}, 4)};
    QTest::newRow("two side by side")
        << std::vector<Polygon>{slit({50, 20}, {50, 61}, 4), slit({54, 20}, {54, 61}, 4)};
    QTest::newRow("of no area") << std::vector<Polygon>{Polygon{{50, 20}, {50, 61}, {50, 20}}};
}

// Wrong: the quick way would make something up for what it cannot tell.
void TestNotch::whatIsNotPlainIsLeft()
{
    QFETCH(std::vector<Polygon>, cuts);
    const Contour plate = polygonContour(rectangleAt(0, 0, 100, 60));
    QVERIFY(!cutNotches(plate, {}, cuts, kCutChord));
}

FFF_TEST(TestNotch)
#include "tst_notch.moc"
