#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/box_tree.h"
#include "core/geometry/cells.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <random>
#include <set>

using namespace fff;

namespace {

using Random = std::mt19937;

double between(Random &random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// About the origin, in and out, with holes in it.
Region spiky(Random &random)
{
    Region region;
    const int count = 40 + static_cast<int>(random() % 300);
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        const double r = between(random, 60.0, 150.0);
        region.outer.push_back(r * Vec2(std::cos(angle), std::sin(angle)));
    }
    for (int i = 0; i < 12; ++i) {
        Polygon hole;
        const double angle = 2.0 * std::numbers::pi * i / 12, size = between(random, 1.0, 4.0);
        const Vec2 middle = 25.0 * Vec2(std::cos(angle), std::sin(angle));
        for (int k = 0; k < 9; ++k)
            hole.push_back(middle + size * Vec2(std::cos(-0.69 * k), std::sin(-0.69 * k)));
        region.holes.push_back(std::move(hole));
    }
    return region;
}

/// A bar with slits, all the way.
Region slitBar(int slits, int moved = -1)
{
    Region region{{{0, 0}, {10.0 * (slits + 1), 0}, {10.0 * (slits + 1), 40}}, {}};
    for (int i = slits; i > 0; --i) {
        const double at = 10.0 * i + (i == moved ? 0.4 : 0.0);
        region.outer.insert(region.outer.end(),
                            {{at + 1.5, 40}, {at + 1.5, 20}, {at - 1.5, 20}, {at - 1.5, 40}});
    }
    region.outer.push_back({0, 40});
    return region;
}

std::size_t vertices(const Region &region)
{
    std::size_t count = region.outer.size();
    for (const Polygon &hole : region.holes)
        count += hole.size();
    return count;
}

double areaOf(const Triangulation &triangles)
{
    double sum = 0.0;
    for (const auto &t : triangles.triangles) {
        const auto at = [&](int i) {
            return triangles.points[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
        };
        sum += 0.5 * cross(Vec2(at(1) - at(0)), Vec2(at(2) - at(0)));
    }
    return sum;
}

} // namespace

class TestCells : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cellsMakeUpTheRegion();
    void anEditChangesFewCells();
    void aTreeFindsWhatAllBoxesTell();
};

// Wrong: a piece of a part is missing or there twice, so that another one may go through it.
void TestCells::cellsMakeUpTheRegion()
{
    Random random(3);
    for (int i = 0; i < 60; ++i) {
        const Region region = spiky(random);
        const std::vector<Region> cells = cellsOf(region);
        QVERIFY(cells.size() > 3);
        for (int k = 0; k < 200; ++k) {
            const Vec2 point(between(random, -150, 150), between(random, -150, 150));
            const Side side = locate(point, region);
            const auto inside = std::count_if(cells.begin(), cells.end(), [&](const Region &cell) {
                return locate(point, cell) == Side::Inside;
            });
            QCOMPARE(inside, side == Side::Inside ? 1 : 0);
        }
        QVERIFY(std::abs(areaOf(*triangulateCells(region)) - area(region)) < 1e-6 * area(region));
    }
}

// Wrong: a slit that is moved at one end of a long spine has all of it worked out anew.
void TestCells::anEditChangesFewCells()
{
    const std::vector<Region> before = cellsOf(slitBar(800)), after = cellsOf(slitBar(800, 123));
    QCOMPARE(before.size(), after.size());
    int changed = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        QVERIFY(vertices(before[i]) <= 40);
        changed += before[i].outer != after[i].outer;
    }
    QVERIFY(changed >= 1 && changed <= 2);
}

// Wrong: what is in the way of a part is not found.
void TestCells::aTreeFindsWhatAllBoxesTell()
{
    Random random(4);
    std::vector<Box3> boxes;
    for (int i = 0; i < 300; ++i) {
        Box3 box;
        const Vec3 corner(between(random, 0, 100), between(random, 0, 100),
                          between(random, 0, 100));
        box.extend(corner);
        box.extend(Vec3(corner + Vec3(between(random, 0, 20), between(random, 0, 20), 1.0)));
        boxes.push_back(box);
    }
    const BoxTree tree(boxes);
    for (const Box3 &asked : boxes) {
        std::set<int> found, all;
        tree.any([&](const Box3 &box) { return box.intersects(asked); },
                 [&](int index) {
                     found.insert(index);
                     return false;
                 });
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].intersects(asked))
                all.insert(static_cast<int>(i));
        QVERIFY(found == all);
    }
    QVERIFY(!BoxTree().any([](const Box3 &) { return true; }, [](int) { return true; }));
}

FFF_TEST(TestCells)
#include "tst_cells.moc"
