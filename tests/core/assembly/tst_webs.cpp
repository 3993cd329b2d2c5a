#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/webs.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

using Between = Web::Between;

/// From the upper edge of a plate of 100 x 60 down to `bottom`.
Slit slitAt(double x, double bottom, double width = 3.0)
{
    Slit slit;
    slit.inner = {x, bottom};
    slit.mouth = {x, 60.05};
    slit.width = width;
    slit.guest = static_cast<int>(x); // each holds another section
    return slit;
}

Region plate(const std::vector<Polygon> &holes = {})
{
    Region region{rectangle(0, 0, 100, 60), holes};
    for (Polygon &hole : region.holes)
        std::reverse(hole.begin(), hole.end());
    return region;
}

constexpr double kLimit = 3.0; // mm

} // namespace

class TestWebs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void slitsWithRoomAreFine();
    void betweenTwoSlits();
    void slitsThatRunIntoEachOther();
    void besideAHole();
    void belowASlitAndBesideIt();
    void aSlantingMouthIsNoWeb();
    void aWallThatRunsOutOfTheEdge();
    void aMortiseNearTheEdge();
    void manyCostTheirNeighbours();
};

void TestWebs::slitsWithRoomAreFine()
{
    QVERIFY(thinWebs(plate(), {}, kLimit).empty());
    QVERIFY(thinWebs(plate(), {slitAt(20, 30), slitAt(26, 30), slitAt(80, 4)}, kLimit).empty());
    // As short as the stock is thick: its own mouth is no web.
    QVERIFY(thinWebs(plate(), {slitAt(50, 59)}, kLimit).empty());
}

/// What would be wrong: a finger that breaks off when the parts are put together.
void TestWebs::betweenTwoSlits()
{
    const std::vector<Web> webs = thinWebs(plate(), {slitAt(40, 30), slitAt(44.5, 40)}, kLimit);
    QCOMPARE(webs.size(), std::size_t(1));
    QCOMPARE(webs[0].between, Between::Slits);
    QVERIFY(std::abs(webs[0].width - 1.5) < 1e-9);
    QCOMPARE(webs[0].slit, 0);
    QCOMPARE(webs[0].other, 1);
    QVERIFY(std::abs(webs[0].at.x() - 42.25) < 1e-9);
}

void TestWebs::slitsThatRunIntoEachOther()
{
    Slit level;
    level.inner = {30, 40};
    level.mouth = {100.05, 40};
    level.width = 3.0;
    for (const auto &slits : {std::vector{slitAt(60, 30), level},
                              {slitAt(60, 41), level},
                              {slitAt(60, 30), slitAt(61, 31, 0.5)}}) {
        const std::vector<Web> webs = thinWebs(plate(), slits, kLimit);
        QCOMPARE(webs.size(), std::size_t(1));
        QCOMPARE(webs[0].width, 0.0);
    }
    // Of two overlaps of one joint: one section slides through the other slit.
    Slit lower = slitAt(60, 20), upper = slitAt(60, 40);
    QVERIFY(thinWebs(plate(), {lower, upper}, kLimit).empty());
}

void TestWebs::besideAHole()
{
    const std::vector<Web> webs = thinWebs(
        plate({rectangle(42, 20, 60, 40), rectangle(70, 20, 80, 30)}), {slitAt(39.5, 35)}, kLimit);
    QCOMPARE(webs.size(), std::size_t(1));
    QCOMPARE(webs[0].between, Between::SlitAndHole);
    QVERIFY(std::abs(webs[0].width - 1.0) < 1e-9);
    QCOMPARE(webs[0].other, 0);
    // Into the hole: nothing is between them.
    QVERIFY(thinWebs(plate({rectangle(42, 20, 60, 40)}), {slitAt(50, 30)}, kLimit).empty());
}

void TestWebs::belowASlitAndBesideIt()
{
    const std::vector<Web> deep = thinWebs(plate(), {slitAt(50, 2)}, kLimit);
    QCOMPARE(deep.size(), std::size_t(1));
    QCOMPARE(deep[0].between, Between::SlitAndContour);
    QVERIFY(std::abs(deep[0].width - 2.0) < 1e-9);
    QVERIFY(std::abs(deep[0].at.y() - 1.0) < 1e-9);
    const std::vector<Web> beside = thinWebs(plate(), {slitAt(97, 30)}, kLimit);
    QCOMPARE(beside.size(), std::size_t(1));
    QVERIFY(std::abs(beside[0].width - 1.5) < 1e-9);
}

void TestWebs::aSlantingMouthIsNoWeb()
{
    // A contour that rises by 45°.
    const Region slope{{{0, 0}, {100, 0}, {100, 120}, {0, 20}}, {}};
    Slit slit;
    slit.inner = {50, 40};
    slit.mouth = {50, 71.55};
    slit.width = 3.0;
    QVERIFY(thinWebs(slope, {slit}, kLimit).empty());
}

// Wrong: a slit whose wall is a hair for most of its depth, since it runs out of the edge further
// up.
void TestWebs::aWallThatRunsOutOfTheEdge()
{
    // The wall at x = 18.5 has 0.6 mm beside it at the bottom and none from y = 40 on.
    const Region slim{{{17.7, 0}, {60, 0}, {60, 60}, {18.9, 60}}, {}};
    const std::vector<Web> webs = thinWebs(slim, {slitAt(20, 10)}, kLimit);
    QCOMPARE(webs.size(), std::size_t(1));
    QCOMPARE(webs[0].between, Between::SlitAndContour);
    QVERIFY(webs[0].width > 0.0 && webs[0].width < 0.6);
    // A contour that goes steeply across the slit is its mouth.
    const Region chamfered{{{10, 0}, {60, 0}, {60, 60}, {40, 60}, {10, 30}}, {}};
    QVERIFY(thinWebs(chamfered, {slitAt(20, 10)}, kLimit).empty());
}

void TestWebs::aMortiseNearTheEdge()
{
    Slit slot;
    slot.inner = {20, 57};
    slot.mouth = {40, 57};
    slot.width = 3.0;
    slot.isOpen = false;
    const std::vector<Web> webs = thinWebs(plate(), {slot}, kLimit);
    QCOMPARE(webs.size(), std::size_t(1));
    QVERIFY(std::abs(webs[0].width - 1.5) < 1e-9);
}

/// What would be wrong: pairs that are left out by the sweep.
void TestWebs::manyCostTheirNeighbours()
{
    const Region bar{rectangle(0, 0, 20000, 60), {}};
    std::vector<Slit> slits;
    for (int i = 0; i < 3000; ++i)
        slits.push_back(slitAt(10.0 + (i % 2 == 0 ? 6.0 * i : 6.0 * i - 1.5), 30));
    const std::vector<Web> webs = thinWebs(bar, slits, kLimit);
    QCOMPARE(webs.size(), std::size_t(1500));
    for (const Web &web : webs)
        QCOMPARE(web.other, web.slit + 1);
}

FFF_TEST(TestWebs)
#include "tst_webs.moc"
