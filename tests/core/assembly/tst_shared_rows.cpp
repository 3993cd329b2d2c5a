#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/shared_rows.h"
#include "tests/test_program.h"

#include <algorithm>
#include <numeric>
#include <random>

using namespace fff;

namespace {

/// A list, and what has to be in it.
struct RowsAndCopy
{
    SharedRows<int> list = {};
    std::vector<std::vector<int>> rows = {};

    bool isSame() const
    {
        return list.size() == rows.size() &&
               std::equal(list.begin(), list.end(), rows.begin(), rows.end());
    }
};

} // namespace

class TestSharedRows : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void copiesKeepWhatTheyHad();
    void rowsThatStayAreShared();
    void blocksThatAreSharedAreTheSame();
};

// Wrong: an edit would change the slits of the model before it, which undo goes back to.
void TestSharedRows::copiesKeepWhatTheyHad()
{
    std::mt19937 random(9);
    const auto below = [&](std::size_t limit) {
        return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
    };
    std::vector<RowsAndCopy> all(1);
    for (int step = 0; step < 300; ++step) {
        RowsAndCopy next = all[below(all.size())];
        if (next.rows.empty() || below(3) == 0) {
            const std::size_t size = below(70);
            next.list.resize(size);
            next.rows.resize(size);
        }
        {
            SharedRows<int>::Editor editor(next.list);
            for (std::size_t count = next.rows.empty() ? 0 : below(6); count > 0; --count) {
                const std::size_t index = below(next.rows.size()); // in any order
                next.rows[index].assign(below(4), step);
                editor.set(index, next.rows[index]);
            }
        }
        all.push_back(std::move(next));
        for (const RowsAndCopy &kept : all)
            QVERIFY(kept.isSame());
    }
}

// Wrong: whoever compares addresses would take all of a model for changed.
void TestSharedRows::rowsThatStayAreShared()
{
    SharedRows<int> before;
    before.resize(50);
    {
        SharedRows<int>::Editor editor(before);
        for (std::size_t i = 0; i < 50; ++i)
            editor.set(i, {static_cast<int>(i)});
    }
    SharedRows<int> after = before;
    SharedRows<int>::Editor(after).set(20, {-1});
    for (std::size_t i = 0; i < 50; ++i)
        QCOMPARE(after.pointer(i) == before.pointer(i), i != 20);
    QVERIFY(!(after == before));
    SharedRows<int>::Editor(after).set(20, {20});
    QVERIFY(after == before);
}

// Wrong: what was edited within a block would be taken for what it was; or never for that, and all
// of a model be looked at after each edit.
void TestSharedRows::blocksThatAreSharedAreTheSame()
{
    std::vector<int> numbers(70);
    std::iota(numbers.begin(), numbers.end(), 0);
    const SharedList<int> before(numbers);
    QVERIFY(std::equal(before.begin(), before.end(), numbers.begin(), numbers.end()));
    QCOMPARE(before.endOf(0), SharedList<int>::kInBlock);
    QCOMPARE(before.endOf(before.blockCount() - 1), std::size_t(70));
    const auto shared = [&](const SharedList<int> &list) {
        std::size_t count = 0;
        for (std::size_t block = 0; block < list.blockCount(); ++block) {
            if (!list.shares(before, block))
                continue;
            ++count;
            for (std::size_t i = block * SharedList<int>::kInBlock; i < list.endOf(block); ++i)
                if (list.endOf(block) != before.endOf(block) || list[i] != before[i])
                    return std::size_t(0);
        }
        return count;
    };
    for (const std::size_t index : {0U, 15U, 16U, 69U}) {
        SharedList<int> after = before;
        SharedList<int>::Editor(after).set(index, -1);
        QCOMPARE(after[index], -1);
        QCOMPARE(before[index], static_cast<int>(index));
        QCOMPARE(shared(after), before.blockCount() - 1);
    }
    for (const std::size_t size : {0U, 1U, 16U, 17U, 64U, 65U, 69U, 71U, 200U}) {
        SharedList<int> after = before;
        after.resize(size, 7);
        QCOMPARE(after.size(), size);
        QCOMPARE(shared(after), std::min(size, before.size()) / SharedList<int>::kInBlock);
    }
}

FFF_TEST(TestSharedRows)
#include "tst_shared_rows.moc"
