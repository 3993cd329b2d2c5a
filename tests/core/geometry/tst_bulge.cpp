// Boundaries that are pushed out over a stretch of their way.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/geometry/arc_length.h"
#include "core/geometry/bulge.h"
#include "core/geometry/contour_points.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

/// What is pushed after so much of the boundary from the middle, by the words of the header.
double shareAfter(double from, const Bulge &bulge)
{
    const double beyond = std::max(0.0, std::abs(from) - bulge.flat) / bulge.blend;
    return beyond >= 1.0 ? 0.0 : 1.0 - beyond * beyond * (3.0 - 2.0 * beyond);
}

double distanceTo(const Contour &contour, const Vec2 &point)
{
    return nearestPlace(contour, point).distance;
}

} // namespace

class TestBulge : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPlaceIsWhereItWasPushed_data();
    void everyPlaceIsWhereItWasPushed();
    void whatLiesBeyondStays();
    void smoothStaysSmooth();
    void tooLongForTheBoundary();
};

void TestBulge::everyPlaceIsWhereItWasPushed_data()
{
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("where"); // share of the boundary
    QTest::addColumn<double>("flat");  // share of it
    const auto shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (const double where : {0.0, 0.13, 0.62})
            for (const double flat : {0.0, 0.05})
                QTest::newRow(qPrintable(QStringLiteral("%1, at %2, flat %3")
                                             .arg(QLatin1String(shapes[i].name))
                                             .arg(where)
                                             .arg(flat)))
                    << static_cast<int>(i) << where << flat;
}

// Wrong: a boundary that is pushed elsewhere, by more, or torn.
void TestBulge::everyPlaceIsWhereItWasPushed()
{
    QFETCH(int, shape);
    QFETCH(double, where);
    QFETCH(double, flat);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    const ArcLength length(contour);
    const double total = length.total();
    const Bulge bulge{
        length.at(where * total), {0.01 * total, 0.007 * total}, flat * total, 0.08 * total};
    const auto made = bulged(contour, bulge);
    QVERIFY(made);
    constexpr int kPlaces = 400;
    const double middle = length.of(bulge.middle);
    for (int i = 0; i < kPlaces; ++i) {
        const double at = total * i / kPlaces;
        const double share = shareAfter(std::remainder(at - middle, total), bulge);
        const CurvePoint place = length.at(at);
        const Vec2 expected = positionAt(contour, place) + share * bulge.way;
        // Curves within the blend are the cubics with their ends and tangents, no more.
        const bool isExact = share == 0.0 || share == 1.0 || isLine(contour.segment(place.segment));
        const double off = distanceTo(*made, expected);
        QVERIFY2(off < (isExact ? 1e-6 : 0.06 * bulge.way.norm()),
                 qPrintable(QString::number(off)));
    }
}

// Wrong: an edit of one place that changes the digits of another one.
void TestBulge::whatLiesBeyondStays()
{
    const Contour square = polygonContour(rectangleAt(0, 0, 100, 100));
    const Bulge bulge{{0, 0.5}, {0.0, -4.0}, 10.0, 12.0};
    const auto made = bulged(square, bulge);
    QVERIFY(made);
    QCOMPARE(made->segmentCount(), 10); // the first side is cut in six places
    for (int i = 1; i < 4; ++i) {
        const CubicBezier was = square.segment(i), is = made->segment(i + 6);
        QVERIFY(was.p0 == is.p0 && was.p1 == is.p1 && was.p2 == is.p2 && was.p3 == is.p3);
    }
    QVERIFY(std::abs(made->signedArea() - (10000.0 + 4.0 * (20.0 + 12.0))) < 1e-9);
}

// Wrong: a kink, from which a crack would begin.
void TestBulge::smoothStaysSmooth()
{
    const Contour round = circle({3, 4}, 30);
    const auto made = bulged(round, {{1, 0.3}, {-2.0, 2.5}, 6.0, 14.0});
    QVERIFY(made);
    for (int i = 0; i < made->segmentCount(); ++i) {
        const Vec2 in = anchor(*made, i) - handle(*made, i, HandleSide::In);
        const Vec2 out = handle(*made, i, HandleSide::Out) - anchor(*made, i);
        QVERIFY(std::abs(std::atan2(cross(in, out), in.dot(out))) < 1e-3);
    }
}

// Wrong: a boundary that is pushed twice, where the bulge meets its own end.
void TestBulge::tooLongForTheBoundary()
{
    const Contour square = polygonContour(rectangleAt(0, 0, 10, 10));
    QVERIFY(!bulged(square, {{0, 0.5}, {1.0, 0.0}, 10.5, 10.0}));
    QVERIFY(!bulged(square, {{0, 0.5}, {1.0, 0.0}, 1.0, 0.0}));
    QVERIFY(!bulged(square, {{0, 0.5}, {1.0, 0.0}, -1.0, 3.0}));
    QVERIFY(bulged(square, {{0, 0.5}, {1.0, 0.0}, 9.0, 10.0}));
}

FFF_TEST(TestBulge)
#include "tst_bulge.moc"
