// What belongs together.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/groups.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;

class TestGroups : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsJoinedHasOneFirst();
    void noneAreNone() { QVERIFY(Groups(0).all().empty()); }
};

// The same as by writing the smaller number on all of both groups.
void TestGroups::whatIsJoinedHasOneFirst()
{
    std::mt19937 random(5);
    for (std::size_t count = 1; count < 60; ++count) {
        std::uniform_int_distribution<std::size_t> any(0, count - 1);
        Groups groups(count);
        std::vector<std::size_t> first(count);
        std::iota(first.begin(), first.end(), std::size_t(0));
        for (std::size_t joined = 0; joined < count; ++joined) {
            const std::size_t a = any(random), b = any(random);
            groups.join(a, b);
            const std::size_t from = std::max(first[a], first[b]),
                              to = std::min(first[a], first[b]);
            std::replace(first.begin(), first.end(), from, to);
            for (std::size_t i = 0; i < count; ++i)
                QCOMPARE(groups.firstOf(i), first[i]);
        }
        std::size_t before = 0, members = 0;
        for (const std::vector<std::size_t> &group : groups.all()) {
            QVERIFY(members == 0 || group.front() > before);
            QVERIFY(std::is_sorted(group.begin(), group.end()));
            QVERIFY(std::all_of(group.begin(), group.end(),
                                [&](std::size_t i) { return first[i] == group.front(); }));
            before = group.front();
            members += group.size();
        }
        QCOMPARE(members, count);
    }
}

FFF_TEST(TestGroups)
#include "tst_groups.moc"
