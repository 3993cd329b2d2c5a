#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/point_edits.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// A plate of 60 × 40 with a hole of 10 × 10 in its middle.
ShapePointer plate()
{
    return polygonShape(rectangle(0, 0, 60, 40), {rectangle(25, 15, 35, 25)});
}

ErrorCode codeOf(const Result<ShapePointer> &result)
{
    return result ? ErrorCode::Unsupported : result.error().code;
}

} // namespace

class TestPointEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pointsOfAllBoundariesMoveTogether();
    void aContourThatWouldCrossItselfIsRefused();
    void holesStayInsideAndApart();
    void whatTouchedMayTouch();
    void aContourThatTurnsInsideOutKeepsItsPoints();
    void deletingAHolesPointsRemovesIt();
    void deletingTooMuchOfTheContourIsRefused();
    void unknownPointsAreSaid();
    void holesGoAllAtOnce();
};

void TestPointEdits::pointsOfAllBoundariesMoveTogether()
{
    const ShapePointer before = plate();
    const std::vector<PointAddress> points{{0, 0}, {1, 2}};
    const ShapePointer after = *movedPoints(*before, points, {-2, 1});
    for (const PointAddress &p : points)
        QVERIFY((position(*after, p) - position(*before, p) - Vec2(-2, 1)).norm() < 1e-12);
    QVERIFY(position(*after, {1, 0}) == position(*before, {1, 0}));
    QVERIFY(after->isPlain());
}

// Wrong: a contour that crosses itself is cut to its largest region behind a person's back.
void TestPointEdits::aContourThatWouldCrossItselfIsRefused()
{
    const ShapePointer shape = polygonShape(rectangle(0, 0, 60, 40));
    QCOMPARE(codeOf(movedPoint(*shape, {0, 0}, {70, 30})), ErrorCode::SelfCrossing);
    QCOMPARE(codeOf(movedPoint(*shape, {0, 0}, {50, 30})), ErrorCode::Unsupported);
    const Result<ShapePointer> loop =
        movedHandle(**movedHandle(*shape, {0, 0}, HandleSide::Out, {90, 80}, true), {0, 1},
                    HandleSide::In, {-30, 80}, true);
    QCOMPARE(codeOf(loop), ErrorCode::SelfCrossing);
}

void TestPointEdits::holesStayInsideAndApart()
{
    const ShapePointer shape =
        polygonShape(rectangle(0, 0, 60, 40), {rectangle(5, 5, 15, 15), rectangle(25, 15, 35, 25)});
    const std::vector<PointAddress> hole{{1, 0}, {1, 1}, {1, 2}, {1, 3}};
    QVERIFY(movedPoints(*shape, hole, {2, 3}).has_value());
    QCOMPARE(codeOf(movedPoints(*shape, hole, {-7, 0})), ErrorCode::BoundariesMeet);
    QCOMPARE(codeOf(movedPoints(*shape, hole, {-40, 0})), ErrorCode::BoundariesMeet);
    QCOMPARE(codeOf(movedPoints(*shape, hole, {15, 5})), ErrorCode::BoundariesMeet);
    QCOMPARE(codeOf(movedPoints(*shape, hole, {20, 10})), ErrorCode::BoundariesMeet); // just upon
    // The contour over a hole.
    QCOMPARE(codeOf(movedPoint(*shape, {0, 0}, {14, 14})), ErrorCode::BoundariesMeet);
}

// Wrong: a file whose holes touch could not be edited any more.
void TestPointEdits::whatTouchedMayTouch()
{
    const ShapePointer shape =
        polygonShape(rectangle(0, 0, 60, 40), {rectangle(5, 5, 15, 15), rectangle(15, 5, 25, 15)});
    QVERIFY(!shape->isPlain());
    QVERIFY(movedPoint(*shape, {1, 0}, {6, 6}).has_value());
    QVERIFY(movedPoint(*shape, {0, 0}, {-3, -3}).has_value());
}

// Wrong: a triangle's tip that is dragged over its base is lost on the way.
void TestPointEdits::aContourThatTurnsInsideOutKeepsItsPoints()
{
    const ShapePointer shape = polygonShape({{0, 0}, {40, 0}, {20, 30}});
    const ShapePointer turned = *movedPoint(*shape, {0, 2}, {20, -30});
    QVERIFY(turned->contour().signedArea() > 0.0);
    const std::vector<Vec2> places{{20, -30}};
    const auto found = pointsAt(*turned, places);
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY(position(*turned, found.front()) == places.front());
    QCOMPARE(codeOf(movedPoint(*shape, {0, 2}, {20, 0})), ErrorCode::EmptyContour);
}

void TestPointEdits::deletingAHolesPointsRemovesIt()
{
    const ShapePointer shape =
        polygonShape(rectangle(0, 0, 60, 40), {rectangle(5, 5, 15, 15), rectangle(25, 15, 35, 25)});
    const std::vector<PointAddress> one{{1, 0}}, all{{1, 0}, {1, 1}, {1, 2}, {2, 3}};
    QCOMPARE(boundary(**withoutPoints(*shape, one), 1).segmentCount(), 3);
    const ShapePointer after = *withoutPoints(*shape, all);
    QCOMPARE(boundaryCount(*after), 2);
    QCOMPARE(boundary(*after, 1).segmentCount(), 3); // of the second hole, a point went as well
}

void TestPointEdits::deletingTooMuchOfTheContourIsRefused()
{
    const ShapePointer shape = plate();
    const std::vector<PointAddress> three{{0, 0}, {0, 1}, {0, 2}}, two{{0, 0}, {0, 2}};
    QCOMPARE(codeOf(withoutPoints(*shape, three)), ErrorCode::TooFewPoints);
    QCOMPARE(codeOf(withoutPoints(*shape, two)), ErrorCode::EmptyContour); // a line there and back
    const std::vector<PointAddress> corner{{0, 0}};
    QCOMPARE(codeOf(withoutPoints(*polygonShape(rectangle(0, 0, 60, 40), {rectangle(5, 5, 15, 15)}),
                                  corner)),
             ErrorCode::BoundariesMeet);
}

void TestPointEdits::unknownPointsAreSaid()
{
    const ShapePointer shape = plate();
    for (const PointAddress &p : {PointAddress{0, 4}, {2, 0}, {-1, 0}, {0, -1}})
        QCOMPARE(codeOf(movedPoint(*shape, p, {0, 0})), ErrorCode::UnknownReference);
}

void TestPointEdits::holesGoAllAtOnce()
{
    const ShapePointer after = *withoutHoles(*plate());
    QCOMPARE(boundaryCount(*after), 1);
    QVERIFY(after->contour() == plate()->contour());
}

FFF_TEST(TestPointEdits)
#include "tst_point_edits.moc"
