#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/polygon.h"
#include "core/stroke/slit_neck.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr SlitToReach kSlit{14.0, 3.0, 40.0};

/// A blob, round but for its waves.
Contour blob(const Vec2 &middle, double radius, double wave, double phase)
{
    Polygon polygon;
    for (int i = 0; i < 90; ++i) {
        const double angle = 2.0 * kPi * i / 90;
        const double r = radius * (1.0 + wave * std::sin(3.0 * angle + phase));
        polygon.push_back(middle + r * Vec2(std::cos(angle), std::sin(angle)));
    }
    return Contour::ofPolygon(polygon);
}

bool isIn(const Vec2 &p, const Contour &contour)
{
    return locate(p, contour.polygon(kDrawChord)) == Side::Inside;
}

/// Whether material stands beside the slit, and where the slit of the neck itself will be, as far
/// as the size of what was drawn allows.
bool isAlongSlit(const Contour &contour, const SlitToReach &slit, const Contour &drawn)
{
    const double side = 0.5 * slit.thickness + 0.9 * slit.thickness;
    const double depth = std::min(2.0 * slit.length, drawn.bounds().size().maxCoeff());
    for (double x = slit.length - depth + 0.01; x < slit.length; x += 0.5)
        for (const double y : {-side, 0.0, side})
            if (!isIn({x, y}, contour))
                return false;
    return true;
}

} // namespace

class TestSlitNeck : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itReachesPastTheSlit_data();
    void itReachesPastTheSlit();
    void whatNeedsNone_data();
    void whatNeedsNone();
    void whatIsSymmetricStaysSo();
    void noFartherThanTheBody();
    void blobsAllRound();
};

void TestSlitNeck::itReachesPastTheSlit_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("radius");
    QTest::newRow("below it") << 40.0 << 0.0 << 20.0;
    QTest::newRow("touching its end") << 34.0 << 0.0 << 20.0;
    QTest::newRow("over its last bit") << 33.0 << 0.0 << 20.0;
    QTest::newRow("a little aside") << 45.0 << 15.0 << 20.0;
    QTest::newRow("beside it") << 30.0 << 35.0 << 20.0;
    QTest::newRow("small") << 30.0 << 3.0 << 4.0;
    QTest::newRow("large") << 140.0 << -30.0 << 100.0;
}

void TestSlitNeck::itReachesPastTheSlit()
{
    QFETCH(const double, x);
    QFETCH(const double, y);
    QFETCH(const double, radius);
    const Contour drawn = blob({x, y}, radius, 0.1, 0.3);
    for (const Contour &either : {drawn, drawn.reversed()}) {
        const std::optional<Contour> neck = withNeck(either, kSlit);
        QVERIFY(neck);
        QVERIFY(isAlongSlit(*neck, kSlit, drawn));
        QVERIFY(isPlain(*neck, {}, kCutChord));
        for (const Vec2 &p : drawn.polygon(kDrawChord)) {
            const Vec2 middle(x, y);
            QVERIFY(isIn(middle + 0.99 * (p - middle), *neck));
        }
        // No more than a neck: what is away from the slit and the way to it stays free.
        QVERIFY(!isIn({-kSlit.length - 0.1, 0.0}, *neck));
        QVERIFY(!isIn({0.0, 0.5 * kSlit.thickness + 2.1 * kSlit.thickness}, *neck));
    }
}

void TestSlitNeck::whatNeedsNone_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("radius");
    QTest::newRow("round the slit") << 5.0 << 0.0 << 40.0;
    QTest::newRow("over half of it") << 27.0 << 0.0 << 20.0;
    QTest::newRow("round its start") << -10.0 << 0.0 << 15.0;
    QTest::newRow("behind its start") << -40.0 << 0.0 << 15.0;
    QTest::newRow("too far below") << 90.0 << 0.0 << 20.0;
    QTest::newRow("too far aside") << 10.0 << 80.0 << 20.0;
}

void TestSlitNeck::whatNeedsNone()
{
    QFETCH(const double, x);
    QFETCH(const double, y);
    QFETCH(const double, radius);
    QVERIFY(!withNeck(blob({x, y}, radius, 0.05, 1.0), kSlit));
}

void TestSlitNeck::whatIsSymmetricStaysSo()
{
    // A leg that spreads: its tip is on the slit's line.
    const Contour leg =
        Contour::ofPolygon({{16, 0}, {50, -25}, {70, -25}, {40, 0}, {70, 25}, {50, 25}});
    const std::optional<Contour> neck = withNeck(leg, kSlit);
    QVERIFY(neck);
    QVERIFY(isAlongSlit(*neck, kSlit, leg));
    const Polygon polygon = neck->polygon(kDrawChord);
    for (const Vec2 &p : polygon) {
        double nearest = 1e9;
        for (const Vec2 &q : polygon)
            nearest = std::min(nearest, (Vec2(p.x(), -p.y()) - q).norm());
        QVERIFY2(nearest <= 2.0 * kClipGrid, qPrintable(QString::number(nearest)));
    }
}

// Wrong: of a slit nearly through a body the neck stands out of its other side.
void TestSlitNeck::noFartherThanTheBody()
{
    SlitToReach slit = kSlit;
    slit.behind = 2.0;
    const std::optional<Contour> neck = withNeck(blob({40.0, 0.0}, 20.0, 0.1, 0.3), slit);
    QVERIFY(neck);
    const double top = -slit.behind - slit.thickness;
    QVERIFY(std::abs(neck->bounds().min.x() - top) < 1e-6);
}

// Wherever a blob is: with a neck it is one piece along the slit; without one it was over the slit
// already, behind its start, or out of reach.
void TestSlitNeck::blobsAllRound()
{
    std::mt19937 random(24);
    std::uniform_real_distribution<double> place(-90.0, 110.0), size(3.0, 45.0), phase(0.0, 6.0);
    int made = 0;
    for (int i = 0; i < 400; ++i) {
        const Vec2 middle(place(random), place(random));
        const double radius = size(random);
        const Contour drawn = blob(middle, radius, 0.2, phase(random));
        const std::optional<Contour> neck = withNeck(drawn, kSlit);
        if (neck) {
            ++made;
            QVERIFY(isAlongSlit(*neck, kSlit, drawn));
            QVERIFY(isPlain(*neck, {}, kCutChord));
            QVERIFY(isIn(middle, *neck));
            continue;
        }
        double nearest = 1e9;
        bool isOnLine = false;
        const Polygon polygon = drawn.polygon(kDrawChord);
        for (const Vec2 &p : polygon)
            nearest = std::min(nearest, (p - Vec2(kSlit.length, 0.0)).norm());
        for (double x = -200.0; x < 0.8 * kSlit.length; x += 0.25)
            isOnLine = isOnLine || isIn({x, 0.0}, drawn);
        QVERIFY(isOnLine || nearest > kSlit.farthest - 1.0);
    }
    QVERIFY(made > 60);
}

FFF_TEST(TestSlitNeck)
#include "tst_slit_neck.moc"
