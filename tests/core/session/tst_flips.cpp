#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/flips.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

using Verdict = AssemblyPlan::Verdict;

std::optional<Flips> flipsOf(const Document &document)
{
    const Analysis analysis = analysed(document);
    return flipsThatHelp(analysis, planOf(analysis));
}

} // namespace

class TestFlips : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aRoundaboutIsOpened();
    void severalAreOpened();
    void whatNoFlipFreesStaysAsItIs();
    void whatCanBeAssembledNeedsNone();
    void theTimeIsKept();
};

/// What would be wrong: a person who has to find out which of the slits to turn.
void TestFlips::aRoundaboutIsOpened()
{
    const Document document = roundabout(eggCrate(2, 2), 0);
    const Analysis analysis = analysed(document);
    const ModelPlan plan = planOf(analysis);
    QCOMPARE(plan.plan.verdict, Verdict::Impossible);
    QCOMPARE(plan.plan.locked.size(), std::size_t(4));
    const std::optional<Flips> flips = flipsThatHelp(analysis, plan);
    QVERIFY(flips);
    QCOMPARE(flips->count, 1);
    QCOMPARE(planOf(analysed(flips->document)).plan.verdict, Verdict::Possible);
    // Nothing but slits is another.
    QVERIFY(flips->document.sections == document.sections);
}

/// What would be wrong: the first locked set is freed and the second one forgotten.
void TestFlips::severalAreOpened()
{
    Document document = roundabout(eggCrate(2, 2), 0);
    const Document other = eggCrate(2, 2);
    for (const SectionPointer &section : other.sections) {
        Frame frame = section->frame;
        frame.origin.x() += 500.0;
        document = withSection(std::move(document), section->shape, frame);
    }
    document = roundabout(std::move(document), 4);
    const std::optional<Flips> flips = flipsOf(document);
    QVERIFY(flips);
    QCOMPARE(flips->count, 2);
    QCOMPARE(planOf(analysed(flips->document)).plan.verdict, Verdict::Possible);
}

/// What would be wrong: slits turned for nothing.
void TestFlips::whatNoFlipFreesStaysAsItIs()
{
    QVERIFY(!flipsOf(triangle()));
}

void TestFlips::whatCanBeAssembledNeedsNone()
{
    QVERIFY(!flipsOf(eggCrate(2, 2)));
    QVERIFY(!flipsOf(newDocument()));
}

/// What would be wrong: a search that goes on after its time.
void TestFlips::theTimeIsKept()
{
    const Analysis analysis = analysed(roundabout(eggCrate(2, 2), 0));
    const ModelPlan plan = planOf(analysis);
    int asked = 0;
    QVERIFY(!flipsThatHelp(analysis, plan, [&asked] { return ++asked > 3; }));
    QVERIFY(asked < 40);
}

FFF_TEST(TestFlips)
#include "tst_flips.moc"
