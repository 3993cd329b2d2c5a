#include "core/geometry/arc_length.h"
#include "core/geometry/contour_blend.h"
#include "core/geometry/contour_points.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

/// The largest distance of points of one contour from the other.
double distance(const Contour &from, const Contour &to)
{
    double most = 0.0;
    for (const Vec2 &p : uniformSamples(from, 512))
        most = std::max(most, nearestPlace(to, p).distance);
    return most;
}

Contour mirrored(const Contour &contour)
{
    std::vector<Vec2> points = contour.points();
    for (Vec2 &p : points)
        p.x() = -p.x();
    return Contour::fromPoints(points).value();
}

/// The same curve, begun at another anchor.
Contour begunAt(const Contour &contour, int anchor)
{
    std::vector<Vec2> points = contour.points();
    std::rotate(points.begin(), points.begin() + 3 * anchor, points.end());
    return Contour::fromPoints(points).value();
}

} // namespace

class TestContourBlend : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void endsAreTheContours_data();
    void endsAreTheContours();
    void offsetIsThatOfBruteForce();
    void theSameContourIsItself();
    void cornersMeetCorners();
};

void TestContourBlend::endsAreTheContours_data()
{
    QTest::addColumn<int>("p");
    QTest::addColumn<int>("q");
    const auto all = simpleContours();
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        const int other = (i * 7 + 3) % static_cast<int>(all.size());
        QTest::addRow("%s to %s", all[static_cast<std::size_t>(i)].name,
                      all[static_cast<std::size_t>(other)].name)
            << i << other;
    }
}

// Wrong: the row of sections would jump where it meets those that it was made of.
void TestContourBlend::endsAreTheContours()
{
    QFETCH(int, p);
    QFETCH(int, q);
    const auto all = simpleContours();
    const Contour &first = all[static_cast<std::size_t>(p)].contour;
    const Contour &last = all[static_cast<std::size_t>(q)].contour;
    const Correspondence best = bestCorrespondence(first, last);
    for (const Correspondence &way :
         {best, Correspondence{0.3, false}, Correspondence{0.7, true}}) {
        const ContourBlend blend(first, last, way);
        const double size = std::max(first.bounds().size().norm(), last.bounds().size().norm());
        for (const auto &[at, contour] : {std::pair(0.0, &first), std::pair(1.0, &last)}) {
            const Contour got = blend.at(at);
            // Splitting rounds, and points a kilometre away have fewer digits.
            const double rounding = 1e-9 * (size + contour->bounds().max.norm());
            QVERIFY2(distance(got, *contour) < rounding,
                     qPrintable(QString::number(distance(got, *contour))));
            QVERIFY(distance(*contour, got) < rounding);
            QVERIFY(std::abs(std::abs(got.signedArea()) - std::abs(contour->signedArea())) <
                    1e-6 * (1.0 + size * (size + contour->bounds().max.norm())));
        }
    }
}

// Wrong: the contours would be matched another way than the paper says, and twist.
void TestContourBlend::offsetIsThatOfBruteForce()
{
    std::mt19937 random(12);
    for (int round = 0; round < 12; ++round) {
        const Contour p = blob(random, 7, 40), drawn = begunAt(blob(random, 9, 45), round % 9);
        const Contour q = round % 2 == 0 ? drawn : mirrored(drawn);
        const auto ps = uniformSamples(p, kBlendSamples), qs = uniformSamples(q, kBlendSamples);
        const Correspondence found = bestCorrespondence(p, q);
        const auto sumOf = [&](int k, bool isReversed) {
            double sum = 0.0;
            for (int i = 0; i < kBlendSamples; ++i) {
                const int j = isReversed ? k - i : k + i;
                sum += (ps[static_cast<std::size_t>((j + 2 * kBlendSamples) % kBlendSamples)] -
                        qs[static_cast<std::size_t>(i)])
                           .norm();
            }
            return sum;
        };
        double least = sumOf(0, false);
        for (int k = 0; k < kBlendSamples; ++k)
            least = std::min({least, sumOf(k, false), sumOf(k, true)});
        const double share = found.isReversed ? found.offset : -found.offset;
        const int k =
            static_cast<int>(std::lround(share * kBlendSamples) + kBlendSamples) % kBlendSamples;
        QVERIFY(std::abs(sumOf(k, found.isReversed) - least) < 1e-9 * least);
    }
}

// Wrong: between two equal ribs there would be other ones.
void TestContourBlend::theSameContourIsItself()
{
    for (const NamedContour &named : simpleContours()) {
        const Contour turned = begunAt(named.contour, named.contour.segmentCount() / 2);
        const ContourBlend blend(named.contour, turned, bestCorrespondence(named.contour, turned));
        const double size = named.contour.bounds().size().norm();
        // Samples are no finer than the length over their number.
        QVERIFY2(distance(blend.at(0.5), named.contour) < 0.02 * size, named.name);
    }
}

// Wrong: halfway from a box to a box there would be eight corners.
void TestContourBlend::cornersMeetCorners()
{
    const Contour small = polygonContour(rectangleAt(-10, -10, 20, 20));
    const Contour large = polygonContour(rectangleAt(-30, -30, 60, 60));
    const ContourBlend blend(small, large, bestCorrespondence(small, large));
    const Contour half = blend.at(0.5);
    QCOMPARE(half.segmentCount(), 4);
    QVERIFY(std::abs(half.signedArea() - 1600.0) < 1e-9);
}

FFF_TEST(TestContourBlend)
#include "tst_contour_blend.moc"
