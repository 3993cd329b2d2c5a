// Pieces and sheets that are hard on a nester.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/nesting/nester.h"
#include "tests/core/nesting/nesting_oracle.h"
#include "tests/core/nesting/nesting_problems.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;
using nest::Turning;

namespace {

const std::int64_t kCaseWork = nest::workOf(0.03);

nest::Solution sound(const nest::Problem &problem, std::int64_t work = kCaseWork)
{
    const nest::Solution solution = nest::nestPieces(problem, {1, work, true});
    const QString wrong = whatIsWrong(problem, solution);
    if (!wrong.isEmpty())
        QTest::qFail(qPrintable(wrong), __FILE__, __LINE__);
    return solution;
}

nest::Piece ring(double outer, double inner)
{
    nest::Piece piece = pieceOf(box(0, 0, outer, outer), 1, Turning::None);
    const double wall = 0.5 * (outer - inner);
    Polygon hole = box(wall, wall, inner, inner);
    std::reverse(hole.begin(), hole.end());
    piece.outline.holes.push_back(hole);
    return piece;
}

} // namespace

class TestNestingCases : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothing();
    void noSheet();
    void aPieceAsLargeAsTheSheet();
    void whatIsTooLargeIsLeft();
    void sheetsThatRunOut();
    void piecesInHolesOfPieces();
    void holesOfOffcuts();
    void aThousandSquares();
    void needles();
    void withoutArea();
    void fitsOnlyAtAnAngle();
    void aMarginLessThanTheSpacing();
    void farFromTheOrigin();
    void lastSheetIsEmptied();
};

void TestNestingCases::nothing()
{
    nest::Problem problem;
    problem.stripHeight = 10.0;
    QCOMPARE(sound(problem).length, 0.0);
    problem.stripHeight = 0.0;
    problem.sheets = {sheet(10, 10)};
    problem.pieces = {pieceOf(box(0, 0, 1, 1), 0)};
    const nest::Solution solution = sound(problem);
    QVERIFY(solution.sheets.empty() && solution.places.empty() && solution.density == 0.0);
}

void TestNestingCases::noSheet()
{
    nest::Problem problem;
    problem.pieces = {pieceOf(box(0, 0, 5, 5), 2)};
    QCOMPARE(sound(problem).left.size(), 2U);
    problem.sheets = {sheet(8, 8)};
    problem.margin = 5.0; // nothing of it is left
    QCOMPARE(sound(problem).left.size(), 2U);
}

// Wrong: rounding would take the last nanometre of a sheet that is bought in that size.
void TestNestingCases::aPieceAsLargeAsTheSheet()
{
    for (const double spacing : {0.0, 2.0}) {
        nest::Problem problem;
        problem.pieces = {pieceOf(box(-17, 3, 590, 390), 1, Turning::None)};
        problem.sheets = {sheet(600, 400)};
        problem.margin = 5.0;
        problem.spacing = spacing;
        QVERIFY(sound(problem).left.empty());
        problem.pieces = {pieceOf(box(0, 0, 390, 590), 2)};
        const nest::Solution turned = sound(problem);
        QCOMPARE(turned.sheets.size(), 2U);
        problem.pieces = {pieceOf(box(0, 0, 590.001, 390), 1)};
        QCOMPARE(sound(problem).left.size(), 1U);
    }
    nest::Problem strip;
    strip.stripHeight = 0.3;
    strip.pieces = {pieceOf(box(0.1, 0.2, 0.7, 0.3), 3, Turning::None)};
    QVERIFY(std::abs(sound(strip).length - 2.1) < 1e-3);
}

void TestNestingCases::whatIsTooLargeIsLeft()
{
    nest::Problem problem;
    problem.pieces = {pieceOf(box(0, 0, 50, 101)), pieceOf(box(0, 0, 20, 20), 2),
                      pieceOf(box(0, 0, 300, 300), 2)};
    problem.sheets = {sheet(100, 100)};
    const nest::Solution solution = sound(problem);
    QCOMPARE(solution.left, (std::vector<int>{2, 2, 0}));
    QCOMPARE(solution.sheets.size(), 1U);
}

void TestNestingCases::sheetsThatRunOut()
{
    nest::Problem problem;
    problem.pieces = {pieceOf(box(0, 0, 60, 60), 5)};
    problem.sheets = {sheet(100, 100, 2), sheet(70, 70, 1)};
    const nest::Solution solution = sound(problem);
    QCOMPARE(solution.places.size(), 3U);
    QCOMPARE(solution.left.size(), 2U);
}

// Wrong: the waste in a ring would be bought again.
void TestNestingCases::piecesInHolesOfPieces()
{
    nest::Problem problem;
    problem.pieces = {ring(100, 80), ring(70, 50), pieceOf(box(0, 0, 40, 40))};
    problem.stripHeight = 101.0;
    problem.spacing = 1.0;
    QVERIFY2(sound(problem, 0).length < 101.0, "at once");
    QVERIFY2(sound(problem).length < 101.0, "searched");
}

// Wrong: a part would be cut where there is no material.
void TestNestingCases::holesOfOffcuts()
{
    nest::Problem problem;
    problem.pieces = {pieceOf(box(0, 0, 30, 18), 16, Turning::Free)};
    problem.sheets = {offcut(2)};
    problem.margin = problem.spacing = 1.5;
    const nest::Solution solution = sound(problem);
    QVERIFY(solution.left.empty());
    QVERIFY(solution.sheets.size() <= 2U);
}

void TestNestingCases::aThousandSquares()
{
    nest::Problem problem;
    problem.pieces = {pieceOf(box(0, 0, 10, 10), 1000, Turning::None)};
    problem.sheets = {sheet(230, 121)};
    problem.spacing = 1.0;
    const nest::Solution solution = nest::nestPieces(problem, {1, 0, true});
    QVERIFY(solution.left.empty());
    QCOMPARE(solution.places.size(), 1000U);
    // 21 × 11 on each: five sheets, one of them hardly used.
    QVERIFY2(solution.sheets.size() <= 5U, qPrintable(QString::number(solution.sheets.size())));
}

void TestNestingCases::needles()
{
    nest::Problem problem;
    problem.pieces = {pieceOf({{0, 0}, {200, 0.01}, {0, 0.02}}, 20, Turning::Half),
                      pieceOf(box(0, 0, 0.05, 90), 20, Turning::None)};
    problem.stripHeight = 100.0;
    sound(problem);
    problem.spacing = 0.5;
    sound(problem);
}

// Wrong: a piece without area would be lost, or lie across others.
void TestNestingCases::withoutArea()
{
    nest::Problem problem;
    problem.pieces = {pieceOf({{0, 0}, {30, 0}, {15, 0}}, 2), pieceOf(box(0, 0, 20, 20), 3),
                      pieceOf({{5, 5}, {5, 5}, {5, 5}}, 2)};
    problem.stripHeight = 50.0;
    problem.spacing = 1.0;
    sound(problem);
}

void TestNestingCases::fitsOnlyAtAnAngle()
{
    nest::Problem problem;
    problem.pieces = {pieceOf(box(0, 0, 130, 4), 2, Turning::Free)};
    const double diagonal = 0.78539816339744831;
    problem.pieces[0].turns.emplace_back(std::cos(diagonal), std::sin(diagonal));
    problem.sheets = {sheet(100, 100)};
    QVERIFY(sound(problem).left.empty());
}

void TestNestingCases::aMarginLessThanTheSpacing()
{
    nest::Problem problem;
    problem.pieces = stars(3, 6, Turning::Half);
    problem.sheets = {sheet(150, 150), offcut(1)};
    problem.margin = 0.5;
    problem.spacing = 6.0;
    sound(problem);
}

void TestNestingCases::farFromTheOrigin()
{
    nest::Problem problem;
    problem.pieces = {pieceOf(box(9e5, -9e5, 30, 20), 9), pieceOf(box(-1e6, 5e5, 11, 7), 9)};
    problem.stripHeight = 60.0;
    problem.spacing = 0.1;
    sound(problem);
}

// Wrong: a few parts that would go between others would cost a sheet.
void TestNestingCases::lastSheetIsEmptied()
{
    nest::Problem problem;
    // The first layout puts the triangles as they come; turned about each other they need one
    // sheet.
    problem.pieces = {pieceOf({{0, 0}, {60, 0}, {0, 60}}, 8, Turning::Half),
                      pieceOf(box(0, 0, 10, 10), 8, Turning::None)};
    problem.sheets = {sheet(140, 150)};
    const nest::Solution solution = sound(problem, nest::workOf(0.5));
    QCOMPARE(solution.sheets.size(), 1U);
}

FFF_TEST(TestNestingCases)
#include "tst_nesting_cases.moc"
