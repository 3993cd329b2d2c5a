#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/smallest_sink.h"
#include "tests/test_program.h"

#include <random>
#include <set>

using namespace fff;

class TestSmallestSink : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void asFoundByTryingAll();
};

// Wrong: a group that does not come off, or a larger one than need be, or another one than the
// order of the parts says.
void TestSmallestSink::asFoundByTryingAll()
{
    std::mt19937 random(9);
    for (int round = 0; round < 4000; ++round) {
        const std::size_t count = 2 + random() % 9;
        std::vector<std::vector<int>> edges(count);
        for (std::size_t i = 0; i < random() % (3 * count); ++i)
            edges[random() % count].push_back(static_cast<int>(random() % count));
        std::vector<std::size_t> weights;
        std::size_t total = 0;
        for (std::size_t i = 0; i < count; ++i)
            total += weights.emplace_back(1 + random() % 3);
        const std::size_t limit = random() % 2 == 0 ? total : 1 + random() % total;

        // What each node takes along: the smallest closed set is that of one of its nodes.
        std::set<int> best;
        std::size_t least = limit;
        for (std::size_t root = 0; root < count; ++root) {
            std::vector<int> open{static_cast<int>(root)};
            std::set<int> closed(open.begin(), open.end());
            for (std::size_t k = 0; k < open.size(); ++k)
                for (const int there : edges[static_cast<std::size_t>(open[k])])
                    if (closed.insert(there).second)
                        open.push_back(there);
            std::size_t weight = 0;
            for (const int node : closed)
                weight += weights[static_cast<std::size_t>(node)];
            if (weight < least) {
                least = weight;
                best = closed;
            }
        }

        const auto found =
            smallestSink(weights, limit, [&](int node, EdgeCursor &cursor) -> std::optional<int> {
                const std::vector<int> &own = edges[static_cast<std::size_t>(node)];
                if (cursor.first == own.size())
                    return {};
                return own[cursor.first++];
            });
        QCOMPARE(found.has_value(), !best.empty());
        if (found)
            QVERIFY(std::set<int>(found->begin(), found->end()) == best);
    }
}

FFF_TEST(TestSmallestSink)
#include "tst_smallest_sink.moc"
