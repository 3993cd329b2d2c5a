#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/contour_points.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// Largest distance between two curves of as many segments, at the same parameters.
double difference(const Contour &a, const Contour &b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.points().size(); ++i)
        worst = std::max(worst, (a.points()[i] - b.points()[i]).norm());
    return a.points().size() == b.points().size() ? worst : std::numeric_limits<double>::infinity();
}

/// A circle whose fourth part is a line: two smooth points beside a line.
Contour stadium()
{
    return *Contour::fromSegments({CubicBezier::line({-20, -10}, {20, -10}),
                                   {{20, -10}, {33, -10}, {33, 10}, {20, 10}},
                                   CubicBezier::line({20, 10}, {-20, 10}),
                                   {{-20, 10}, {-33, 10}, {-33, -10}, {-20, -10}}});
}

} // namespace

class TestContourPoints : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void kindsFollowFromTheHandles();
    void movingThereAndBack_data();
    void movingThereAndBack();
    void anAnchorLandsToTheBit();
    void linesStayLinesAndSmoothPointsSmooth();
    void aSmoothPointStaysSmoothUnderItsHandles();
    void aBrokenPointIsACorner();
    void aSegmentFollowsTheCursor();
    void aLineThatIsPulledBends();
    void insertingLeavesTheCurve_data();
    void insertingLeavesTheCurve();
    void insertThenDeleteGivesBackTheCurve_data();
    void insertThenDeleteGivesBackTheCurve();
    void deletingAmongLinesLeavesALine();
    void deletingKeepsTheTangentsOfTheNeighbours();
    void twoSegmentsStay();
    void kindsRoundTrip_data();
    void kindsRoundTrip();
    void theNearestPlaceIsNearest();
};

// Wrong: a point is drawn and edited as another kind than it looks.
void TestContourPoints::kindsFollowFromTheHandles()
{
    const Contour round = circle({3, 4}, 20);
    for (int i = 0; i < 4; ++i)
        QCOMPARE(kindOf(round, i), PointKind::Symmetric);
    const Contour square = polygonContour(rectangleAt(0, 0, 40, 40));
    for (int i = 0; i < 4; ++i)
        QCOMPARE(kindOf(square, i), PointKind::Corner);
    for (int i = 0; i < 4; ++i)
        QCOMPARE(kindOf(stadium(), i), PointKind::Smooth);
    // Straight on between two lines: it makes a corner as soon as it is moved.
    QCOMPARE(kindOf(*insertedPoint(square, 1, 0.4), 2), PointKind::Corner);
    const auto turned =
        movedHandle(round, 1, HandleSide::In, handle(round, 1, HandleSide::In) + Vec2(0, 3), true);
    QCOMPARE(kindOf(*turned, 1), PointKind::Corner);
    const auto retracted = movedHandle(round, 1, HandleSide::In, anchor(round, 1), true);
    QCOMPARE(kindOf(*retracted, 1), PointKind::Corner);
}

void TestContourPoints::movingThereAndBack_data()
{
    QTest::addColumn<int>("shape");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        QTest::newRow(shapes[i].name) << static_cast<int>(i);
}

// Wrong: a contour creeps while a person tries things and takes them back.
void TestContourPoints::movingThereAndBack()
{
    QFETCH(int, shape);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    const Vec2 by(3.25, -1.5);
    const double rounding = 1e-9 * (1.0 + contour.bounds().max.cwiseAbs().maxCoeff() +
                                    contour.bounds().min.cwiseAbs().maxCoeff());
    std::vector<std::vector<int>> choices;
    for (int i = 0; i < contour.segmentCount(); ++i)
        choices.push_back({i});
    choices.push_back({0, contour.segmentCount() - 1});
    for (const std::vector<int> &indices : choices) {
        const auto there = movedAnchors(contour, indices, by);
        QVERIFY(there.has_value());
        for (const int i : indices)
            QVERIFY((anchor(*there, i) - anchor(contour, i) - by).norm() <= rounding);
        const auto back = movedAnchors(*there, indices, -by);
        QVERIFY(difference(*back, contour) <= rounding);
    }
}

// Wrong: 12.7 is typed and 12.699999999999999 is shown.
void TestContourPoints::anAnchorLandsToTheBit()
{
    const Contour contour = circle({0.1, 0.7}, 33.3);
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const Vec2 to(12.7 + 0.1 * i, -0.3);
        QVERIFY(anchor(*movedAnchor(contour, i, to), i) == to);
    }
}

// Wrong: the edge of a plate bends when its corner is moved, or its round end gets a kink.
void TestContourPoints::linesStayLinesAndSmoothPointsSmooth()
{
    const std::vector<int> corner{1};
    const Contour square =
        *movedAnchors(polygonContour(rectangleAt(0, 0, 40, 40)), corner, {7, -5});
    for (int i = 0; i < 4; ++i)
        QVERIFY(isLine(square.segment(i)));
    const Contour moved = *movedAnchors(stadium(), corner, {6, 4});
    QVERIFY(isLine(moved.segment(0)));
    for (int i = 0; i < 4; ++i)
        QVERIFY(kindOf(moved, i) != PointKind::Corner);
}

void TestContourPoints::aSmoothPointStaysSmoothUnderItsHandles()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> reach(-9.0, 9.0);
    for (Contour contour : {blob(random, 7, 40), circle({0, 0}, 30), stadium()}) {
        for (int step = 0; step < 200; ++step) {
            const int index = step % contour.segmentCount();
            const PointKind before = kindOf(contour, index);
            const HandleSide side = step % 2 == 0 ? HandleSide::In : HandleSide::Out;
            const Vec2 opposite =
                handle(contour, index, side == HandleSide::In ? HandleSide::Out : HandleSide::In);
            const Vec2 to = anchor(contour, index) + Vec2(reach(random), reach(random));
            const Contour next = *movedHandle(contour, index, side, to, false);
            if (before == PointKind::Corner ||
                (handle(next, index, side) - anchor(next, index)).norm() < 1e-3)
                continue; // a line's direction was crossed: the handle has gone
            QVERIFY(kindOf(next, index) != PointKind::Corner);
            if (before == PointKind::Symmetric && contour.segmentCount() != 4)
                QCOMPARE(kindOf(next, index), PointKind::Symmetric);
            const Vec2 now =
                handle(next, index, side == HandleSide::In ? HandleSide::Out : HandleSide::In);
            if (before == PointKind::Smooth)
                QVERIFY(std::abs((now - anchor(next, index)).norm() -
                                 (opposite - anchor(next, index)).norm()) < 1e-9);
            contour = next;
        }
    }
}

void TestContourPoints::aBrokenPointIsACorner()
{
    const Contour contour = circle({0, 0}, 30);
    const Vec2 out = handle(contour, 2, HandleSide::Out);
    const Contour next = *movedHandle(contour, 2, HandleSide::In, {-20, 30}, true);
    QCOMPARE(kindOf(next, 2), PointKind::Corner);
    QVERIFY(handle(next, 2, HandleSide::Out) == out);
}

// Wrong: the curve slips away under the cursor.
void TestContourPoints::aSegmentFollowsTheCursor()
{
    const Contour contour = circle({0, 0}, 30);
    for (const double t : {0.2, 0.35, 0.5, 0.8}) {
        const Vec2 by(2.0, 3.0);
        const Contour free = *movedSegment(contour, 1, t, by, true);
        QVERIFY((free.segment(1).at(t) - contour.segment(1).at(t) - by).norm() < 1e-9);
        QVERIFY(free.segment(0).p1 == contour.segment(0).p1);
        const Contour smooth = *movedSegment(contour, 1, t, by, false);
        QVERIFY((smooth.segment(1).at(t) - contour.segment(1).at(t) - by).norm() < 1e-9);
        QVERIFY(kindOf(smooth, 1) != PointKind::Corner);
        QVERIFY(kindOf(smooth, 2) != PointKind::Corner);
        QVERIFY(anchor(smooth, 1) == anchor(contour, 1));
    }
}

void TestContourPoints::aLineThatIsPulledBends()
{
    const Contour square = polygonContour(rectangleAt(0, 0, 40, 40));
    const Contour pulled = *movedSegment(square, 0, 0.5, {0, -5}, false);
    QVERIFY(!isLine(pulled.segment(0)));
    QVERIFY((pulled.segment(0).at(0.5) - Vec2(20, -5)).norm() < 1e-9);
    QVERIFY(isLine(pulled.segment(1)));
}

void TestContourPoints::insertingLeavesTheCurve_data()
{
    movingThereAndBack_data();
}

// Wrong: adding a point changes the part.
void TestContourPoints::insertingLeavesTheCurve()
{
    QFETCH(int, shape);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    const double size =
        contour.bounds().max.cwiseAbs().maxCoeff() + contour.bounds().min.cwiseAbs().maxCoeff();
    for (int i = 0; i < contour.segmentCount(); ++i) {
        for (const double t : {0.001, 0.3, 0.5, 0.97}) {
            const Contour more = *insertedPoint(contour, i, t);
            QCOMPARE(more.segmentCount(), contour.segmentCount() + 1);
            const CubicBezier whole = contour.segment(i);
            QVERIFY((anchor(more, i + 1) - whole.at(t)).norm() <= 1e-14 * size);
            for (double u = 0.0; u <= 1.0; u += 0.125) {
                QVERIFY((more.segment(i).at(u) - whole.at(u * t)).norm() <=
                        1e-12 * (1.0 + size / 100));
                QVERIFY((more.segment(i + 1).at(u) - whole.at(t + u * (1 - t))).norm() <=
                        1e-12 * (1.0 + size / 100));
            }
            // Pieces of lines are lines: they stay so when the point is moved.
            if ((whole.p3 - whole.p0).norm() * std::min(t, 1.0 - t) > 0.01)
                QCOMPARE(isLine(more.segment(i)) && isLine(more.segment(i + 1)), isLine(whole));
        }
    }
}

void TestContourPoints::insertThenDeleteGivesBackTheCurve_data()
{
    movingThereAndBack_data();
}

// Wrong: a point that was put in by mistake leaves a trace when it is deleted.
void TestContourPoints::insertThenDeleteGivesBackTheCurve()
{
    QFETCH(int, shape);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    const double size = contour.bounds().size().maxCoeff();
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier whole = contour.segment(i);
        if ((whole.p3 - whole.p0).norm() < 0.1)
            continue;
        const bool hasTangents = isLine(whole) || ((whole.p1 - whole.p0).norm() > 0.1 &&
                                                   (whole.p2 - whole.p3).norm() > 0.1);
        for (const double t : {0.25, 0.5, 0.8}) {
            const std::vector<int> inserted{i + 1};
            const Contour back = *withoutPoints(*insertedPoint(contour, i, t), inserted);
            QCOMPARE(back.segmentCount(), contour.segmentCount());
            for (double u = 0.0; u <= 1.0; u += 0.1)
                QVERIFY((back.segment(i).at(u) - whole.at(u)).norm() <=
                        (hasTangents ? 1e-6 : 0.05) * size);
        }
        // Two of them, and both at once.
        const Contour two = *insertedPoint(*insertedPoint(contour, i, 0.6), i, 0.5);
        const std::vector<int> both{i + 1, i + 2};
        const Contour back = *withoutPoints(two, both);
        for (double u = 0.0; u <= 1.0; u += 0.1)
            QVERIFY((back.segment(i).at(u) - whole.at(u)).norm() <=
                    (hasTangents ? 1e-6 : 0.05) * size);
    }
}

void TestContourPoints::deletingAmongLinesLeavesALine()
{
    const std::vector<int> corner{2};
    const Contour triangle = *withoutPoints(polygonContour(rectangleAt(0, 0, 40, 40)), corner);
    QCOMPARE(triangle.segmentCount(), 3);
    for (int i = 0; i < 3; ++i)
        QVERIFY(isLine(triangle.segment(i)));
}

// Wrong: deleting one point puts kinks into its neighbours.
void TestContourPoints::deletingKeepsTheTangentsOfTheNeighbours()
{
    std::mt19937 random(11);
    const Contour contour = blob(random, 12, 40);
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const std::vector<int> one{i};
        const Contour less = *withoutPoints(contour, one);
        for (int k = 0; k < less.segmentCount(); ++k)
            QVERIFY(kindOf(less, k) != PointKind::Corner);
        // As near as a cubic comes: the points of this blob lie up to 16 mm further out than
        // others.
        double worst = 0.0;
        for (const Vec2 &p : contour.flatten(0.1).points)
            worst = std::max(worst, nearestPlace(less, p).distance);
        QVERIFY2(worst < 12.0, qPrintable(QString::number(worst)));
    }
}

void TestContourPoints::twoSegmentsStay()
{
    const Contour contour = circle({0, 0}, 20);
    const std::vector<int> two{0, 2}, three{0, 1, 2};
    QCOMPARE(withoutPoints(contour, two)->segmentCount(), 2);
    QCOMPARE(withoutPoints(contour, three).error().code, ErrorCode::TooFewPoints);
}

void TestContourPoints::kindsRoundTrip_data()
{
    movingThereAndBack_data();
}

// Wrong: what a person chooses in the list is not what the list shows afterwards.
void TestContourPoints::kindsRoundTrip()
{
    QFETCH(int, shape);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const int before = (i + contour.segmentCount() - 1) % contour.segmentCount();
        if ((contour.segment(i).p3 - contour.segment(i).p0).norm() < 0.1 ||
            (contour.segment(before).p3 - contour.segment(before).p0).norm() < 0.1)
            continue;
        for (const PointKind first : {PointKind::Smooth, PointKind::Symmetric, PointKind::Corner}) {
            const Contour one = *withKind(contour, i, first);
            QCOMPARE(kindOf(one, i), first);
            QVERIFY(anchor(one, i) == anchor(contour, i));
            for (const PointKind second :
                 {PointKind::Smooth, PointKind::Symmetric, PointKind::Corner})
                QCOMPARE(kindOf(*withKind(one, i, second), i), second);
        }
    }
}

// Wrong: a double click puts the point elsewhere than the dot was shown.
void TestContourPoints::theNearestPlaceIsNearest()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> reach(-60.0, 60.0);
    for (const NamedContour &shape : simpleContours()) {
        if (shape.contour.bounds().max.x() > 1e4)
            continue;
        const Polygon dense = shape.contour.flatten(1e-4).points;
        for (int k = 0; k < 40; ++k) {
            const Vec2 p(reach(random), reach(random));
            const NearestPlace place = nearestPlace(shape.contour, p);
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < dense.size(); ++i) {
                const Vec2 a = dense[i], edge = dense[(i + 1) % dense.size()] - a;
                const double u = edge.squaredNorm() > 0
                                     ? std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0)
                                     : 0.0;
                nearest = std::min(nearest, (p - a - u * edge).norm());
            }
            QVERIFY(std::abs(place.distance - nearest) < 1e-3);
            QVERIFY(
                (shape.contour.segment(place.at.segment).at(place.at.t) - place.position).norm() <
                1e-12);
        }
    }
}

FFF_TEST(TestContourPoints)
#include "tst_contour_points.moc"
