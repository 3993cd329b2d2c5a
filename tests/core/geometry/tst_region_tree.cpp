#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/region_tree.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// A comb of so many teeth with a triangular hole in each tooth: many corners at one height.
Region combOf(int teeth)
{
    Region region;
    region.outer = {{0, 0}, {4.0 * teeth, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double x = 4.0 * i;
        for (const Vec2 &p : {Vec2(x + 4, 10), Vec2(x + 1, 10), Vec2(x + 1, 5), Vec2(x, 5)})
            region.outer.push_back(p);
        region.holes.push_back({{x + 2, 6}, {x + 2.5, 8}, {x + 3, 6}});
    }
    return region;
}

std::vector<Region> regions()
{
    std::mt19937 random(5);
    std::vector<Region> all{{}, {rectangleAt(0, 0, 10, 10), {rectangleAt(4, 4, 2, 2)}}, combOf(40)};
    for (const int count : {3, 9, 60})
        all.push_back({blob(random, count, 40).flatten(0.05).points, {}});
    return all;
}

bool isApart(const std::pair<Vec2, Vec2> &edge, const Box2 &box)
{
    Box2 own;
    own.extend(edge.first);
    own.extend(edge.second);
    return (own.min.array() > box.max.array()).any() || (own.max.array() < box.min.array()).any();
}

} // namespace

class TestRegionTree : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void locatesAsTheRegionItself();
    void visitsWhatIsNear();
    void visitsLittleElse();
};

// Wrong: walls of slits would be hidden where nothing fills them.
void TestRegionTree::locatesAsTheRegionItself()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-50, 170);
    for (const Region &region : regions()) {
        const RegionTree tree(region);
        const auto same = [&](const Vec2 &p) { return tree.locate(p) == locate(p, region); };
        for (int i = 0; i < 2000; ++i) {
            const Vec2 p(place(random), 0.3 * place(random));
            QVERIFY(same(p));
            QVERIFY(same({std::round(p.x()), std::round(p.y())})); // level with corners
        }
        std::vector<Polygon> rings = region.holes;
        rings.push_back(region.outer);
        for (const Polygon &ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                QVERIFY(tree.locate(ring[i]) == Side::Boundary);
                QVERIFY(same(0.5 * (ring[i] + ring[(i + 1) % ring.size()])));
            }
    }
}

// Wrong: an edge that comes into a slit would not be seen there.
void TestRegionTree::visitsWhatIsNear()
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> place(-50, 170);
    using Edge = std::pair<Vec2, Vec2>;
    for (const Region &region : regions()) {
        const RegionTree tree(region);
        std::vector<Edge> all;
        const auto addEdges = [&](const Polygon &ring) {
            for (std::size_t i = 0; i < ring.size(); ++i)
                all.push_back({ring[(i > 0 ? i : ring.size()) - 1], ring[i]});
        };
        addEdges(region.outer);
        for (const Polygon &hole : region.holes)
            addEdges(hole);
        for (int i = 0; i < 200; ++i) {
            Box2 box;
            for (int k = 0; k < 2; ++k)
                box.extend(Vec2(place(random), 0.3 * place(random)));
            std::size_t next = 0; // of all, in their order
            tree.visitNear(box, [&](const Vec2 &a, const Vec2 &b) {
                for (; next < all.size() && all[next] != Edge(a, b); ++next)
                    QVERIFY(isApart(all[next], box));
                QVERIFY(next < all.size()); // each once
                ++next;
            });
            for (; next < all.size(); ++next)
                QVERIFY(isApart(all[next], box));
        }
    }
}

// Wrong: a spine with thousands of ribs would cost its whole boundary for each of them.
void TestRegionTree::visitsLittleElse()
{
    const Region region{combOf(2000).outer, {}};
    const RegionTree tree(region);
    Box2 box;
    box.extend(Vec2(4001, 4));
    box.extend(Vec2(4004, 6));
    int visited = 0;
    tree.visitNear(box, [&](const Vec2 &, const Vec2 &) { ++visited; });
    QVERIFY(visited > 2 && visited <= 32);
}

FFF_TEST(TestRegionTree)
#include "tst_region_tree.moc"
