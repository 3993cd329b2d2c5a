#include "core/geometry/moments.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

class TestMoments : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rectangle();
    void holesSubtract();
    void areaIsTheContours();
    void movingShiftsTheCentroid();
    void farAwayLosesNoDigits();
};

// Wrong: centres of mass and bending stiffness would be off for the plainest plate.
void TestMoments::rectangle()
{
    const Moments m = moments(polygonContour(rectangleAt(0, 0, 6, 4)));
    QCOMPARE(m.area, 24.0);
    QVERIFY((m.centroid() - Vec2(3, 2)).norm() < 1e-12);
    QCOMPARE(m.xx, 6.0 * 6.0 * 6.0 * 4.0 / 3.0);
    QCOMPARE(m.yy, 4.0 * 4.0 * 4.0 * 6.0 / 3.0);
    QCOMPARE(m.xy, 36.0 * 16.0 / 4.0);
}

// Wrong: a hole would add weight.
void TestMoments::holesSubtract()
{
    Moments m = moments(polygonContour(rectangleAt(0, 0, 40, 40)));
    m += moments(polygonContour(rectangleAt(20, 10, 10, 20)).reversed());
    QCOMPARE(m.area, 1400.0);
    QVERIFY(m.centroid().x() < 20.0);
    QVERIFY(std::abs(m.centroid().y() - 20.0) < 1e-12);
}

// Wrong: two answers to one question.
void TestMoments::areaIsTheContours()
{
    for (const NamedContour &shape : simpleContours()) {
        const double area = shape.contour.signedArea();
        // A contour far away loses digits in the closed form, not in the moments.
        const double reach = shape.contour.bounds().max.cwiseAbs().maxCoeff();
        QVERIFY2(std::abs(moments(shape.contour).area - area) <= 1e-13 * reach * reach + 1e-9,
                 shape.name);
    }
    QCOMPARE(moments(Contour()).area, 0.0);
}

// Wrong: a turned or moved section would balance differently.
void TestMoments::movingShiftsTheCentroid()
{
    std::mt19937 random(11);
    const Contour contour = blob(random, 9, 30);
    std::vector<Vec2> points = contour.points();
    for (Vec2 &p : points)
        p = perpendicular(p) + Vec2(100, -50);
    const Moments before = moments(contour);
    const Moments after = moments(Contour::fromPoints(points).value());
    QVERIFY((after.centroid() - (perpendicular(before.centroid()) + Vec2(100, -50))).norm() < 1e-9);
    const Vec2 c0 = before.centroid(), c1 = after.centroid();
    const double polar0 = before.xx + before.yy - before.area * c0.squaredNorm();
    const double polar1 = after.xx + after.yy - after.area * c1.squaredNorm();
    QVERIFY(std::abs(polar0 - polar1) < 1e-9 * polar0);
}

// Wrong: sections drawn far from the origin would get rounding for weights.
void TestMoments::farAwayLosesNoDigits()
{
    const Moments m = moments(polygonContour(rectangleAt(900000, -900000, 8, 4)));
    QVERIFY(std::abs(m.area - 32.0) < 1e-8);
    QVERIFY((m.centroid() - Vec2(900004, -899998)).norm() < 1e-3);
}

FFF_TEST(TestMoments)
#include "tst_moments.moc"
