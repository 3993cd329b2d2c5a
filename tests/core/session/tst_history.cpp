#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/bench/counted_memory.h"
#include "tests/core/session/random_edits.h"

using namespace fff;
using namespace fff::test;

namespace {

/// The same objects, drawn and generated.
bool isSameModel(const Model &a, const Model &b)
{
    return a.document.isSame(b.document) && a.document.nextId == b.document.nextId &&
           a.sections() == b.sections();
}

} // namespace

class TestHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tenThousandEditsAndBack();
};

// Wrong: a long day's undo loses or changes something, has an end, or fills the memory.
void TestHistory::tenThousandEditsAndBack()
{
    constexpr int kEdits = 10000;
    Session session;
    QCOMPARE(session.history()->undoLimit(), 0);
    RandomEdits edits(20140505);
    Document start = newDocument();
    for (int i = 0; i < 6; ++i)
        start = edits.next(start);
    session.reset(start);
    const Model first = session.committed();

    const std::int64_t before = bench::liveBytes();
    std::int64_t lists = 0; // what the steps' lists of pointers take
    while (session.history()->count() < kEdits) {
        session.commit(QStringLiteral("Edit"), edits.next(session.committed().document));
        const Document &document = session.committed().document;
        lists += static_cast<std::int64_t>(
            16 * (document.sections.size() + document.stocks.size() + document.weights.size()));
    }
    const Model last = session.committed();
    const std::int64_t grown = bench::liveBytes() - before;
    // Besides the lists a step keeps the model, the command, its text, and what changed: an object
    // or two, at most a shape of a dozen segments with all that is worked out of it.
    constexpr std::int64_t kPerStep = 4'000;
    QVERIFY2(grown < lists + kEdits * kPerStep, qPrintable(QString::number(grown / kEdits)));
    QVERIFY2(grown > lists, qPrintable(QString::number(grown / kEdits))); // or it is not counted

    const auto all = [&](auto step) {
        for (int i = 0; i < kEdits; ++i)
            (session.history()->*step)();
    };
    all(&QUndoStack::undo);
    QVERIFY(!session.history()->canUndo());
    QVERIFY(isSameModel(session.committed(), first));
    QVERIFY(isSameModel(session.model(), first));
    session.currentAnalysis(); // the worker has done; what it gave away is here
    const std::int64_t rested = bench::liveBytes();

    all(&QUndoStack::redo);
    QVERIFY(!session.history()->canRedo());
    QVERIFY(isSameModel(session.committed(), last));
    session.history()->undo();
    session.history()->redo();
    QVERIFY(isSameModel(session.committed(), last));

    // There and back again keeps nothing: flat but for one analysis more or less.
    session.history()->setIndex(0);
    QVERIFY(isSameModel(session.committed(), first));
    session.currentAnalysis();
    constexpr std::int64_t kFlat = 2'000'000;
    const std::int64_t after = bench::liveBytes();
    QVERIFY2(after - rested < kFlat, qPrintable(QString::number(after - rested)));
}

QTEST_GUILESS_MAIN(TestHistory)
#include "tst_history.moc"
