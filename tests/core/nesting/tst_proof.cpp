// The judge of layouts finds what is wrong with one.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/nesting/nester.h"
#include "core/nesting/proof.h"
#include "tests/core/nesting/nesting_problems.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;
using nest::Fault;
using nest::Turning;

namespace {

/// Two squares of 10 beside each other on a sheet of 40, and what their places are.
struct Scene
{
    nest::Problem problem;
    nest::Solution solution;

    Scene()
    {
        problem.pieces = {pieceOf(box(0, 0, 10, 10), 2, Turning::Quarter)};
        problem.sheets = {sheet(40, 40, 1)};
        solution.sheets = {0};
        solution.places = {{0, 0, Vec2::UnitX(), {0, 0}}, {0, 0, Vec2::UnitX(), {20, 0}}};
    }
    std::optional<Fault::Kind> fault() const
    {
        const auto found = nest::faultOf(problem, solution);
        return found ? std::optional(found->kind) : std::nullopt;
    }
};

} // namespace

class TestProof : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aSoundOne();
    void overlaps_data();
    void overlaps();
    void oneInAnother();
    void distances();
    void edgesOfTheSheet();
    void holesOfTheSheet();
    void turnsAndCounts();
};

void TestProof::aSoundOne()
{
    Scene scene;
    QVERIFY(!scene.fault());
    // Touching the sheet's edge is no fault.
    scene.solution.places[1].offset = {30, 30};
    QVERIFY(!scene.fault());
}

void TestProof::overlaps_data()
{
    QTest::addColumn<Vec2>("offset");
    QTest::newRow("half over it") << Vec2(5, 0);
    QTest::newRow("a corner in it") << Vec2(7, 8);
    QTest::newRow("a nanometre in it") << Vec2(9.999999, 0);
    QTest::newRow("the same place") << Vec2(0, 0);
    QTest::newRow("edges on one line") << Vec2(10, 5);
    QTest::newRow("a corner at a corner") << Vec2(10, 10);
}

void TestProof::overlaps()
{
    QFETCH(const Vec2, offset);
    Scene scene;
    scene.solution.places[1].offset = offset;
    QVERIFY(scene.fault() == Fault::Kind::Overlap);
}

void TestProof::oneInAnother()
{
    Scene scene;
    scene.problem.pieces = {pieceOf(box(0, 0, 30, 30)), pieceOf(box(0, 0, 5, 5))};
    scene.solution.places = {{0, 0, Vec2::UnitX(), {0, 0}}, {1, 0, Vec2::UnitX(), {12, 12}}};
    QVERIFY(scene.fault() == Fault::Kind::Overlap);
    Polygon hole = box(10, 10, 10, 10);
    std::reverse(hole.begin(), hole.end());
    scene.problem.pieces[0].outline.holes = {hole};
    QVERIFY(!scene.fault());
    scene.problem.spacing = 3.0;
    QVERIFY(scene.fault() == Fault::Kind::TooNear);
}

void TestProof::distances()
{
    Scene scene;
    scene.problem.spacing = 10.0;
    QVERIFY(!scene.fault());
    scene.problem.spacing = 10.001;
    QVERIFY(scene.fault() == Fault::Kind::TooNear);
    // By what is between corners, too.
    scene.problem.spacing = 3.0;
    const double part = std::sqrt(0.5);
    scene.problem.pieces[0].turnsFreely = true;
    scene.solution.places[1] = {0, 0, Vec2(part, part), {10 + 10 * part + 2.9, 0}};
    QVERIFY(scene.fault() == Fault::Kind::TooNear);
    scene.solution.places[1].offset.x() += 0.2;
    QVERIFY(!scene.fault());
    // What chords leave out counts on both sides.
    scene.problem.chord = 0.06;
    QVERIFY(scene.fault() == Fault::Kind::TooNear);
}

void TestProof::edgesOfTheSheet()
{
    Scene scene;
    scene.solution.places[1].offset = {30.000002, 0};
    QVERIFY(scene.fault() == Fault::Kind::OutsideOfSheet);
    scene.solution.places[1].offset = {29, 29};
    QVERIFY(!scene.fault());
    scene.problem.margin = 1.5;
    scene.solution.places[0].offset = {2, 2};
    QVERIFY(scene.fault() == Fault::Kind::OutsideOfSheet);
    scene.solution.places[1].offset = {100, 100};
    QVERIFY(scene.fault() == Fault::Kind::OutsideOfSheet);
}

void TestProof::holesOfTheSheet()
{
    Scene scene;
    Polygon hole = box(22, 2, 3, 3); // smaller than the square
    std::reverse(hole.begin(), hole.end());
    scene.problem.sheets[0].outline.holes = {hole};
    QVERIFY(scene.fault() == Fault::Kind::OutsideOfSheet);
    scene.solution.places[1].offset = {25, 0};
    QVERIFY(!scene.fault());
}

void TestProof::turnsAndCounts()
{
    Scene scene;
    scene.problem.pieces[0].turns = nest::turnsOf(Turning::None);
    scene.solution.places[1] = {0, 0, Vec2::UnitY(), {30, 0}};
    QVERIFY(scene.fault() == Fault::Kind::WrongTurn);
    scene = Scene();
    scene.solution.places.pop_back();
    QVERIFY(scene.fault() == Fault::Kind::WrongCount);
    scene.solution.left = {0};
    QVERIFY(!scene.fault());
    scene.solution.sheets = {0, 0};
    QVERIFY(scene.fault() == Fault::Kind::WrongCount);
}

FFF_TEST(TestProof)
#include "tst_proof.moc"
