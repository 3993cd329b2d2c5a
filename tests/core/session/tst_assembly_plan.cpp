#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/assembly_plan.h"
#include "core/base/units.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/assembly/plan_replay.h"
#include "tests/core/session/random_edits.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

using Verdict = AssemblyPlan::Verdict;

struct Case
{
    const char *name;
    Document document;
    Verdict verdict;
    std::vector<int> locked;
};

std::vector<Case> cases()
{
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    const ShapePointer slot = polygonShape(rectangle(-60, -60, 60, 60));
    std::vector<Case> all;
    const auto add = [&](const char *name, Document document, Verdict verdict,
                         std::vector<int> locked = {}) {
        all.push_back({name, std::move(document), verdict, std::move(locked)});
    };
    add("nothing", newDocument(), Verdict::Possible);
    add("one plate", withSection(newDocument(), plate, front()), Verdict::Possible);
    add("two that do not meet",
        withSection(withSection(newDocument(), plate, front()), plate, front(-50)),
        Verdict::Possible);
    add("two that cross", withSection(withSection(newDocument(), plate, front()), plate, side()),
        Verdict::Possible);
    add("two that cross at 35 degrees",
        withSection(withSection(newDocument(), plate, front()), plate, turned(radians(35.0))),
        Verdict::Possible);
    add("a chain of two", chain(2), Verdict::Possible);
    add("a chain of nine", chain(9), Verdict::Possible);
    add("a comb of seven", combModel(7), Verdict::Possible);
    for (const auto &[name, across, along] :
         {std::tuple("a crate of 2 by 2", 2, 2), std::tuple("a crate of 3 by 5", 3, 5),
          std::tuple("a crate of 8 by 8", 8, 8), std::tuple("a crate of 12 by 12", 12, 12)})
        add(name, eggCrate(across, along), Verdict::Possible);
    add("a crate of 5 by 5", eggCrate(5, 5), Verdict::Possible);
    add("a crate of 10 by 10", eggCrate(10, 10), Verdict::Possible);
    // Each strip above the next one, but for the lowest.
    add("a crate with one joint the other way", downwards(eggCrate(2, 2), 0, 2), Verdict::Possible);
    // Each above the next one, all round: a burr.
    add("four that lock each other", roundabout(eggCrate(2, 2), 0), Verdict::Impossible,
        {0, 1, 2, 3});
    add("four that lock each other, and a rib",
        withSection(roundabout(eggCrate(2, 2), 0), polygonShape(rectangle(5, 10, 35, 60)),
                    side(50)),
        Verdict::Impossible, {0, 1, 2, 3});
    add("a comb that goes in from one side", combOverRibs(), Verdict::Possible);
    add("a rib under a beam", ribUnderABeam(), Verdict::Possible);
    // The key holds the tongue where it is.
    add("a key through a tongue through a slot",
        withSection(withSection(withSection(newDocument(), slot,
                                            {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()}),
                                polygonShape(rectangle(-10, -20, 10, 40)), front()),
                    polygonShape(rectangle(-30, 3, 30, 25)), side()),
        Verdict::Possible);
    add("three through each other", triangle(), Verdict::Impossible, {0, 1, 2});
    {
        Document document = triangle();
        document =
            withSection(std::move(document), polygonShape(rectangle(-18, -45, -2, -15)), side(15));
        add("a fourth on three through each other", std::move(document), Verdict::Impossible,
            {0, 1, 2});
    }
    add("a star of eight", star(8), Verdict::Possible);
    // 7.5 mm out of its slit, then aside: straight on it would run into the arm.
    add("out from under an arm", underAnArm(40), Verdict::Possible);
    add("held by an arm", underAnArm(60), Verdict::Impossible, {0, 1});
    add("two that are furnished first", furnished(), Verdict::Possible);
    add("a tongue through a slot",
        withSection(withSection(newDocument(), slot, {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()}),
                    polygonShape(rectangle(-10, -20, 10, 40)), front()),
        Verdict::Possible);
    return all;
}

} // namespace

class TestAssemblyPlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void modelsWithAKnownAnswer_data();
    void modelsWithAKnownAnswer();
    void whatIsBuiltFirstIsMovedAsOne();
    void theTimeIsKept();
    void orderAndDirectionAreAsTheyMustBe();
    void whatIsKnownFromBeforeChangesNothing();
    void platesInEachOtherAreFound();
    void whatOverlapsALittleIsStillInTheWay_data();
    void whatOverlapsALittleIsStillInTheWay();
};

void TestAssemblyPlan::modelsWithAKnownAnswer_data()
{
    QTest::addColumn<Case>("known");
    for (Case &known : cases())
        QTest::newRow(known.name) << known;
}

/// What would be wrong: a verdict that a person with the parts in hand would laugh at, or a plan in
/// which a part goes through another one.
void TestAssemblyPlan::modelsWithAKnownAnswer()
{
    QFETCH(Case, known);
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(known.document), caches);
    const ModelPlan plan = planOf(analysis);
    QVERIFY(plan.overlaps.empty());
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(known.verdict));
    QCOMPARE(plan.plan.locked, known.locked);
    if (known.verdict != Verdict::Possible) {
        QVERIFY(plan.plan.steps.empty());
        return;
    }
    const QString wrong = fault(analysis, plan);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

/// What would be wrong: groups that are looked for only where single parts would do.
void TestAssemblyPlan::whatIsBuiltFirstIsMovedAsOne()
{
    AnalysisCaches caches;
    const ModelPlan plan = planOf(analyse(evaluate(furnished()), caches));
    QVERIFY(std::any_of(plan.plan.steps.begin(), plan.plan.steps.end(),
                        [](const AssemblyStep &step) { return step.parts.size() == 2; }));
}

void TestAssemblyPlan::whatOverlapsALittleIsStillInTheWay_data()
{
    QTest::addColumn<double>("overlap"); // mm, where they end up
    for (const double overlap : {-0.5, 0.0, 0.1, 0.29, 0.35, 1.0, 1.5})
        QTest::addRow("%g", overlap) << overlap;
}

/// What would be wrong: of two that touch a little too much in their place, one goes through the
/// other on its way there.
void TestAssemblyPlan::whatOverlapsALittleIsStillInTheWay()
{
    QFETCH(const double, overlap);
    const auto polygon = [](const Polygon &points) { return polygonShape(points); };
    // The spine; a board with a wide end that slides in from its end, level; one from above, whose
    // arm lies below the board and whose tower stands behind its wide end. Either has to be first.
    Document document =
        withSection(newDocument(),
                    polygon({{-60, 0}, {24, 0}, {24, 60}, {0, 60}, {0, 90}, {-60, 90}}), front());
    document = withSection(
        std::move(document),
        polygon(
            {{-30, -50}, {10, -50}, {10, -30}, {40, -30}, {40, 30}, {10, 30}, {10, 50}, {-30, 50}}),
        {Vec3(0, 70, 0), Vec3::UnitX(), -Vec3::UnitZ()});
    const double top = 68.5 + overlap;
    document = withSection(
        std::move(document),
        polygon({{-50, 0}, {20, 0}, {20, top}, {-30.5, top}, {-40, top}, {-40, 110}, {-50, 110}}),
        {Vec3(20, 0, 0), -Vec3::UnitZ(), Vec3::UnitY()});
    Stock stock = *document.stocks.front();
    stock.clearance = 0.0;
    document = setStock(document, stock).value();
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(document), caches);
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(2));
    const ModelPlan plan = planOf(analysis);
    QCOMPARE(plan.overlaps.size(), std::size_t(overlap > 0.0 ? 1 : 0));
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::Impossible));
}

/// What would be wrong: a person is told to push where it does not go, or what comes last first.
void TestAssemblyPlan::orderAndDirectionAreAsTheyMustBe()
{
    const auto stepOf = [](const ModelPlan &plan, int part) {
        const auto &steps = plan.plan.steps;
        return std::find_if(steps.begin(), steps.end(), [&](const AssemblyStep &step) {
            return std::find(step.parts.begin(), step.parts.end(), part) != step.parts.end();
        });
    };
    AnalysisCaches caches;
    // The comb comes from above, or all that it holds from below.
    const ModelPlan comb = planOf(analyse(evaluate(combOverRibs()), caches));
    QVERIFY(stepOf(comb, 4) != comb.plan.steps.end());
    for (const Move &move : stepOf(comb, 4)->moves)
        QVERIFY(std::abs(std::abs(move.direction.y()) - 1.0) < 1e-9);
    const ModelPlan beam = planOf(analyse(evaluate(ribUnderABeam()), caches));
    QVERIFY(stepOf(beam, 1) < stepOf(beam, 4));
}

/// What would be wrong: a verdict that was not thought through to its end.
void TestAssemblyPlan::theTimeIsKept()
{
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(eggCrate(4, 4)), caches);
    int asked = 0;
    const ModelPlan plan = planOf(analysis, [&asked] { return ++asked > 10; });
    QCOMPARE(static_cast<int>(plan.plan.verdict), static_cast<int>(Verdict::NotFound));
    QVERIFY(plan.plan.steps.empty() && plan.plan.locked.empty());
    QVERIFY(asked < 20);
}

/// What would be wrong: after an edit a verdict on parts as they were, or another plan than the one
/// that is found when the file is opened again.
void TestAssemblyPlan::whatIsKnownFromBeforeChangesNothing()
{
    RandomEdits edits(11);
    Document document = eggCrate(3, 4);
    AnalysisCaches analyses;
    PlanCaches caches;
    for (int i = 0; i < 340; ++i) {
        // To and fro, so that what was forgotten is asked for again.
        const Document next = edits.next(document);
        for (const Document *shown :
             std::initializer_list<const Document *>{&next, &document, &next}) {
            const AnalysisPointer analysis = analyseNext(evaluate(*shown), analyses);
            const ModelPlan kept = planOf(*analysis, caches), anew = planOf(*analysis);
            QCOMPARE(static_cast<int>(kept.plan.verdict), static_cast<int>(anew.plan.verdict));
            QCOMPARE(kept.plan.locked, anew.plan.locked);
            QVERIFY(std::equal(kept.bodies.begin(), kept.bodies.end(), anew.bodies.begin(),
                               anew.bodies.end(),
                               [](const Body &a, const Body &b) { return &a == &b; }));
            QVERIFY(kept.plan.steps == anew.plan.steps);
            QCOMPARE(kept.overlaps.size(), anew.overlaps.size());
            for (std::size_t k = 0; k < kept.overlaps.size(); ++k)
                QVERIFY(kept.overlaps[k].how.depth == anew.overlaps[k].how.depth);
        }
        document = next;
    }
}

/// What would be wrong: plates that touch count as being in each other, or such as lie in one plane
/// and need no axis to be in each other do not.
void TestAssemblyPlan::platesInEachOtherAreFound()
{
    const ShapePointer plate = polygonShape(rectangle(0, 0, 40, 40));
    const auto overlapsOfTwo = [&](const Frame &a, const Frame &b) {
        AnalysisCaches caches;
        return planOf(analyse(evaluate(withSection(withSection(newDocument(), plate, a), plate, b)),
                              caches))
            .overlaps;
    };
    QVERIFY(overlapsOfTwo(front(), front(3.0)).empty());
    const auto deep = overlapsOfTwo(front(), front(2.0));
    QCOMPARE(deep.size(), std::size_t(1));
    QVERIFY(std::abs(deep.front().how.depth - 1.0) < 1e-9);
    QVERIFY(overlapsOfTwo(front(), {{40, 0, 0}, Vec3::UnitX(), Vec3::UnitY()}).empty());
    QCOMPARE(overlapsOfTwo(front(), {{39, 5, 0}, Vec3::UnitX(), Vec3::UnitY()}).size(),
             std::size_t(1));
}

FFF_TEST(TestAssemblyPlan)
#include "tst_assembly_plan.moc"
