#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/operation_edits.h"
#include "core/operations/evaluate.h"
#include "core/operations/operation_kind.h"
#include "core/session/kept_models.h"
#include "tests/bench/counted_memory.h"
#include "tests/bench/generated_models.h"
#include "tests/core/session/random_edits.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// The same objects, drawn and generated.
bool isSameModel(const Model &a, const Model &b)
{
    return a.document.isSame(b.document) && a.document.nextId == b.document.nextId &&
           a.sections() == b.sections();
}

/// The same drawn objects, and generated ones of the same values.
QString differenceOf(const Model &a, const Model &b)
{
    if (!a.document.isSame(b.document))
        return QStringLiteral("another document");
    if (a.sectionCount() != b.sectionCount())
        return QStringLiteral("%1 and %2 sections").arg(a.sectionCount()).arg(b.sectionCount());
    for (std::size_t i = 0; i < a.sectionCount(); ++i)
        if (!(*a.section(i) == *b.section(i)))
            return QStringLiteral("section %1").arg(i);
    return {};
}

Document moved(const Document &document, SectionId id, const Vec3 &way)
{
    Frame frame = document.find(id)->frame;
    frame.origin += way;
    return *moveSection(document, id, frame);
}

/// A spine, a rib, and one operation of each kind that makes what it makes of them.
Document withOperation(const char *kind)
{
    if (kind == std::string("linear branches"))
        return bench::repeated("linear", true, true);
    if (kind == std::string("linear scaled"))
        return bench::repeated("linear", true, false);
    if (kind == std::string("revolve scaled"))
        return bench::repeated("revolve", true, false);
    Document document = bench::repeated("linear", false, false);
    if (kind == std::string("linear"))
        return document;
    Operation operation = newOperation(*operationKind(kind));
    for (const InputSpec &input : operationKind(kind)->inputs)
        for (const std::size_t at : {1u, 0u})
            if (std::ssize(operation.inputs[input.role]) < input.least)
                operation.inputs[input.role].push_back(
                    {SectionRef(document.sections[operation.inputs.size() > 1 ? 0 : at]->id), {}});
    if (operation.parameters.contains("count"))
        operation.parameters["count"] = 40.0;
    document = *removeOperation(document, document.operations.front()->id);
    return addOperation(std::move(document), std::move(operation));
}

/// Edits of what operations read, of their numbers and exceptions, at random.
class OperationEdits
{
public:
    explicit OperationEdits(unsigned seed) : m_random(seed) {}

    Document next(const Document &document)
    {
        const auto &operation =
            *document.operations[static_cast<std::size_t>(below(std::ssize(document.operations)))];
        const SectionId id =
            document.sections[static_cast<std::size_t>(below(std::ssize(document.sections)))]->id;
        Operation other = operation;
        switch (below(8)) {
        case 0:
            other.parameters["count"] = 2.0 + below(30);
            return *setOperation(document, other);
        case 1:
            other.isOn = !other.isOn;
            return *setOperation(document, other);
        case 2:
            other.parameters["strength"] = 0.1 * below(10);
            return *setOperation(document, other);
        case 3:
            return *setException(
                document, {operation.id, std::to_string(1 + below(5))},
                {below(2) == 0 ? Exception::State::Hidden : Exception::State::Made});
        case 4: {
            const Shape &shape = *document.find(id)->shape;
            const auto next = movedPoint(shape, {0, below(shape.contour().segmentCount())},
                                         position(shape, {0, 0}) + Vec2(0.0, 0.1 * below(9)));
            return next ? *setShape(document, id, *next) : moved(document, id, {0.1, 0, 0});
        }
        case 5:
            return *renameSection(document, id, "renamed " + std::to_string(below(100)));
        default:
            return moved(document, id, {0.1 * below(100) - 5.0, 0.01 * below(100), 0});
        }
    }

    int below(std::ptrdiff_t limit)
    {
        return std::uniform_int_distribution<int>(0, static_cast<int>(limit) - 1)(m_random);
    }

private:
    std::mt19937 m_random;
};

} // namespace

class TestHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tenThousandEditsAndBack();
    void generatedSectionsAreNoneOfAStep_data();
    void generatedSectionsAreNoneOfAStep();
    void operationsComeBackAsTheyWere_data();
    void operationsComeBackAsTheyWere();
    void theLastStepsAreTheVeryObjects();
    void tenThousandEditsUnderARow();
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
            16 * (document.sections.size() + document.stocks.size() + document.loads.size()));
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

void TestHistory::generatedSectionsAreNoneOfAStep_data()
{
    QTest::addColumn<QByteArray>("kind");
    for (const char *kind : {"linear", "linear scaled", "linear branches", "revolve",
                             "revolve scaled", "branch", "radial", "mirror", "rotational", "array"})
        QTest::newRow(kind) << QByteArray(kind);
}

// Wrong: a step under a row would keep all of its ribs: 400 kB under fifty of their own sizes.
void TestHistory::generatedSectionsAreNoneOfAStep()
{
    QFETCH(QByteArray, kind);
    Session session;
    session.reset(withOperation(kind.constData()));
    QVERIFY(session.committed().evaluation.listing); // it makes something
    const SectionId rib = session.committed().document.sections[1]->id;
    const Document start = session.committed().document;
    int steps = 0;
    const auto edit = [&](int count) {
        for (int i = 0; i < count; ++i)
            session.commit(QStringLiteral("Edit"), moved(start, rib, {0.01 * ++steps, 0, 0}));
        session.currentAnalysis();
    };
    edit(300); // as much as is kept of the last ones is there
    const std::int64_t before = bench::liveBytesOfAll();
    constexpr int kSteps = 1000; // so many that one model more or less in the caches does not count
    edit(kSteps);
    const std::int64_t grown = (bench::liveBytesOfAll() - before) / kSteps;
    QVERIFY2(grown < 4'000, qPrintable(QString::number(grown)));
}

void TestHistory::operationsComeBackAsTheyWere_data()
{
    generatedSectionsAreNoneOfAStep_data();
}

// Wrong: undo would give another model than the one that was there, or lose an exception.
void TestHistory::operationsComeBackAsTheyWere()
{
    QFETCH(QByteArray, kind);
    constexpr int kEdits = 100; // of each kind, more than a thousand in all
    Session session;
    OperationEdits edits(7);
    session.reset(withOperation(kind.constData()));
    std::vector<Document> documents{session.committed().document};
    while (session.history()->count() < kEdits) {
        session.commit(QStringLiteral("Edit"), edits.next(session.committed().document));
        if (std::ssize(documents) == session.history()->count())
            documents.push_back(session.committed().document);
    }
    for (int i = 0; i < 2 * kEdits; ++i) {
        const int to = i < kEdits ? kEdits - i - 1 : edits.below(kEdits + 1);
        session.history()->setIndex(to);
        const QString wrong =
            differenceOf(session.committed(), evaluate(documents[static_cast<std::size_t>(to)]));
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("step %1: %2").arg(to).arg(wrong)));
        QCOMPARE(&session.model(), &session.committed());
    }
}

// Wrong: every undo and redo would cut and draw the whole row anew.
void TestHistory::theLastStepsAreTheVeryObjects()
{
    Session session;
    session.reset(bench::repeated("linear", true, false));
    const Document start = session.committed().document;
    std::vector<std::vector<SectionPointer>> sections{session.committed().sections()};
    for (int i = 1; i <= 3; ++i) {
        session.commit(QStringLiteral("Edit"),
                       moved(start, start.sections[1]->id, {0.1 * i, 0, 0}));
        sections.push_back(session.committed().sections());
    }
    for (const int to : {2, 1, 0, 3, 1, 2}) {
        session.history()->setIndex(to);
        QVERIFY(session.committed().sections() == sections[static_cast<std::size_t>(to)]);
    }
    // What is asked for about a step is not what is shown, and is an equal one, too.
    QVERIFY(session.modelAfter(0)->sections() == sections[0]);
    QVERIFY(!session.modelAfter(4) && !session.modelAfter(-1));
}

// Wrong: a long day under operations would fill the memory, with models, cuts or verdicts.
void TestHistory::tenThousandEditsUnderARow()
{
    constexpr int kEdits = 10000;
    Session session;
    session.reset(bench::repeated("linear", true, false));
    OperationEdits edits(11);
    const std::int64_t before = bench::liveBytesOfAll();
    while (session.history()->count() < kEdits)
        session.commit(QStringLiteral("Edit"), edits.next(session.committed().document));
    session.currentAnalysis();
    const std::int64_t grown = bench::liveBytesOfAll() - before;
    // Every eighth edit has a shape of its own; the models and cuts of the last ones are there.
    constexpr std::int64_t kPerStep = 4'000, kKept = KeptModels::kRoom + CutCache::kRoom;
    QVERIFY2(grown < kEdits * kPerStep + kKept, qPrintable(QString::number(grown)));
}

FFF_TEST(TestHistory)
#include "tst_history.moc"
