#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/model/ground.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

ShapePointer disc()
{
    return *Shape::make(circle({0, 0}, 20.0), {circle({0, -8}, 5.0)});
}

double lowestY(const Shape &shape, const Frame &frame)
{
    double y = std::numeric_limits<double>::infinity();
    const auto look = [&](const Contour &contour) {
        for (int i = 0; i < contour.segmentCount(); ++i)
            for (int k = 0; k <= 200; ++k)
                y = std::min(y, frame.toWorld(contour.segment(i).at(k / 200.0)).y());
    };
    look(shape.contour());
    for (const Contour &hole : shape.holes())
        look(hole);
    return y;
}

} // namespace

class TestGround : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lineOfATiltedPlane();
    void levelPlanes();
    void whatStandsAboveKeepsItsPointer();
    void whatLiesBelowIsGone();
    void feetAreFlat_data();
    void feetAreFlat();
};

/// The line is where the plane is at Y = 0, and its inside is above, however the frame lies.
void TestGround::lineOfATiltedPlane()
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        const auto axis = [&] { return Vec3(any(random), any(random), any(random)); };
        const Frame frame = *makeFrame(100.0 * axis(), axis(), axis());
        const std::optional<Halfplane> above = groundLine(frame);
        QVERIFY(above);
        QVERIFY(std::abs(above->inward.norm() - 1.0) < 1e-12);
        for (const double s : {-50.0, 0.0, 70.0})
            QVERIFY(std::abs(frame.toWorld(above->point + s * above->along()).y()) < 1e-9);
        QVERIFY(frame.toWorld(above->point + above->inward).y() > 0.0);
    }
}

void TestGround::levelPlanes()
{
    for (const double height : {0.0, 5.0, -5.0}) {
        const Frame level{{0, height, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
        QVERIFY(!groundLine(level));
        const ShapePointer shape = disc();
        const auto pieces = *clippedAtGround(shape, level);
        QCOMPARE(pieces.size(), std::size_t(height < 0.0 ? 0 : 1));
        QVERIFY(pieces.empty() || pieces.front() == shape);
        QCOMPARE(clippedAtGround(shape->contour(), level)->size(), pieces.size());
    }
}

void TestGround::whatStandsAboveKeepsItsPointer()
{
    const ShapePointer shape = disc();
    const Frame upright{{0, 20, 0}, Vec3::UnitX(), Vec3::UnitY()};
    const auto pieces = *clippedAtGround(shape, upright);
    QCOMPARE(pieces.size(), std::size_t(1));
    QVERIFY(pieces.front() == shape);
    QVERIFY(clippedAtGround(shape->contour(), upright)->front().outer == shape->contour());
}

void TestGround::whatLiesBelowIsGone()
{
    const Frame sunk{{0, -21, 0}, Vec3::UnitX(), Vec3::UnitY()};
    QVERIFY(clippedAtGround(disc(), sunk)->empty());
    QVERIFY(clippedAtGround(disc()->contour(), sunk)->empty());
}

void TestGround::feetAreFlat_data()
{
    QTest::addColumn<Frame>("frame");
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    QTest::newRow("upright") << Frame{{0, 7, 0}, x, y};
    QTest::newRow("upright, hole cut open") << Frame{{0, 8, 0}, x, y};
    QTest::newRow("upside down") << Frame{{3, -2, 5}, x, -y};
    QTest::newRow("on its side") << Frame{{3, 2, 5}, y, z};
    QTest::newRow("tilted") << *makeFrame({1, 4, 2}, {1, 0.2, 0.1}, {0.1, 1, 0.7});
    QTest::newRow("nearly level") << *makeFrame({1, 0.001, 2}, {1, 1e-4, 0.1}, {0.1, 2e-4, 0.7});
}

/// Feet that are not at Y = 0 do not stand; what is below would be in the ground.
void TestGround::feetAreFlat()
{
    QFETCH(Frame, frame);
    const auto pieces = *clippedAtGround(disc(), frame);
    QVERIFY(!pieces.empty());
    for (const ShapePointer &piece : pieces) {
        QVERIFY2(lowestY(*piece, frame) >= -1e-9,
                 qPrintable(QString::number(lowestY(*piece, frame))));
        const auto again = *clippedAtGround(piece, frame);
        QVERIFY(again.size() == 1 && again.front() == piece);
    }
    QVERIFY(std::abs(lowestY(*pieces.front(), frame)) < 1e-9);
    QVERIFY(pieces.front()->area() < disc()->area() - 1.0);
}

FFF_TEST(TestGround)
#include "tst_ground.moc"
