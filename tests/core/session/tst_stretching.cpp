// Sections that end above the ground, drawn out down to it.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/footing.h"
#include "core/analysis/stretching.h"
#include "core/base/tolerances.h"
#include "core/geometry/halfplane_clip.h"
#include "core/model/edits.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <numeric>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kThickness = 3.0;

/// Upright, across the side plane's axis, leaning to the right by so much.
Frame leaning(double angle)
{
    return {Vec3::Zero(), -Vec3::UnitZ(), {std::sin(angle), std::cos(angle), 0.0}};
}

/// A body 200 long, 40 to 80 above the ground, on hind legs at x = 60.
Document onHindLegs(ShapePointer hindLegs = plateOf(-30, 0, 30, 60))
{
    return withSection(withSection(newDocument(), plateOf(-100, 40, 100, 80), front()),
                       std::move(hindLegs), side(60));
}

std::vector<int> allOf(const Analysis &analysis)
{
    std::vector<int> all(analysis.model.sectionCount());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// Y of the lowest point of the shape's slab.
double lowestY(const Shape &shape, const Frame &frame)
{
    return contactOf({shape.region(), frame, kThickness}).lowest;
}

/// Of what lies above the level, and below it.
std::array<double, 2> areas(const Shape &shape, const Vec2 &up, double level)
{
    std::array<double, 2> sums{};
    for (const double side : {1.0, -1.0}) {
        const auto pieces = *clip(shape.contour(), shape.holes(), {level * up, side * up});
        for (const ClippedPiece &piece : pieces) {
            double &sum = sums[side > 0.0 ? 0 : 1];
            sum += piece.outer.signedArea();
            for (const Contour &hole : piece.holes)
                sum += hole.signedArea();
        }
    }
    return sums;
}

} // namespace

class TestStretching : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyWhatIsFreeGetsLonger_data();
    void onlyWhatIsFreeGetsLonger();
    void itGetsALevelSole();
    void whatIsHeldStays();
    void onTheGroundNothingIsStretched();
    void notEverythingIsStretched_data();
    void notEverythingIsStretched();
    void asFewAsItTakes_data();
    void asFewAsItTakes();
};

void TestStretching::onlyWhatIsFreeGetsLonger_data()
{
    QTest::addColumn<ShapePointer>("shape");
    QTest::addColumn<double>("angle");
    const ShapePointer fork = polygonShape(
        {{-20, 5}, {-10, 5}, {-10, 40}, {10, 40}, {10, 12}, {20, 12}, {20, 90}, {-20, 90}});
    QTest::newRow("plate") << plateOf(-20, 5, 20, 90) << 0.0;
    QTest::newRow("leaning plate") << plateOf(-20, 9, 20, 90) << 0.7;
    QTest::newRow("two prongs, of which one is higher") << fork << 0.0;
    QTest::newRow("two prongs that lean") << fork << -0.5;
    QTest::newRow("disc with a hole in the middle")
        << *Shape::make(circle({0, 50}, 40), {circle({0, 50}, 10)}) << 0.0;
    QTest::newRow("disc with a hole below")
        << *Shape::make(circle({0, 50}, 40), {circle({0, 25}, 8)}) << 0.3;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angles(-1.0, 1.0), heights(1.0, 10.0);
    for (int i = 0; i < 60; ++i) {
        Contour contour = blob(random, 5 + i % 9, 40.0);
        std::vector<Vec2> points = contour.points();
        const double lift = 45.0 + heights(random);
        for (Vec2 &p : points)
            p.y() += lift;
        QTest::addRow("blob %d", i)
            << *Shape::make(*Contour::fromPoints(std::move(points))) << angles(random);
    }
}

// Wrong: a foot that ends above or below the ground, a section that is another one where its joints
// are, or a contour that crosses itself.
void TestStretching::onlyWhatIsFreeGetsLonger()
{
    QFETCH(ShapePointer, shape);
    QFETCH(double, angle);
    const Frame frame = leaning(angle);
    const Analysis analysis = analysed(withSection(newDocument(), shape, frame));
    const double before = lowestY(*shape, frame);
    QVERIFY(before > kGroundContact);
    const std::optional<ShapePointer> longer = stretchedToGround(analysis, 0);
    const double level = shape->centroid().y() - kThickness;
    const double length = level - contactOf({shape->region(), front(), 0.0}).lowest;
    const double growth = before / std::cos(angle);
    if (length <= 0.0 || growth > length) {
        QVERIFY(!longer);
        return;
    }
    QVERIFY(longer);
    QVERIFY(std::abs(lowestY(**longer, frame)) < kCutChord);
    const auto [above, below] = areas(*shape, Vec2::UnitY(), level);
    const auto [aboveNow, belowNow] = areas(**longer, Vec2::UnitY(), level);
    QVERIFY(std::abs(aboveNow - above) < 1e-6 * above);
    // More is drawn out where a sole is cut, and less is left.
    QVERIFY(belowNow < below * (1.0 + (growth + kThickness) / length) * (1.0 + 1e-4));
    if (length - growth < kThickness)
        QVERIFY(std::abs(belowNow - below * (1.0 + growth / length)) < 1e-4 * belowNow);
    QCOMPARE((*longer)->isPlain(), shape->isPlain());
    QCOMPARE((*longer)->holes().size(), shape->holes().size());
}

// Wrong: a leg that was drawn by hand stands on a point of it.
void TestStretching::itGetsALevelSole()
{
    const auto soleOf = [](const Shape &shape) {
        double from = 1e9, to = -1e9;
        for (const Vec2 &p : shape.region().outer)
            if (std::abs(p.y()) < kGroundContact)
                from = std::min(from, p.x()), to = std::max(to, p.x());
        return to - from;
    };
    const auto stretched = [](ShapePointer shape) {
        return *stretchedToGround(analysed(withSection(newDocument(), std::move(shape), front())),
                                  0);
    };
    const ShapePointer disc = stretched(*Shape::make(circle({0, 50}, 40)));
    QVERIFY(soleOf(*disc) > 20.0);
    const ShapePointer slanted = stretched(polygonShape({{-10, 5}, {10, 7}, {10, 90}, {-10, 90}}));
    QVERIFY(std::abs(soleOf(*slanted) - 20.0) < 1e-3);
    // One that is level already is as long as it was.
    const ShapePointer level = stretched(plateOf(-20, 5, 20, 90));
    QVERIFY(std::abs(soleOf(*level) - 40.0) < 1e-3);
    QVERIFY(std::abs(level->area() - 40.0 * 90.0) < 1e-3);
}

// Wrong: slits are not where their mates are any more.
void TestStretching::whatIsHeldStays()
{
    const Document document = withSection(onHindLegs(), plateOf(-30, 6, 30, 60), side(-60));
    const Analysis before = analysed(document);
    const std::vector<HighFoot> feet = feetToStretch(before, allOf(before));
    QCOMPARE(feet.size(), std::size_t(1));
    QCOMPARE(feet[0].height, 6.0);
    QCOMPARE(feet[0].at.y(), 6.0);
    const Analysis after = analysed(*standingOn(before, allOf(before), feet));
    QVERIFY(stabilityOf(after, allOf(after)).standing == Standing::Stands);
    QCOMPARE(after.assembly.joints.size(), before.assembly.joints.size());
    for (std::size_t i = 0; i < before.model.sectionCount(); ++i)
        QVERIFY(after.assembly.slits[i] == before.assembly.slits[i]);
    for (std::size_t i = 0; i < 2; ++i)
        QVERIFY(after.model.section(i) == before.model.section(i));
}

// Wrong: what stands is made longer.
void TestStretching::onTheGroundNothingIsStretched()
{
    const auto at = [](double height) {
        const Document document =
            withSection(newDocument(), plateOf(-20, height, 20, height + 60), front());
        return stretchedToGround(analysed(document), 0).has_value();
    };
    QVERIFY(!at(-1.0));
    QVERIFY(!at(0.0));
    QVERIFY(!at(0.9 * kGroundContact));
    QVERIFY(at(1.1 * kGroundContact));
    QVERIFY(at(26.0));
    QVERIFY(!at(28.0)); // of the 30 below its middle 27 are free
}

void TestStretching::notEverythingIsStretched_data()
{
    QTest::addColumn<Document>("document");
    QTest::newRow("on the ground, both of them")
        << withSection(onHindLegs(), plateOf(-30, 0.01, 30, 60), side(60 - kThickness));
    QTest::newRow("more than twice as long")
        << withSection(onHindLegs(), plateOf(-30, 25, 30, 60), side(-60));
    QTest::newRow("held at its end: its slit opens downwards")
        << withSection(onHindLegs(), plateOf(-30, 50, 30, 110), side(-60));
    QTest::newRow("something is in the way")
        << withSection(withSection(onHindLegs(), plateOf(-30, 6, 30, 60), side(-60)),
                       plateOf(-90, -40, -30, 40), {{0, 3, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
    QTest::newRow("it would fall all the same")
        << withSection(onHindLegs(), plateOf(-30, 6, 30, 60), side(70));
    QTest::newRow("level") << withSection(onHindLegs(), plateOf(-80, -30, 0, 30),
                                          {{0, 60, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
}

// Wrong: a link that does not help, or does harm.
void TestStretching::notEverythingIsStretched()
{
    QFETCH(Document, document);
    const Analysis analysis = analysed(document);
    QVERIFY(asDrawn(analysis, {0, 1, 2}).standing == Standing::Topples);
    QVERIFY(feetToStretch(analysis, {0, 1, 2}).empty());
}

void TestStretching::asFewAsItTakes_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<QList<int>>("expected");
    const auto leg = [](double height, double from, double to) {
        return plateOf(from, height, to, 60);
    };
    const Document hind = onHindLegs();
    QTest::newRow("the lower one of two")
        << withSection(withSection(hind, leg(8, -30, 30), side(-60)), leg(4, -30, 30), side(-40))
        << QList<int>{3};
    QTest::newRow("the only one that helps")
        << withSection(withSection(hind, leg(8, -30, 30), side(-60)), leg(4, -30, 30), side(80))
        << QList<int>{2};
    // A body on one foot far to its right and back, with a bar across for legs at its two ends.
    const Document one =
        withSection(withSection(withSection(newDocument(), plateOf(-100, 40, 100, 80), front()),
                                plateOf(-60, 40, 60, 60), side(-80)),
                    plateOf(-2, 0, 2, 60), side(90));
    Document two = withSection(one, plateOf(-90, 5, -60, 60), front(50));
    two = withSection(two, plateOf(-90, 9, -60, 60), front(-50));
    QTest::newRow("two that are needed together") << two << QList<int>{3, 4};
    QTest::newRow("three, of which one is needless")
        << withSection(two, leg(2, -30, 30), side(70)) << QList<int>{3, 4};
}

// Wrong: sections are changed that are no part of the fault, or the fault stays.
void TestStretching::asFewAsItTakes()
{
    QFETCH(Document, document);
    QFETCH(QList<int>, expected);
    const Analysis analysis = analysed(document);
    QVERIFY(asDrawn(analysis, allOf(analysis)).standing == Standing::Topples);
    const std::vector<HighFoot> feet = feetToStretch(analysis, allOf(analysis));
    QList<int> found;
    for (const HighFoot &foot : feet)
        found += analysis.model.indexOf(foot.section);
    std::sort(found.begin(), found.end());
    QCOMPARE(found, expected);
    const Analysis after = analysed(*standingOn(analysis, allOf(analysis), feet));
    QVERIFY(stabilityOf(after, allOf(after)).standing == Standing::Stands);
}

FFF_TEST(TestStretching)
#include "tst_stretching.moc"
