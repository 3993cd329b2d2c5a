// Pictures that are traced: what is cut is what was seen.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/polygon.h"
#include "core/templates/traced_picture.h"
#include "tests/test_program.h"

#include <functional>
#include <numbers>

using namespace fff;

namespace {

/// Of what is dark, by the share of each pixel that it covers; about the middle, y up.
GreyPicture drawn(int width, int height, const std::function<bool(const Vec2 &)> &isDark)
{
    constexpr int kSteps = 4;
    GreyPicture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int dark = 0;
            for (int i = 0; i < kSteps * kSteps; ++i)
                dark += isDark({x + (i % kSteps + 0.5) / kSteps - 0.5 * width,
                                0.5 * height - y - (i / kSteps + 0.5) / kSteps})
                            ? 1
                            : 0;
            picture.grey.push_back(static_cast<std::uint8_t>(255 - 255 * dark / (kSteps * kSteps)));
        }
    return picture;
}

std::function<bool(const Vec2 &)> disc(const Vec2 &centre, double radius)
{
    return [=](const Vec2 &p) { return (p - centre).norm() < radius; };
}

double areaOf(const TracedRegion &region)
{
    double area = std::abs(region.outer.signedArea());
    for (const Contour &hole : region.holes)
        area -= std::abs(hole.signedArea());
    return area;
}

} // namespace

class TestTracedPicture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aDiscIsRound();
    void whereThingsLie();
    void holesAndIslands();
    void cornersStayUnlessTheyAreSmoothed();
    void lighterInPlaceOfDarker();
    void dirtIsLeftOut();
    void theEdgeOfThePictureEndsIt();
    void largePicturesComeOutAsLarge();
    void whatThresholdIsSuggested();
    void whatCannotBeTraced();
};

void TestTracedPicture::aDiscIsRound()
{
    for (const double radius : {8.0, 30.0, 90.0}) {
        const auto regions = traced(drawn(200, 200, disc({0, 0}, radius)), {.smoothing = 0.75});
        QVERIFY(regions);
        QCOMPARE(regions->size(), std::size_t(1));
        for (const Vec2 &p : regions->front().outer.polygon(0.05))
            QVERIFY2(std::abs(p.norm() - radius) < 0.75, qPrintable(QString::number(p.norm())));
        // As few curves as a person would use, not one a pixel.
        QVERIFY(regions->front().outer.segmentCount() < 24);
    }
}

void TestTracedPicture::whereThingsLie()
{
    // Odd sizes, and away from the middle: up is up and right is right.
    const auto regions = traced(drawn(161, 87, disc({40, -20}, 15)), {});
    QVERIFY(regions);
    QCOMPARE(regions->size(), std::size_t(1));
    const Box2 box = bounds(regions->front().outer.polygon(0.05));
    QVERIFY((0.5 * (box.min + box.max) - Vec2(40, -20)).norm() < 0.5);
}

void TestTracedPicture::holesAndIslands()
{
    const auto isDark = [](const Vec2 &p) {
        const double r = p.norm();
        return (r > 40 && r < 60) || r < 12 || (p - Vec2(80, 80)).norm() < 9;
    };
    const auto regions = traced(drawn(220, 220, isDark), {});
    QVERIFY(regions);
    QCOMPARE(regions->size(), std::size_t(3));
    QCOMPARE(regions->at(0).holes.size(), std::size_t(1));
    QVERIFY(regions->at(1).holes.empty() && regions->at(2).holes.empty());
    const double pi = std::numbers::pi;
    QVERIFY(std::abs(areaOf(regions->at(0)) / (pi * (3600 - 1600)) - 1.0) < 0.02);
    QVERIFY(std::abs(areaOf(regions->at(1)) / (pi * 144) - 1.0) < 0.05);
}

void TestTracedPicture::cornersStayUnlessTheyAreSmoothed()
{
    const auto square = [](const Vec2 &p) { return p.cwiseAbs().maxCoeff() < 50.0; };
    const GreyPicture picture = drawn(160, 160, square);
    const auto sharp = traced(picture, {.smoothing = 0.5}),
               soft = traced(picture, {.smoothing = 1.0});
    QVERIFY(sharp && soft);
    const auto reach = [](const TracedRegion &region) {
        double most = 0.0;
        for (const Vec2 &p : region.outer.polygon(0.05))
            most = std::max(most, p.norm());
        return most;
    };
    QVERIFY(reach(sharp->front()) > 50.0 * std::numbers::sqrt2 - 0.5);
    QVERIFY(reach(soft->front()) < reach(sharp->front()) - 0.2);
    QVERIFY(std::abs(areaOf(sharp->front()) - 10000.0) < 30.0);
}

void TestTracedPicture::lighterInPlaceOfDarker()
{
    const GreyPicture picture = drawn(100, 100, disc({0, 0}, 30));
    const auto inverted = traced(picture, {.isInverted = true});
    QVERIFY(inverted);
    QCOMPARE(inverted->size(), std::size_t(1));
    QCOMPARE(inverted->front().holes.size(), std::size_t(1));
    const double rest = 10000.0 - areaOf(traced(picture, {})->front());
    QVERIFY(std::abs(areaOf(inverted->front()) - rest) < 5.0);
}

void TestTracedPicture::dirtIsLeftOut()
{
    const auto isDark = [](const Vec2 &p) {
        return p.norm() < 30 || (p - Vec2(50, 50)).norm() < 2.0;
    };
    const GreyPicture picture = drawn(160, 160, isDark);
    QCOMPARE(traced(picture, {.smallest = 16})->size(), std::size_t(1));
    QCOMPARE(traced(picture, {.smallest = 2})->size(), std::size_t(2));
}

void TestTracedPicture::theEdgeOfThePictureEndsIt()
{
    const auto all = traced(drawn(64, 40, [](const Vec2 &) { return true; }), {});
    QVERIFY(all);
    QCOMPARE(all->size(), std::size_t(1));
    QVERIFY(std::abs(areaOf(all->front()) - 64.0 * 40.0) < 2.0);
    QVERIFY(traced(drawn(64, 40, [](const Vec2 &) { return false; }), {})->empty());
}

void TestTracedPicture::largePicturesComeOutAsLarge()
{
    GreyPicture picture{6000, 4001, {}};
    picture.grey.assign(6000U * 4001U, 255);
    for (int y = 1000; y < 2000; ++y)
        std::fill_n(picture.grey.begin() + y * 6000 + 3000, 1500, std::uint8_t(0));
    const auto regions = traced(picture, {});
    QVERIFY(regions);
    QCOMPARE(regions->size(), std::size_t(1));
    const Box2 box = bounds(regions->front().outer.polygon(0.05));
    QVERIFY((box.min - Vec2(0, 0.5)).norm() < 2.5);
    QVERIFY((box.max - Vec2(1500, 1000.5)).norm() < 2.5);
}

void TestTracedPicture::whatThresholdIsSuggested()
{
    GreyPicture picture{20, 20, {}};
    picture.grey.assign(400, 200);
    QCOMPARE(suggestedThreshold(picture), 0.5);
    std::fill_n(picture.grey.begin(), 60, std::uint8_t(140));
    const double threshold = suggestedThreshold(picture) * 255.0;
    QVERIFY(threshold > 140.0 && threshold < 200.0);
    QCOMPARE(traced(picture, {.threshold = suggestedThreshold(picture)})->size(), std::size_t(1));
}

void TestTracedPicture::whatCannotBeTraced()
{
    QVERIFY(!traced({}, {}));
    QVERIFY(!traced({4, 4, std::vector<std::uint8_t>(15)}, {}));
    QVERIFY(!traced({-4, -4, std::vector<std::uint8_t>(16)}, {}));
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled =
        traced(drawn(10, 10, [](const Vec2 &) { return true; }), {}, {stop.get_token(), {}});
    QVERIFY(!cancelled && cancelled.error().code == ErrorCode::Cancelled);
}

FFF_TEST(TestTracedPicture)
#include "tst_traced_picture.moc"
