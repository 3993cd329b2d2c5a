// The nearest point that is left. If this fails, tools travel farther than they need to.
#include "core/geometry/point_tree.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>
#include <set>

using namespace fff;

class TestPointTree : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isTheNearestThatIsLeft_data();
    void isTheNearestThatIsLeft();
    void withoutPoints();
};

void TestPointTree::isTheNearestThatIsLeft_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("grid"); // mm, that points lie on: many are alike
    QTest::newRow("one") << 1 << 0.0;
    QTest::newRow("a few") << 9 << 0.0;
    QTest::newRow("many") << 700 << 0.0;
    QTest::newRow("on a grid, many in one place") << 700 << 20.0;
    QTest::newRow("all in one place") << 100 << 1000.0;
}

void TestPointTree::isTheNearestThatIsLeft()
{
    QFETCH(int, count);
    QFETCH(double, grid);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> anywhere(-100.0, 100.0);
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        Vec2 p(anywhere(random), anywhere(random));
        if (grid > 0.0)
            p = ((p / grid).array().round() * grid).matrix();
        points.push_back(p);
    }
    PointTree tree(points);
    std::set<int> left;
    for (int i = 0; i < count; ++i)
        left.insert(i);
    while (!left.empty()) {
        const Vec2 at(anywhere(random), anywhere(random));
        int best = -1;
        for (const int i : left)
            if (best < 0 || (points[static_cast<std::size_t>(i)] - at).squaredNorm() <
                                (points[static_cast<std::size_t>(best)] - at).squaredNorm())
                best = i;
        QCOMPARE(tree.nearest(at), best);
        const int taken = left.size() % 3 == 0 ? *left.begin() : best;
        tree.remove(taken);
        left.erase(taken);
    }
    QCOMPARE(tree.nearest(Vec2::Zero()), -1);
}

void TestPointTree::withoutPoints()
{
    QCOMPARE(PointTree({}).nearest(Vec2::Zero()), -1);
}

FFF_TEST(TestPointTree)
#include "tst_point_tree.moc"
