#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/fit.h"
#include "core/stroke/pen_path.h"
#include "tests/test_program.h"

#include <cmath>
#include <random>

using namespace fff;
using End = PenPath::End;

namespace {

PenPath pathOf(const std::vector<Vec2> &corners)
{
    PenPath path;
    for (const Vec2 &corner : corners) {
        path.keep();
        path.add(corner);
    }
    return path;
}

/// An edit that a person might do, by a random number.
void editAtRandom(PenPath &path, std::mt19937 &random)
{
    std::uniform_real_distribution<double> place(-100.0, 100.0);
    const Vec2 at(place(random), place(random));
    const auto index = path.isEmpty() ? 0 : random() % path.size();
    path.keep();
    switch (path.isEmpty() ? 0 : random() % 4) {
    case 0:
        path.add(at);
        break;
    case 1:
        path.move(index, at);
        break;
    case 2:
        path.bend(index, random() % 2 ? End::In : End::Out, at, random() % 2);
        break;
    default:
        path.removeLast();
    }
}

} // namespace

class TestPenPath : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void piecesMakeAChain();
    void cornersAreJoinedByLines();
    void handlesOfAPointFollowEachOther();
    void aBrokenHandleStaysBroken();
    void everyPieceHasDirections();
    void closes_data();
    void closes();
    void smoothPointsStaySmoothInTheContour();
    void aPathThatEndsAtItsStartNeedsNoClosing();
    void stepsGoBackAndForth();
    void nothingDoneIsNoStep();
};

/// A gap between pieces would make a contour that cannot be cut.
void TestPenPath::piecesMakeAChain()
{
    std::mt19937 random(7);
    PenPath path;
    for (int i = 0; i < 200; ++i) {
        editAtRandom(path, random);
        const std::vector<CubicBezier> pieces = path.pieces();
        QCOMPARE(pieces.size() + 1, std::max<std::size_t>(path.size(), 1));
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            QVERIFY(pieces[k].p0 == path.points()[k].at);
            QVERIFY(pieces[k].p3 == path.points()[k + 1].at);
        }
    }
}

void TestPenPath::cornersAreJoinedByLines()
{
    const PenPath path = pathOf({{0, 0}, {40, 0}, {40, 30}});
    for (const CubicBezier &piece : path.pieces()) {
        QVERIFY(piece.isStraight(0.0));
        const CubicBezier line = CubicBezier::line(piece.p0, piece.p3);
        QVERIFY(piece.p1 == line.p1 && piece.p2 == line.p2);
    }
}

/// A point that is bent is smooth: else a drag would make a corner that nobody asked for.
void TestPenPath::handlesOfAPointFollowEachOther()
{
    PenPath path = pathOf({{0, 0}, {40, 0}});
    path.bend(1, End::Out, {50, 20}, false);
    QVERIFY(*path.points()[1].out == Vec2(10, 20));
    QVERIFY(*path.points()[1].in == Vec2(-10, -20));
    path.bend(1, End::In, {30, 5}, false);
    QVERIFY(*path.points()[1].out == Vec2(10, -5));
    path.move(1, {0, 40});
    QVERIFY(path.pieces().front().p2 == Vec2(-10, 45));
    path.bend(1, End::Out, {0, 40}, false);
    QVERIFY(path.points()[1].isCorner());
}

void TestPenPath::aBrokenHandleStaysBroken()
{
    PenPath path = pathOf({{0, 0}, {40, 0}});
    path.bend(1, End::Out, {50, 20}, false);
    path.bend(1, End::Out, {60, 0}, true);
    QVERIFY(*path.points()[1].in == Vec2(-10, -20));
    path.bend(1, End::Out, {40, 40}, false);
    QVERIFY(*path.points()[1].in == Vec2(-10, -20));
    QVERIFY(*path.points()[1].out == Vec2(0, 40));
}

/// A piece without a direction at its end has no tangent for what is fitted, offset or edited
/// later.
void TestPenPath::everyPieceHasDirections()
{
    std::mt19937 random(11);
    PenPath path;
    for (int i = 0; i < 300; ++i) {
        editAtRandom(path, random);
        for (const CubicBezier &piece : path.pieces()) {
            if (piece.p0 == piece.p3)
                continue;
            QVERIFY((piece.p1 - piece.p0).norm() > 0.0);
            QVERIFY((piece.p3 - piece.p2).norm() > 0.0);
        }
    }
}

void TestPenPath::closes_data()
{
    QTest::addColumn<std::vector<Vec2>>("corners");
    QTest::addColumn<double>("area"); // 0: nothing is enclosed
    QTest::addColumn<int>("segments");
    QTest::addColumn<bool>("crosses");
    const auto row = [](const char *name, std::vector<Vec2> corners, double area, int segments,
                        bool crosses = false) {
        QTest::newRow(name) << corners << area << segments << crosses;
    };
    row("no point", {}, 0.0, 0);
    row("one point", {{1, 1}}, 0.0, 0);
    row("two points", {{0, 0}, {40, 0}}, 0.0, 0);
    row("three points on a line", {{0, 0}, {20, 10}, {40, 20}}, 0.0, 0);
    row("there and back", {{0, 0}, {40, 0}, {0, 0}}, 0.0, 0);
    row("a triangle", {{0, 0}, {40, 0}, {0, 30}}, 600.0, 3);
    row("a rectangle", {{0, 0}, {40, 0}, {40, 30}, {0, 30}}, 1200.0, 4);
    row("a rectangle the other way round", {{0, 30}, {40, 30}, {40, 0}, {0, 0}}, 1200.0, 4);
    row("a bow tie keeps its larger loop", {{0, 0}, {40, 0}, {0, 40}, {10, 40}}, 640.0, 3, true);
    row("thinner than dust", {{0, 0}, {1, 0}, {1, 1e-4}}, 0.0, 0);
}

/// What closes must have the area that was drawn, and nothing without area may be called a contour.
void TestPenPath::closes()
{
    QFETCH(std::vector<Vec2>, corners);
    QFETCH(double, area);
    QFETCH(int, segments);
    QFETCH(bool, crosses);
    const PathContour closed = closedPath(pathOf(corners).points());
    QCOMPARE(closed.contour.has_value(), area > 0.0);
    QCOMPARE(closed.wasCrossing, crosses);
    if (!closed.contour)
        return;
    QVERIFY(std::abs(std::abs(closed.contour->signedArea()) - area) < 1e-6);
    QCOMPARE(closed.contour->segmentCount(), segments);
}

void TestPenPath::smoothPointsStaySmoothInTheContour()
{
    PenPath path = pathOf({{0, 0}, {60, 0}, {30, 50}});
    path.bend(0, End::Out, {20, -20}, false);
    path.bend(1, End::Out, {70, 25}, false);
    path.bend(2, End::Out, {10, 55}, false);
    const PathContour closed = closedPath(path.points());
    QVERIFY(closed.contour && !closed.wasCrossing);
    QCOMPARE(closed.contour->segmentCount(), 3);
    for (int i = 0; i < 3; ++i) {
        const Vec2 before = endDirection(closed.contour->segment(i));
        const Vec2 after = startDirection(closed.contour->segment((i + 1) % 3));
        QVERIFY(std::abs(cross(before, after)) < 1e-12 && before.dot(after) > 0.0);
    }
}

/// Two pieces that end where they began are whole; a closing piece of no length would be a segment
/// that nobody drew.
void TestPenPath::aPathThatEndsAtItsStartNeedsNoClosing()
{
    PenPath path = pathOf({{0, 0}, {40, 0}, {40, 30}, {0, 0}});
    QVERIFY(!closedPath(path.points()).closing);
    QCOMPARE(closedPath(path.points()).contour->segmentCount(), 3);
    PenPath loop = pathOf({{0, 0}, {0, 0}});
    loop.bend(0, End::Out, {60, 20}, true);
    loop.bend(1, End::In, {20, 60}, true);
    QVERIFY(closedPath(loop.points()).contour);
    QCOMPARE(closedPath(loop.points()).contour->segmentCount(), 2);
}

/// Undo to the empty path and redo give every path of the way back, point for point.
void TestPenPath::stepsGoBackAndForth()
{
    std::mt19937 random(3);
    PenPath path;
    std::vector<PenPath> way{path};
    for (int i = 0; i < 100; ++i) {
        editAtRandom(path, random);
        if (!(path == way.back()))
            way.push_back(path);
    }
    for (std::size_t i = way.size() - 1; i-- > 0;) {
        QVERIFY(path.canUndo());
        path.undo();
        QVERIFY(path == way[i]);
    }
    QVERIFY(!path.canUndo());
    for (std::size_t i = 1; i < way.size(); ++i) {
        QVERIFY(path.canRedo());
        path.redo();
        QVERIFY(path == way[i]);
    }
    QVERIFY(!path.canRedo());
    path.undo();
    path.keep();
    path.add({1, 1});
    QVERIFY(!path.canRedo());
}

/// A press that leads to nothing must not need an undo of its own.
void TestPenPath::nothingDoneIsNoStep()
{
    PenPath path = pathOf({{0, 0}, {40, 0}});
    path.keep();
    path.keep();
    path.undo();
    QCOMPARE(path.size(), std::size_t(1));
    path.keep();
    QVERIFY(path.canRedo());
    path.redo();
    QCOMPARE(path.size(), std::size_t(2));
    path.undo();
    path.undo();
    QVERIFY(path.isEmpty() && !path.canUndo());
}

FFF_TEST(TestPenPath)
#include "tst_pen_path.moc"
