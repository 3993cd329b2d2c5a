#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/side_of_line.h"
#include "tests/test_program.h"

#include <limits>

using namespace fff;

class TestSideOfLine : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsNeighbouringNumbersApart();
    void swappingTurnsItOver();
};

namespace {

int sign(double value)
{
    return (value > 0.0) - (value < 0.0);
}

} // namespace

/// Wrong: a triangulation misses triangles, or a point lies on both sides of an edge.
/// Source  L. Kettner et al. 2008, Classroom examples of robustness problems in geometric
///         computations: what is rounded on the way is wrong for many of these points.
void TestSideOfLine::tellsNeighbouringNumbersApart()
{
    constexpr double kStep = std::numeric_limits<double>::epsilon() / 2.0; // next to each other
    const Vec2 a(12.0, 12.0), b(24.0, 24.0);
    int roundedWrongly = 0;
    for (int i = 0; i < 256; ++i) {
        for (int k = 0; k < 256; ++k) {
            const Vec2 c(0.5 + i * kStep, 0.5 + k * kStep);
            QCOMPARE(sign(sideOfLine(a, b, c)), sign(k - i));
            QCOMPARE(sign(exactSideOfLine(a, b, c)), sign(k - i));
            roundedWrongly += sign(cross(b - a, c - a)) != sign(k - i);
        }
    }
    QVERIFY(roundedWrongly > 1000);
}

void TestSideOfLine::swappingTurnsItOver()
{
    const Vec2 a(0.1, 0.2), b(0.7, -0.3), c(0.4, 0.9);
    QVERIFY(sideOfLine(a, b, c) > 0.0);
    QVERIFY(sideOfLine(b, a, c) < 0.0);
    QVERIFY(sideOfLine(b, c, a) > 0.0);
    QVERIFY(sideOfLine(a, b, a) == 0.0 && sideOfLine(a, b, b) == 0.0);
}

FFF_TEST(TestSideOfLine)
#include "tst_side_of_line.moc"
