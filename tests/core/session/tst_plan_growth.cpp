// What planning costs as models grow, counted and not timed: pairs of solids that are looked at.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/plan_checks.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "tests/bench/generated_models.h"
#include "tests/core/assembly/plan_replay.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

using Verdict = AssemblyPlan::Verdict;

/// Along its plane and across it, so that its mates' slits move, too.
Document moved(const Document &document, std::size_t index, double along, double across)
{
    const Section &section = *document.sections[index];
    Frame frame = section.frame;
    frame.origin += along * frame.x + across * frame.normal();
    return *moveSection(document, section.id, frame);
}

std::size_t lengthOfSteps(const AssemblyPlan &plan)
{
    std::size_t length = 0;
    for (const AssemblyStep &step : plan.steps)
        length += step.parts.size();
    return length;
}

} // namespace

class TestPlanGrowth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void simpleModelsOfAnySizeAreDecided_data();
    void simpleModelsOfAnySizeAreDecided();
    void anEditCostsItsSurroundings_data();
    void anEditCostsItsSurroundings();
    void plansCanBeCarriedOut_data();
    void plansCanBeCarriedOut();
    void editsOfLongPartsChangeNothingElse();
    void theTimeIsKept();
    void theTimeIsKeptWhereverItEnds_data();
    void theTimeIsKeptWhereverItEnds();
    void whatHoldsIsFoundAtOnce();
};

void TestPlanGrowth::simpleModelsOfAnySizeAreDecided_data()
{
    QTest::addColumn<Document>("document");
    for (const int sections : {200, 800, 3200})
        QTest::addRow("a comb of %d", sections) << bench::comb(sections);
    for (const int strips : {25, 50, 100})
        QTest::addRow("a lattice of %d by %d", strips, strips) << bench::lattice(strips);
    QTest::newRow("crates") << bench::crates(40, 10);
}

// Wrong: planning looks at pairs that have nothing to do with each other, or at all of a long part
// for each of its mates, so that its cost is the square of the parts.
void TestPlanGrowth::simpleModelsOfAnySizeAreDecided()
{
    QFETCH(Document, document);
    AnalysisCaches analyses;
    PlanCaches caches;
    const Analysis analysis = analyse(evaluate(document), analyses);
    const ModelPlan plan = planOf(analysis, caches);
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::Possible));
    QVERIFY(plan.overlaps.empty());
    QCOMPARE(plan.plan.steps.size(), plan.bodies.size()); // one by one
    QCOMPARE(lengthOfSteps(plan.plan), plan.bodies.size());
    // Of each joint: as they are, out of the slits, and how far. Of each part a few beside it.
    const Collisions::Work &work = caches.collisions.work();
    const std::size_t joints = analysis.assembly.joints.size(), parts = plan.bodies.size();
    QVERIFY2(work.encounters <= 4 * (joints + parts),
             QByteArray::number(qulonglong(work.encounters)));
    QVERIFY2(work.prismPairs <= 60 * joints, QByteArray::number(qulonglong(work.prismPairs)));
}

void TestPlanGrowth::anEditCostsItsSurroundings_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<int>("edited");
    QTest::addColumn<int>("mates");
    for (const int sections : {200, 800, 3200})
        QTest::addRow("a rib of %d", sections) << bench::comb(sections) << sections / 2 << 1;
    for (const int strips : {25, 50, 100})
        QTest::addRow("a strip of %d", strips) << bench::lattice(strips) << strips / 2 << strips;
}

// Wrong: after one rib is moved, all ribs of its spine are worked out again, since the spine is
// another one.
void TestPlanGrowth::anEditCostsItsSurroundings()
{
    QFETCH(Document, document);
    QFETCH(int, edited);
    QFETCH(int, mates);
    AnalysisCaches analyses;
    PlanCaches caches;
    planOf(*analyseNext(evaluate(document), analyses), caches);
    const std::size_t before = caches.collisions.work().answers;
    const Document next = moved(document, static_cast<std::size_t>(edited), 0.3, 0.3);
    const ModelPlan plan = planOf(*analyseNext(evaluate(next), analyses), caches);
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::Possible));
    const std::size_t answers = caches.collisions.work().answers - before;
    // The slits beside the one that has moved are cut out of what is near it.
    QVERIFY2(answers <= 30u * static_cast<std::size_t>(mates) + 30u,
             QByteArray::number(qulonglong(answers)));
}

void TestPlanGrowth::plansCanBeCarriedOut_data()
{
    QTest::addColumn<Document>("document");
    QTest::newRow("a comb") << bench::comb(90);
    QTest::newRow("a lattice") << bench::lattice(9);
    QTest::newRow("a lattice and a short strip") << bench::latticeWithShort(9);
    QTest::newRow("crates") << bench::crates(10, 5);
}

// Wrong: a part goes through another one, since a cell of a long part was not looked at.
void TestPlanGrowth::plansCanBeCarriedOut()
{
    QFETCH(Document, document);
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(document), caches);
    const ModelPlan plan = planOf(analysis);
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::Possible));
    const QString wrong = fault(analysis, plan);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

// Wrong: an answer is kept though what it was about has changed. Parts are long enough to be cut
// into cells, and some edits put them into each other.
void TestPlanGrowth::editsOfLongPartsChangeNothingElse()
{
    std::mt19937 random(5);
    const auto below = [&](std::size_t limit) {
        return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
    };
    const auto number = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
    Document document = bench::comb(90);
    AnalysisCaches analyses;
    PlanCaches caches;
    std::size_t overlaps = 0;
    for (int i = 0; i < 120; ++i) {
        const std::size_t count = document.sections.size();
        const std::size_t index = below(8) == 0 ? 0 : below(count);
        if (i % 10 == 9 && index > 0)
            document = *removeSections(document, std::vector{document.sections[index]->id});
        else
            document = moved(document, index, 2.0 * number(), 6.0 * number());
        const AnalysisPointer analysis = analyseNext(evaluate(document), analyses);
        const ModelPlan kept = planOf(*analysis, caches), anew = planOf(*analysis);
        QCOMPARE(static_cast<int>(kept.plan.verdict), static_cast<int>(anew.plan.verdict));
        QCOMPARE(kept.plan.locked, anew.plan.locked);
        QVERIFY(kept.plan.steps == anew.plan.steps);
        QCOMPARE(kept.overlaps.size(), anew.overlaps.size());
        for (std::size_t k = 0; k < kept.overlaps.size(); ++k) {
            QVERIFY(kept.overlaps[k].how.depth == anew.overlaps[k].how.depth);
            QVERIFY(kept.overlaps[k].how.at == anew.overlaps[k].how.at);
        }
        overlaps += kept.overlaps.size();
    }
    QVERIFY(overlaps > 0);
}

// Wrong: a large model goes on being planned after the time is over.
void TestPlanGrowth::theTimeIsKept()
{
    AnalysisCaches analyses;
    const Analysis analysis = analyse(evaluate(bench::lattice(30)), analyses);
    PlanCaches caches;
    std::size_t whenOver = 0;
    int asked = 0;
    const ModelPlan plan = planOf(analysis, caches, [&] {
        if (++asked == 100)
            whenOver = caches.collisions.work().encounters;
        return asked >= 100;
    });
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::NotFound));
    QVERIFY(plan.plan.steps.empty() && plan.plan.locked.empty());
    QVERIFY(caches.collisions.work().encounters <= whenOver + 1);
    // Asked again without a limit, what was left unsaid is found out.
    QCOMPARE(static_cast<int>(planOf(analysis, caches).plan.verdict),
             static_cast<int>(Verdict::Possible));
}

void TestPlanGrowth::theTimeIsKeptWhereverItEnds_data()
{
    QTest::addColumn<int>("asked"); // before it is over
    QTest::newRow("at once") << 0;
    QTest::newRow("while solids are made") << 30;
    QTest::newRow("while overlaps are looked for") << 500;
    QTest::newRow("while parts are taken off") << 1000;
}

// Wrong: solids are made, or overlaps looked for, after the time is over; or what was left out then
// is taken to be known the next time.
void TestPlanGrowth::theTimeIsKeptWhereverItEnds()
{
    QFETCH(int, asked);
    AnalysisCaches analyses;
    const Analysis analysis = analyse(evaluate(bench::lattice(30)), analyses);
    PlanCaches caches;
    int left = asked;
    const ModelPlan plan = planOf(analysis, caches, [&] { return left-- <= 0; });
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::NotFound));
    QVERIFY(caches.collisions.work().encounters <= static_cast<std::size_t>(asked));
    QVERIFY(!planChecks(analysis, plan).empty()); // says that it is not known
    const ModelPlan next = planOf(analysis, caches);
    QCOMPARE(static_cast<int>(next.plan.verdict), static_cast<int>(Verdict::Possible));
    QVERIFY(next.plan.steps == planOf(analysis).plan.steps);
}

// Wrong: of parts that hold each other every two prisms are looked at before it is said that they
// do, or the same two again and again for each way that is tried.
void TestPlanGrowth::whatHoldsIsFoundAtOnce()
{
    const auto loaded = io::readDocument(QStringLiteral(FFF_SHARED_MODELS "/bridge.txt"));
    if (!loaded)
        FFF_WITHOUT_SHARED();
    AnalysisCaches analyses;
    const Analysis analysis = analyse(evaluate(loaded->document), analyses);
    PlanCaches caches;
    const ModelPlan plan = planOf(analysis, caches);
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::Impossible));
    const Collisions::Work &work = caches.collisions.work();
    QVERIFY2(work.prismPairs <= 20 * work.encounters,
             QByteArray::number(qulonglong(work.prismPairs)) + " of " +
                 QByteArray::number(qulonglong(work.encounters)));
}

FFF_TEST(TestPlanGrowth)
#include "tst_plan_growth.moc"
