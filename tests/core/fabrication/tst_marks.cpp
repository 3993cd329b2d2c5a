#include "core/base/tolerances.h"
#include "core/fabrication/marks.h"
#include "core/fabrication/room.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/mark_distances.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/geometry/curve_distance.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

Part partOf(const CurvedRegion &outline, int number = 1)
{
    Part part;
    part.number = number;
    part.outline = outline;
    return part;
}

/// Empty when all marks lie in the material, off every cut and off each other.
QString whatIsWrong(const Engraving &engraving, const Part &part, const MarkOptions &options)
{
    // Marks are placed on chords of the drawing's tolerance.
    const double least = options.clearance - 0.05;
    const Region &region = part.outline.region;
    for (std::size_t i = 0; i < engraving.strokes.size(); ++i) {
        for (const Vec2 &p : engraving.strokes[i]) {
            double nearest = distanceTo(p, region.outer);
            for (const Polygon &hole : region.holes)
                nearest = std::min(nearest, distanceTo(p, hole));
            if (locate(p, region) != Side::Inside || nearest < least)
                return QStringLiteral("a stroke leaves the material or comes near a cut");
        }
    }
    for (std::size_t i = 0; i < engraving.boxes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Box2 &a = engraving.boxes[i], &b = engraving.boxes[j];
            if ((a.min - b.max).cwiseMax(b.min - a.max).maxCoeff() < least)
                return QStringLiteral("two marks overlap");
        }
    }
    return {};
}

double height(const Box2 &box)
{
    return box.size().y();
}

} // namespace

class TestMarks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void digitsDiffer();
    void ambiguousNumbersAreUnderlined_data();
    void ambiguousNumbersAreUnderlined();
    void numberLiesInTheMaterial_data();
    void numberLiesInTheMaterial();
    void numberShrinksToFit();
    void numberIsLeftOutWhereNoneCanBeRead();
    void jointStandsBeyondItsSlit();
    void jointMovesAsideWhereThereIsNoRoomBeyond();
    void manyJointsKeepApart();
    void smallPartsAreReadNumberByNumber();
    void aJointsNumberIsNoPartsNumber();
    void roomiestPlaceOfAnL();
    void whatFitsIsWhatCanGrow();
    void rowsLeadToAPlaceThatFits();
    void insideIsBetweenTheRings();
};

// Wrong: two numbers would look the same.
void TestMarks::digitsDiffer()
{
    std::set<std::vector<std::pair<double, double>>> seen;
    for (int digit = 0; digit < 10; ++digit) {
        Strokes strokes;
        appendNumber(digit, {0, 0}, 1.0, strokes);
        std::vector<std::pair<double, double>> points;
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            QVERIFY(strokes[i].size() >= 2);
            for (const Vec2 &p : strokes[i]) {
                QVERIFY(p.minCoeff() >= 0.0 && (strokedSize(digit) - p).minCoeff() >= -1e-12);
                points.emplace_back(p.x(), p.y());
            }
        }
        QVERIFY(seen.insert(points).second);
    }
    QVERIFY(strokedSize(1234567890).x() > 9.0 * strokedSize(1).x());
}

void TestMarks::ambiguousNumbersAreUnderlined_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<bool>("underlined");
    QTest::newRow("6 could be 9") << 6 << true;
    QTest::newRow("9 could be 6") << 9 << true;
    QTest::newRow("86 could be 98") << 86 << true;
    QTest::newRow("8 is 8") << 8 << false;
    QTest::newRow("80 starts with no 0") << 80 << false;
    QTest::newRow("16 has a 1 with a foot") << 16 << false;
}

// Wrong: part 6 would be taken for part 9.
void TestMarks::ambiguousNumbersAreUnderlined()
{
    QFETCH(int, number);
    QFETCH(bool, underlined);
    QCOMPARE(strokedSize(number).y() > 1.0, underlined);
}

void TestMarks::numberLiesInTheMaterial_data()
{
    QTest::addColumn<int>("shape");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        QTest::newRow(shapes[i].name) << static_cast<int>(i);
}

// Wrong: a number would be burnt across a cut, on nasty shapes as on plain ones.
void TestMarks::numberLiesInTheMaterial()
{
    QFETCH(int, shape);
    const Part part =
        partOf(regionOf(simpleContours()[static_cast<std::size_t>(shape)].contour), 108);
    const Engraving engraving = engrave(part, {});
    QCOMPARE(whatIsWrong(engraving, part, {}), QString());
    QCOMPARE(engraving.hasNumber, !engraving.strokes.isEmpty());
    // Only the needle is too slim.
    QCOMPARE(engraving.hasNumber,
             QByteArray(QTest::currentDataTag()) != "a triangle like a needle");
}

// Wrong: small parts would get no number, or one as large as the part.
void TestMarks::numberShrinksToFit()
{
    const Engraving large =
        engrave(partOf(regionOf(polygonContour(rectangleAt(0, 0, 40, 40)))), {});
    QVERIFY(std::abs(height(large.boxes.at(0)) - 6.0) < 1e-9);
    const Engraving small = engrave(partOf(regionOf(polygonContour(rectangleAt(0, 0, 40, 4)))), {});
    QVERIFY(small.hasNumber);
    QVERIFY(height(small.boxes.at(0)) < 4.0 - 2.0 * 0.4 + 1e-9);
    QVERIFY(height(small.boxes.at(0)) > 2.8);
}

// Wrong: a blot would be burnt on tiny parts, and nobody told.
void TestMarks::numberIsLeftOutWhereNoneCanBeRead()
{
    const Engraving none =
        engrave(partOf(regionOf(polygonContour(rectangleAt(0, 0, 40, 1.8)))), {});
    QVERIFY(!none.hasNumber);
    QVERIFY(none.strokes.isEmpty());
}

// Wrong: one would look for the joint's number in the wrong place.
void TestMarks::jointStandsBeyondItsSlit()
{
    Part part = partOf(
        regionOf(polygonContour(rectangleAt(0, 0, 60, 40)), {}, {rectangleAt(28.5, 20, 3, 30)}));
    part.joints.push_back({7, {30, 20}, {0, -1}, 3.0});
    const Engraving engraving = engrave(part, {});
    QCOMPARE(whatIsWrong(engraving, part, {}), QString());
    QVERIFY(engraving.jointsLeftOut.empty());
    QCOMPARE(engraving.boxes.size(), 2U);
    const Box2 &joint = engraving.boxes[0];
    QVERIFY(std::abs(joint.center().x() - 30.0) < 1e-9);
    QVERIFY(joint.max.y() < 20.0 && joint.max.y() > 19.0);
    QVERIFY(std::abs(height(joint) - 3.0) < 1e-9);
}

// Wrong: slits that almost reach the other side would lose their number.
void TestMarks::jointMovesAsideWhereThereIsNoRoomBeyond()
{
    Part part = partOf(
        regionOf(polygonContour(rectangleAt(0, 0, 60, 40)), {}, {rectangleAt(28.5, 1.5, 3, 50)}));
    part.joints.push_back({7, {30, 1.5}, {0, -1}, 3.0});
    const Engraving engraving = engrave(part, {});
    QCOMPARE(whatIsWrong(engraving, part, {}), QString());
    QVERIFY(engraving.jointsLeftOut.empty());
    QVERIFY(std::abs(engraving.boxes[0].center().x() - 30.0) < 5.0);
}

// Wrong: in an egg crate the numbers would lie over each other.
void TestMarks::manyJointsKeepApart()
{
    Document document = newDocument();
    for (int i = 0; i < 6; ++i) {
        document =
            withSection(document, polygonShape(rectangle(-50, 0, 50, 24)), front(15.0 * (i - 2.5)));
        document =
            withSection(document, polygonShape(rectangle(-50, 0, 50, 24)), side(15.0 * (i - 2.5)));
    }
    const std::vector<Part> parts = partsOf(evaluate(document));
    QCOMPARE(parts.size(), 12U);
    for (const Part &part : parts) {
        QCOMPARE(part.joints.size(), 6U);
        const Engraving engraving = engrave(part, {});
        QCOMPARE(whatIsWrong(engraving, part, {}), QString());
        QVERIFY(engraving.jointsLeftOut.empty());
        QVERIFY(engraving.hasNumber);
        QCOMPARE(engraving.boxes.size(), 7U);
    }
}

// Wrong: on small and slim parts "1" beside "2" would be read as twelve.
void TestMarks::smallPartsAreReadNumberByNumber()
{
    constexpr unsigned kSeed = 9;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    int complete = 0, reduced = 0;
    for (int round = 0; round < 400; ++round) {
        const double width = 4.0 + 56.0 * share(random), height = 2.0 + 18.0 * share(random);
        const int count = static_cast<int>(6.0 * share(random));
        std::vector<Polygon> slits;
        Part part = partOf({}, 1 + static_cast<int>(200.0 * share(random)));
        for (int i = 0; i < count; ++i) {
            const double x = width * (i + 0.2 + 0.6 * share(random)) / count;
            const double bottom = height * (0.2 + 0.6 * share(random));
            slits.push_back(rectangleAt(x - 0.5, bottom, 1.0, height));
            part.joints.push_back({1 + 10 * round + i, {x, bottom}, {0, -1}, 1.0});
        }
        part.outline = regionOf(polygonContour(rectangleAt(0, 0, width, height)), {}, slits);
        const Engraving engraving = engrave(part, {});
        const QString wrong = misread(engraving, part);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(round).arg(wrong)));
        const bool isComplete = engraving.hasNumber && engraving.jointsLeftOut.empty();
        (isComplete ? complete : reduced) += 1;
    }
    qInfo("%d with all numbers, %d without some", complete, reduced);
    QVERIFY(complete > 100);
}

// Wrong: the number of a joint could be taken for that of a part.
void TestMarks::aJointsNumberIsNoPartsNumber()
{
    for (const int number : {1, 4, 6, 7, 12, 69, 108}) {
        Strokes plain, barred;
        appendNumber(number, {0, 0}, 1.0, plain);
        appendJointNumber(number, {0, 0}, 1.0, barred);
        QCOMPARE(barred.size(), plain.size() + 1);
        // One level stroke, at half the digits' height, before all of them.
        QCOMPARE(barred[0].size(), 2U);
        QCOMPARE(barred[0][0].y(), barred[0][1].y());
        double firstDigit = strokedJointSize(number).x();
        for (std::size_t i = 1; i < barred.size(); ++i)
            for (const Vec2 &p : barred[i]) {
                firstDigit = std::min(firstDigit, p.x());
                QVERIFY(p.minCoeff() >= 0.0 && (strokedJointSize(number) - p).minCoeff() >= -1e-12);
            }
        QVERIFY(firstDigit > std::max(barred[0][0].x(), barred[0][1].x()) + 0.2);
    }
}

// Wrong: the number would stand in a corner though there is room elsewhere.
void TestMarks::roomiestPlaceOfAnL()
{
    const Room room({{{0, 0}, {100, 0}, {100, 20}, {40, 20}, {40, 100}, {0, 100}}, {}});
    const Vec2 half(2, 2);
    const Vec2 center = room.roomiest(half);
    // The arm 40 mm wide is the wider one: boxes up to 20 mm of half size fit there.
    QVERIFY(room.scaleAt(center, half) >= 0.95 * 10.0);
    QVERIFY(room.scaleAt({90, 90}, half) < 0.0);
}

// Wrong: one of two ways to look for a place would burn numbers across cuts.
void TestMarks::whatFitsIsWhatCanGrow()
{
    constexpr unsigned kSeed = 17;
    std::mt19937 random(kSeed);
    int fitting = 0;
    for (const NamedContour &shape : simpleContours()) {
        Room room({shape.contour.flatten(kDrawChord).points, {}});
        const Box2 box = shape.contour.bounds();
        room.take({box.center(), box.center() + 0.1 * box.size()});
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (int i = 0; i < 200; ++i) {
            const Vec2 center =
                box.min + box.size().cwiseProduct(Vec2(share(random), share(random)));
            const Vec2 half = 0.2 * box.size().cwiseProduct(Vec2(share(random), share(random)));
            const double scale = room.scaleAt(center, half);
            if (std::abs(scale - 1.0) < 1e-9)
                continue;
            QVERIFY2(room.fits(center, half) == (scale > 1.0), shape.name);
            fitting += scale > 1.0;
        }
    }
    QVERIFY(fitting > 100);
}

// Wrong: the first look for the number's place would find none, or one across a cut.
void TestMarks::rowsLeadToAPlaceThatFits()
{
    const Vec2 half(2, 4);
    Room plate({rectangleAt(0, 0, 40, 30), {}});
    QVERIFY(plate.findInRows(half).has_value());
    QVERIFY((*plate.findInRows(half) - Vec2(20, 15)).norm() < 1e-9);
    plate.take({{0, 14}, {38, 16}}); // the middle row is full
    const auto place = plate.findInRows(half);
    QVERIFY(place.has_value());
    QVERIFY(plate.fits(*place, half));
    // An arch: the middle of its box is no material.
    Polygon arch = rectangleAt(0, 0, 60, 30);
    arch.insert(arch.begin() + 1, {{5.5, 0}, {5.5, 24}, {54.5, 24}, {54.5, 0}});
    const Room legs({arch, {}});
    QVERIFY(legs.findInRows(half).has_value());
    QVERIFY(legs.fits(*legs.findInRows(half), half));
    QVERIFY(!Room({rectangleAt(0, 0, 40, 7), {}}).findInRows(half).has_value());
}

// Wrong: numbers would stand in holes, or nowhere on a part of many slits.
void TestMarks::insideIsBetweenTheRings()
{
    Region comb{{{0, 0}, {2000, 0}}, {}};
    for (int i = 199; i >= 0; --i) {
        const double x = 10.0 * i;
        for (const Vec2 &p : {Vec2(x + 10, 40), Vec2(x + 3, 40), Vec2(x + 3, 20), Vec2(x, 20)})
            comb.outer.push_back(p);
        comb.holes.push_back({{x + 4, 25}, {x + 4, 30}, {x + 6, 35}, {x + 8, 27}});
    }
    const Room room(comb);
    std::mt19937 random(18);
    std::uniform_real_distribution<double> along(-20.0, 2020.0), across(-5.0, 45.0);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec2 point(along(random), across(random));
        const Side side = locate(point, comb);
        QCOMPARE(room.scaleAt(point, Vec2(1, 1)) > 0.0, side == Side::Inside);
        inside += side == Side::Inside ? 1 : 0;
    }
    QVERIFY(inside > 500);
}

FFF_TEST(TestMarks)
#include "tst_marks.moc"
