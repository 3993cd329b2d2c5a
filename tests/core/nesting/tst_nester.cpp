// Laws of nesting: they hold for whatever pieces.
#include "core/nesting/nester.h"
#include "core/nesting/proof.h"
#include "tests/core/nesting/nesting_oracle.h"
#include "tests/core/nesting/nesting_problems.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;
using nest::Turning;

namespace {

const std::int64_t kALittle = nest::workOf(0.03);

bool areSame(const nest::Solution &a, const nest::Solution &b)
{
    return a.sheets == b.sheets && a.left == b.left && a.length == b.length && a.work == b.work &&
           std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                      [](const nest::Place &p, const nest::Place &q) {
                          return p.piece == q.piece && p.sheet == q.sheet && p.turn == q.turn &&
                                 p.offset == q.offset;
                      });
}

/// Fewer sheets, or as many and the last one less used; on a strip less of it.
bool isWorse(const nest::Solution &a, const nest::Solution &b)
{
    return a.sheets.size() != b.sheets.size() ? a.sheets.size() > b.sheets.size()
                                              : a.length > b.length + 1e-9;
}

nest::Problem strip(unsigned seed, Turning turning)
{
    nest::Problem problem;
    problem.pieces = stars(seed, 10, turning);
    problem.stripHeight = 130.0;
    return problem;
}

nest::Problem onSheets(unsigned seed, Turning turning)
{
    nest::Problem problem;
    problem.pieces = stars(seed, 12, turning);
    problem.sheets = {offcut(1), sheet(180, 140, 1), sheet(150, 150)};
    problem.margin = 4.0;
    problem.spacing = 2.0;
    return problem;
}

} // namespace

class TestNester : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void layoutsAreSound_data();
    void layoutsAreSound();
    void theSeedGivesTheLayout();
    void moreWorkIsNeverWorse();
    void beginsWhereItLay();
    void fillsMoreThanBoxes();
    void stoppedKeepsWhatIsBest();
    void progressNeverFalls();
};

void TestNester::layoutsAreSound_data()
{
    QTest::addColumn<int>("turning");
    QTest::addColumn<bool>("isStrip");
    QTest::addColumn<double>("spacing");
    QTest::addColumn<bool>("searches");
    const std::array<const char *, 4> names{"as drawn", "half", "quarter", "free"};
    for (int turning = 0; turning < 4; ++turning)
        for (const bool isStrip : {true, false})
            for (const bool searches : {true, false})
                QTest::addRow("%s turns on %s, %s", names[static_cast<std::size_t>(turning)],
                              isStrip ? "a strip" : "sheets", searches ? "searched" : "at once")
                    << turning << isStrip << (turning % 2 == 0 ? 0.0 : 2.5) << searches;
}

// Wrong: cuts would run through other parts or off the sheet.
void TestNester::layoutsAreSound()
{
    QFETCH(const int, turning);
    QFETCH(const bool, isStrip);
    QFETCH(const double, spacing);
    QFETCH(const bool, searches);
    for (unsigned seed = 1; seed <= 3; ++seed) {
        nest::Problem problem = isStrip ? strip(seed, static_cast<Turning>(turning))
                                        : onSheets(seed, static_cast<Turning>(turning));
        problem.spacing = spacing;
        const nest::Solution solution =
            nest::nestPieces(problem, {seed, searches ? kALittle : 0, true});
        const QString wrong = whatIsWrong(problem, solution);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("seed %1: ").arg(seed) + wrong));
        QVERIFY(solution.left.empty());
        const auto fault = nest::faultOf(problem, solution);
        QVERIFY2(!fault, qPrintable(QStringLiteral("seed %1: fault %2 of %3 and %4")
                                        .arg(seed)
                                        .arg(static_cast<int>(fault->kind))
                                        .arg(fault->first)
                                        .arg(fault->second)));
    }
}

// Wrong: the same command would cut another layout the next time, or on another machine.
void TestNester::theSeedGivesTheLayout()
{
    for (const nest::Problem &problem :
         {strip(7, Turning::Half), onSheets(7, Turning::Free), onSheets(8, Turning::Quarter)}) {
        const nest::Solution once = nest::nestPieces(problem, {5, kALittle, true});
        QVERIFY(areSame(once, nest::nestPieces(problem, {5, kALittle, true})));
        QVERIFY(areSame(once, nest::nestPieces(problem, {5, kALittle, false})));
    }
    const nest::Problem problem = strip(7, Turning::Half);
    QVERIFY(!areSame(nest::nestPieces(problem, {5, kALittle, true}),
                     nest::nestPieces(problem, {6, kALittle, true})));
}

// Wrong: who waits longer would get less.
void TestNester::moreWorkIsNeverWorse()
{
    for (const nest::Problem &problem : {strip(3, Turning::Quarter), onSheets(3, Turning::Half)}) {
        const nest::Solution first = nest::nestPieces(problem, {1, 0, true});
        const nest::Solution better = nest::nestPieces(problem, {1, 2 * kALittle, true});
        QVERIFY(!isWorse(better, first));
    }
    const nest::Problem problem = strip(3, Turning::Quarter);
    QVERIFY(isWorse(nest::nestPieces(problem, {1, 0, true}),
                    nest::nestPieces(problem, {1, 4 * kALittle, true})));
}

// Wrong: triangles would lie as their boxes do, half of each empty.
// A layout that was searched for is kept by what is a little different: as it is where that is
// sound, taken apart where pieces are nearer to each other than they may be by now.
void TestNester::beginsWhereItLay()
{
    for (const unsigned seed : {1U, 2U, 3U}) {
        nest::Problem problem = onSheets(seed, Turning::Free);
        for (nest::Piece &piece : problem.pieces)
            piece.demand = 1;
        nest::Options options;
        options.work = 4 * kALittle;
        const nest::Solution found = nest::nestPieces(problem, options);
        QVERIFY(found.left.empty());
        const nest::Solution same = nest::nestPieces(problem, {}, {}, found);
        QVERIFY(same.sheets == found.sheets);
        for (std::size_t i = 0; i < found.places.size(); ++i)
            QVERIFY((same.places[i].offset - found.places[i].offset).norm() < 1e-3);
        problem.spacing += 0.2;
        const nest::Solution apart = nest::nestPieces(problem, {}, {}, found);
        QVERIFY(!nest::faultOf(problem, apart));
        QVERIFY(!isWorse(apart, nest::nestPieces(problem, {})));
        QVERIFY(areSame(apart, nest::nestPieces(problem, {}, {}, found)));
        // Of some of the pieces it is not known: as if it were of none.
        nest::Solution part = found;
        part.places.pop_back();
        QVERIFY(areSame(nest::nestPieces(problem, {}, {}, part), nest::nestPieces(problem, {})));
    }
}

void TestNester::fillsMoreThanBoxes()
{
    nest::Problem problem;
    problem.pieces = {pieceOf({{0, 0}, {30, 0}, {0, 50}}, 24, Turning::Half)};
    problem.stripHeight = 100.1;
    const nest::Solution solution = nest::nestPieces(problem, {1, 4 * kALittle, true});
    QCOMPARE(whatIsWrong(problem, solution), QString());
    QVERIFY2(solution.density > 0.8, qPrintable(QString::number(solution.density)));
}

// Wrong: a person who will not wait any longer would lose what there is.
void TestNester::stoppedKeepsWhatIsBest()
{
    const nest::Problem problem = strip(4, Turning::Half);
    const nest::Solution first = nest::nestPieces(problem, {1, 0, true});
    std::stop_source before;
    before.request_stop();
    const nest::Solution atOnce =
        nest::nestPieces(problem, {1, 100 * kALittle, true}, {before.get_token(), {}});
    QVERIFY(areSame(first, atOnce));

    std::stop_source later;
    double reached = 0.0;
    const LongWork work{later.get_token(), [&](double share) {
                            reached = share;
                            later.request_stop();
                        }};
    const nest::Solution stopped = nest::nestPieces(problem, {1, 10 * kALittle, true}, work);
    QVERIFY(reached < 0.5);
    QCOMPARE(whatIsWrong(problem, stopped), QString());
    QVERIFY(isWorse(first, stopped));
}

void TestNester::progressNeverFalls()
{
    double last = 0.0;
    bool fell = false;
    nest::nestPieces(onSheets(5, Turning::Half), {1, kALittle, true}, {{}, [&](double share) {
                                                                           fell =
                                                                               fell || share < last;
                                                                           last = share;
                                                                       }});
    QVERIFY(!fell);
    QCOMPARE(last, 1.0);
}

FFF_TEST(TestNester)
#include "tst_nester.moc"
