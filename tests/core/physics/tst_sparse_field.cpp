// A field over fewer points says the same.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/sparse_field.h"
#include "tests/test_program.h"

#include <cmath>
#include <map>

using namespace fff;

namespace {

/// Over a rectangle of n x m squares of 1 mm, each of them two triangles, without a hole of `hole`
/// squares a side in its middle.
template <class Use, class Moved>
StressField gridField(int n, int m, int hole, Use use, Moved moved)
{
    StressField field;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) {
            const Vec2 at(i, j);
            field.points.push_back(at);
            field.use[0].push_back(static_cast<float>(use(at)));
            field.use[1].push_back(static_cast<float>(0.5 * use(at)));
            field.moved.push_back(moved(at).template cast<float>());
            field.most = std::max(field.most, field.use[0].back());
        }
    const auto isHole = [&](int i, int j) {
        return 2 * i >= n - hole && 2 * i < n + hole && 2 * j >= m - hole && 2 * j < m + hole;
    };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + n + 1;
            if (isHole(i, j))
                continue;
            field.triangles.push_back({a, a + 1, b + 1});
            field.triangles.push_back({a, b + 1, b});
        }
    return field;
}

double areaOf(const StressField &field, const std::array<int, 3> &t)
{
    const auto at = [&](int i) { return field.points[static_cast<std::size_t>(i)]; };
    const Vec2 a = at(t[1]) - at(t[0]), b = at(t[2]) - at(t[0]);
    return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

double areaOf(const StressField &field)
{
    double sum = 0.0;
    for (const auto &t : field.triangles)
        sum += areaOf(field, t);
    return sum;
}

/// Linear in the triangle that the point is in, or the nearest to it.
struct There
{
    double use = 0.0;
    Vec3 moved = Vec3::Zero();
};
There thereIn(const StressField &field, const Vec2 &point)
{
    There there;
    double best = -1e9;
    for (const auto &t : field.triangles) {
        std::array<double, 3> share;
        const auto at = [&](std::size_t k) {
            return field.points[static_cast<std::size_t>(t[k % 3])];
        };
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 a = at(k + 1) - point, b = at(k + 2) - point;
            share[k] = 0.5 * (a.x() * b.y() - a.y() * b.x()) / areaOf(field, t);
        }
        const double inside = *std::min_element(share.begin(), share.end());
        if (inside <= best)
            continue;
        best = inside;
        there = {};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(t[k]);
            there.use += share[k] * static_cast<double>(field.use[0][i]);
            there.moved += share[k] * field.moved[i].cast<double>();
        }
    }
    return there;
}

/// Each inner side is there once each way, and the boundary closes.
bool isWhole(const StressField &field)
{
    std::map<std::pair<int, int>, int> sides;
    std::map<int, int> ends;
    for (const auto &t : field.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (++sides[{t[k], t[(k + 1) % 3]}] > 1)
                return false;
    for (const auto &[side, count] : sides)
        if (!sides.count({side.second, side.first})) {
            ++ends[side.first];
            --ends[side.second];
        }
    return std::all_of(ends.begin(), ends.end(), [](const auto &end) { return end.second == 0; });
}

Vec3 still(const Vec2 &)
{
    return Vec3::Zero();
}

} // namespace

class TestSparseField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void evenNeedsItsCornersOnly();
    void saysTheSame_data();
    void saysTheSame();
    void nastyOnes();
};

void TestSparseField::evenNeedsItsCornersOnly()
{
    const StressField field = gridField(
        30, 20, 0, [](const Vec2 &) { return 0.4; }, still);
    const StressField sparse = sparseField(field);
    QVERIFY(isWhole(sparse));
    QVERIFY2(sparse.points.size() <= 12, qPrintable(QString::number(sparse.points.size())));
    QVERIFY(std::abs(areaOf(sparse) - 600.0) < 1e-9);
    QCOMPARE(sparse.most, field.most);
}

void TestSparseField::saysTheSame_data()
{
    QTest::addColumn<int>("hole");
    QTest::addColumn<double>("peak");
    QTest::newRow("a gentle hill") << 0 << 0.6;
    QTest::newRow("more than all in the middle") << 0 << 3.0;
    QTest::newRow("round a hole") << 6 << 0.9;
}

// Wrong: a colour or a place that is farther from the field's than it may be, a triangle that is
// turned over, or a hole that is filled.
void TestSparseField::saysTheSame()
{
    QFETCH(int, hole);
    QFETCH(double, peak);
    const Vec2 middle(25.0, 15.0);
    const StressField field = gridField(
        50, 30, hole,
        [&](const Vec2 &at) { return peak * std::exp(-(at - middle).squaredNorm() / 60.0); },
        [](const Vec2 &at) { return Vec3(0.02 * at.y(), 0.0, 0.004 * at.x() * at.x()); });
    const SparseLimits limits;
    const StressField sparse = sparseField(field, limits);
    QVERIFY(isWhole(sparse));
    QVERIFY2(3 * sparse.points.size() < 2 * field.points.size(),
             qPrintable(QString::number(sparse.points.size())));
    QVERIFY(std::abs(areaOf(sparse) / areaOf(field) - 1.0) < 1e-9);
    for (const auto &t : sparse.triangles)
        QVERIFY(areaOf(sparse, t) > 0.0);
    const double way = Vec3(0.6, 0.0, 10.0).norm();
    const auto told = [](double use) { return std::min(use, SparseLimits::kMostTold); };
    for (std::size_t i = 0; i < field.points.size(); ++i) {
        const auto isOfHole = [&](const Vec2 &at) {
            const Vec2 off = (at - middle).cwiseAbs();
            return 2.0 * off.x() < hole && 2.0 * off.y() < hole;
        };
        if (isOfHole(field.points[i]))
            continue;
        const There there = thereIn(sparse, field.points[i]);
        // Between points that tell of more than all there is nothing to be told.
        if (field.use[0][i] < 1.0f)
            QVERIFY(std::abs(told(there.use) - told(static_cast<double>(field.use[0][i]))) <
                    limits.use * 1.001);
        else
            QVERIFY(there.use > 1.0 - limits.use);
        QVERIFY((there.moved - field.moved[i].cast<double>()).norm() <
                1.75 * limits.movedShare * way);
    }
}

void TestSparseField::nastyOnes()
{
    QVERIFY(sparseField(StressField()).points.empty());
    // One triangle, and two that meet in one point.
    StressField field;
    field.points = {{0, 0}, {4, 0}, {0, 4}, {-4, 0}, {0, -4}};
    field.triangles = {{0, 1, 2}, {0, 3, 4}};
    field.use = {std::vector<float>(5, 0.3f), std::vector<float>(5, 0.3f)};
    field.moved.assign(5, Eigen::Vector3f::Zero());
    const StressField two = sparseField(field);
    QCOMPARE(two.triangles.size(), std::size_t(2));
    field.triangles.pop_back();
    QCOMPARE(sparseField(field).triangles.size(), std::size_t(1));
    QCOMPARE(sparseField(field).points.size(), std::size_t(3));
    // A strip one triangle wide keeps its width.
    const StressField strip = gridField(
        40, 1, 0, [](const Vec2 &) { return 0.2; }, still);
    const StressField sparse = sparseField(strip);
    QVERIFY(isWhole(sparse) && std::abs(areaOf(sparse) - 40.0) < 1e-9);
    QVERIFY(sparse.points.size() < strip.points.size());
}

FFF_TEST(TestSparseField)
#include "tst_sparse_field.moc"
