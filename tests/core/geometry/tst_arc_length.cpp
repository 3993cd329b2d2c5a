#include "core/geometry/arc_length.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

class TestArcLength : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void polygonsAreAsLongAsTheirEdges();
    void agreesWithFineChords_data();
    void agreesWithFineChords();
    void placeAndLengthAreInverse_data();
    void placeAndLengthAreInverse();
    void directionsOfNastyPlaces();
};

// Wrong: replicas round a box would not be spaced as asked.
void TestArcLength::polygonsAreAsLongAsTheirEdges()
{
    const ArcLength length(polygonContour(rectangleAt(3, 4, 40, 10)));
    QVERIFY(std::abs(length.total() - 100.0) < 1e-10);
    QVERIFY(std::abs(length.of({1, 0.5}) - 45.0) < 1e-10);
    const CurvePoint place = length.at(-5.0); // modulo the total: on the last edge
    QCOMPARE(place.segment, 3);
    QVERIFY((positionAt(length.contour(), place) - Vec2(3, 9)).norm() < 1e-9);
}

void TestArcLength::agreesWithFineChords_data()
{
    QTest::addColumn<int>("index");
    const auto contours = simpleContours();
    for (std::size_t i = 0; i < contours.size(); ++i)
        QTest::newRow(contours[i].name) << static_cast<int>(i);
}

// Wrong: a length that no ruler finds.
void TestArcLength::agreesWithFineChords()
{
    QFETCH(int, index);
    const Contour contour = simpleContours()[static_cast<std::size_t>(index)].contour;
    double chords = 0.0;
    constexpr int kSteps = 4096;
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        for (int k = 0; k < kSteps; ++k)
            chords += (curve.at((k + 1.0) / kSteps) - curve.at(double(k) / kSteps)).norm();
    }
    const double total = ArcLength(contour).total();
    QVERIFY2(std::abs(total - chords) < 1e-6 * chords, qPrintable(QString::number(total - chords)));
}

void TestArcLength::placeAndLengthAreInverse_data()
{
    agreesWithFineChords_data();
}

// Wrong: a replica would stand elsewhere than its place in the row, or jump where segments meet.
void TestArcLength::placeAndLengthAreInverse()
{
    QFETCH(int, index);
    const ArcLength length(simpleContours()[static_cast<std::size_t>(index)].contour);
    for (int i = 0; i < 97; ++i) {
        const double wanted = length.total() * i / 97.0;
        const double got = length.of(length.at(wanted));
        // A vertex that is there twice has two places of one length; the end is the start.
        const double off = std::abs(got - wanted);
        QVERIFY2(std::min(off, length.total() - off) < 1e-8 * length.total(),
                 qPrintable(QStringLiteral("%1 instead of %2").arg(got).arg(wanted)));
    }
}

// Wrong: a replica at a corner, or where a handle has no length, would have no direction.
void TestArcLength::directionsOfNastyPlaces()
{
    const Contour square = polygonContour(rectangleAt(0, 0, 10, 10));
    QVERIFY((directionAt(square, {0, 1.0}) - Vec2::UnitY()).norm() < 1e-12);
    QVERIFY((directionAt(square, {1, 0.0}) - Vec2::UnitY()).norm() < 1e-12);
    const Contour noHandle =
        Contour::fromPoints({{0, 0}, {0, 0}, {10, 10}, {20, 0}, {15, -5}, {5, -5}}).value();
    QVERIFY((directionAt(noHandle, {0, 0.0}) - Vec2(1, 1).normalized()).norm() < 1e-12);
    const Contour withPoint =
        Contour::fromPoints(
            {{0, 0}, {0, 0}, {0, 0}, {0, 0}, {3, 0}, {7, 0}, {10, 0}, {5, 8}, {2, 8}})
            .value();
    QVERIFY((directionAt(withPoint, {0, 0.3}) - Vec2::UnitX()).norm() < 1e-12);
}

FFF_TEST(TestArcLength)
#include "tst_arc_length.moc"
