#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/fit.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/pen_words.h"
#include "core/interaction/snapping.h"
#include "core/interaction/stroke_words.h"
#include "core/interaction/tool.h"
#include "core/model/edit_words.h"
#include "tests/core/session/script_run.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

// Every script of tests/data/strokes/pen_*.json is a person with the pen: what is in the document
// at its end, and what is said.

namespace {

class PenRun : public ScriptRun
{
public:
    Result<void> play(const QString &name) { return playFile(QStringLiteral("pen_") + name); }
    const Section &last() const { return *sections().back(); }
    /// The corners of the last section, in the world.
    std::vector<Vec3> corners() const
    {
        std::vector<Vec3> corners;
        const Contour &contour = last().shape->contour();
        for (int i = 0; i < contour.segmentCount(); ++i)
            corners.push_back(last().frame.toWorld(contour.segment(i).p0));
        return corners;
    }
    double step() const { return gridStep(interaction.camera().millimetresPerPixel); }
};

bool has(const std::vector<Vec3> &points, const Vec3 &point)
{
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec3 &p) { return (p - point).norm() < 1e-9; });
}

bool isMultiple(double value, double step)
{
    return std::abs(value / step - std::round(value / step)) * step < 1e-9;
}

} // namespace

class TestPenScripts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesTheDocument_data();
    void makesTheDocument();
    void replaysExactly();
    void allWaysToCloseMakeTheSame();
    void secondSectionsStandOnTheirSlit_data();
    void secondSectionsStandOnTheirSlit();
    void smoothPointsAreSmooth();
    void snappedPointsAreRound();
    void unsnappedPointsAreWhereTheyWereSet();
    void shiftMakesRightAngles();
    void numbersAreExact();
    void stepsInThePathComeBack();
    void aHoleAndAnotherContour();
    void parallelPlanesLieAtTheirDistance();
    void theGroundCutsFlat();
    void theViewComesBack();
};

void TestPenScripts::makesTheDocument_data()
{
    QTest::addColumn<int>("sections");
    QTest::addColumn<int>("steps");
    QTest::addColumn<int>("open"); // points of the path at the end
    QTest::addColumn<bool>("held");
    QTest::addColumn<Text>("hint"); // -1: not looked at
    const auto row = [](const char *name, int sections, int steps, int open = 0, bool held = true,
                        Text hint = {}) {
        QTest::newRow(name) << sections << steps << open << held << hint;
    };
    row("first_section", 1, 1);
    row("closed_at_its_start", 1, 1);
    row("closed_by_a_double_click", 1, 1);
    row("smooth_points", 1, 1);
    row("broken_handle", 1, 1);
    row("second_section", 2, 2);
    row("released_in_the_turn", 2, 2);
    row("backspace", 1, 1);
    row("backspace_to_the_start", 1, 1);
    row("escape_takes_the_path_back", 0, 0);
    row("escape_lays_it_down", 0, 0, 0, false);
    row("escape_in_the_turn", 1, 1);
    row("escape_brings_the_view_back", 1, 1, 0, false);
    row("by_numbers", 1, 1);
    row("by_numbers_and_clicks", 1, 1);
    row("on_the_grid", 1, 1);
    row("off_the_grid", 1, 1);
    row("level_and_upright", 1, 1);
    row("undo_in_the_path", 1, 1);
    row("undo_and_redo", 1, 1);
    row("moved_point", 1, 1);
    row("crossing", 1, 1, 0, true, hints::kCrossesItself);
    row("crossing_taken_back", 1, 1);
    row("nothing_to_close", 0, 0, 2, true, hints::kNothingToClose);
    row("view_moves", 1, 1);
    row("hole", 1, 2);
    row("redrawn", 1, 2);
    row("parallel_plane", 2, 2);
    row("cut_at_the_ground", 1, 1, 0, true, hints::kCutAtGround);
    row("below_the_ground", 0, 0, 3, true, hints::kBelowGround);
    row("click_selects", 1, 1);
    row("left_button_orbits", 1, 1);
    row("perspective", 1, 1);
}

void TestPenScripts::makesTheDocument()
{
    QFETCH(int, open);
    QFETCH(Text, hint);
    QFETCH(bool, held);
    PenRun run;
    const Result<void> done = run.play(QString::fromUtf8(QTest::currentDataTag()));
    QVERIFY2(done, done ? "" : done.error().args.front().c_str());
    QTEST(int(run.sections().size()), "sections");
    QTEST(run.session.history()->count(), "steps");
    QCOMPARE(run.interaction.tool() != nullptr, held);
    const auto *marks = run.interaction.overlay().find<PenMarks>();
    QCOMPARE(marks ? int(marks->points.size()) : 0, open);
    QVERIFY(!run.session.hasPreview());
    QVERIFY(!run.interaction.hasGesture() && !run.interaction.isAnimating());
    if (hint.source)
        QCOMPARE(run.interaction.hint().words.text, hint);
    for (const SectionPointer &section : run.sections())
        QVERIFY(section->shape->area() > 100.0);
}

void TestPenScripts::replaysExactly()
{
    for (const char *name : {"second_section", "smooth_points", "undo_in_the_path"}) {
        PenRun once, twice;
        QVERIFY(once.play(QLatin1String(name)));
        QVERIFY(twice.play(QLatin1String(name)));
        QVERIFY(once.session.committed().document == twice.session.committed().document);
    }
}

void TestPenScripts::allWaysToCloseMakeTheSame()
{
    PenRun enter, start, twice, back;
    QVERIFY(enter.play(QStringLiteral("first_section")));
    QVERIFY(start.play(QStringLiteral("closed_at_its_start")));
    QVERIFY(twice.play(QStringLiteral("closed_by_a_double_click")));
    QVERIFY(back.play(QStringLiteral("backspace")));
    QCOMPARE(enter.last().shape->contour().segmentCount(), 4);
    for (const PenRun *other : {&start, &twice, &back})
        QVERIFY(other->last() == enter.last());
}

void TestPenScripts::secondSectionsStandOnTheirSlit_data()
{
    QTest::addColumn<QString>("script");
    QTest::newRow("released where clicks begin") << "second_section";
    QTest::newRow("released in the turn") << "released_in_the_turn";
}

void TestPenScripts::secondSectionsStandOnTheirSlit()
{
    QFETCH(QString, script);
    PenRun run;
    QVERIFY(run.play(script));
    QVERIFY(standsOnItsSlit(*run.sections()[0], run.last()));
    // Seen straight at the end, and cut into each other.
    QVERIFY(run.interaction.camera().backward().cross(run.last().frame.normal()).norm() < 1e-6);
    QCOMPARE(run.session.currentAnalysis().assembly.joints.size(), std::size_t(1));
}

void TestPenScripts::smoothPointsAreSmooth()
{
    PenRun run;
    QVERIFY(run.play(QStringLiteral("smooth_points")));
    const Contour &contour = run.last().shape->contour();
    QCOMPARE(contour.segmentCount(), 4);
    for (int i = 0; i < 4; ++i) {
        const Vec2 before = endDirection(contour.segment(i)),
                   after = startDirection(contour.segment((i + 1) % 4));
        QVERIFY((before - after).norm() < 1e-9);
    }
    PenRun broken;
    QVERIFY(broken.play(QStringLiteral("broken_handle")));
    const Contour &cornered = broken.last().shape->contour();
    const Vec2 in = endDirection(cornered.segment(0)), out = startDirection(cornered.segment(1));
    QVERIFY((in - out).norm() > 0.5);
}

void TestPenScripts::snappedPointsAreRound()
{
    PenRun run;
    QVERIFY(run.play(QStringLiteral("on_the_grid")));
    QCOMPARE(run.corners().size(), std::size_t(4));
    for (const Vec3 &corner : run.corners())
        QVERIFY(isMultiple(corner.x(), run.step()) && isMultiple(corner.y(), run.step()));
}

void TestPenScripts::unsnappedPointsAreWhereTheyWereSet()
{
    PenRun run;
    QVERIFY(run.play(QStringLiteral("off_the_grid")));
    QVERIFY(!run.interaction.settings().snaps);
    const std::vector<Vec3> corners = run.corners();
    QCOMPARE(corners.size(), std::size_t(3));
    for (const Vec2 &pixel : {Vec2(473.3, 641.7), Vec2(811.9, 639.2), Vec2(700.4, 402.6)}) {
        const bool isThere = std::any_of(corners.begin(), corners.end(), [&](const Vec3 &corner) {
            return (run.interaction.camera().toScreen(corner, {1280, 800}) - pixel).norm() < 1e-6;
        });
        QVERIFY(isThere);
    }
}

void TestPenScripts::shiftMakesRightAngles()
{
    PenRun run;
    QVERIFY(run.play(QStringLiteral("level_and_upright")));
    const std::vector<Vec3> corners = run.corners();
    QCOMPARE(corners.size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 side = corners[(i + 1) % 4] - corners[i];
        QVERIFY(std::min(std::abs(side.x()), std::abs(side.y())) < 1e-9);
    }
}

void TestPenScripts::numbersAreExact()
{
    PenRun run;
    QVERIFY(run.play(QStringLiteral("by_numbers")));
    const std::vector<Vec3> corners = run.corners();
    QCOMPARE(corners.size(), std::size_t(4));
    for (const Vec3 &corner :
         {Vec3(-40, 12.5, 0), Vec3(40.25, 12.5, 0), Vec3(40.25, 62.5, 0), Vec3(-40, 62.5, 0)})
        QVERIFY(has(corners, corner));
}

void TestPenScripts::stepsInThePathComeBack()
{
    PenRun run, plain;
    QVERIFY(run.play(QStringLiteral("undo_in_the_path")));
    QVERIFY(plain.play(QStringLiteral("first_section")));
    QVERIFY(run.last() == plain.last());
    PenRun redone;
    QVERIFY(redone.play(QStringLiteral("undo_and_redo")));
    QVERIFY(redone.last() == plain.last());
}

void TestPenScripts::aHoleAndAnotherContour()
{
    PenRun hole;
    QVERIFY(hole.play(QStringLiteral("hole")));
    QCOMPARE(hole.last().shape->holes().size(), std::size_t(1));
    PenRun redrawn;
    QVERIFY(redrawn.play(QStringLiteral("redrawn")));
    QCOMPARE(redrawn.last().shape->contour().segmentCount(), 3);
    QCOMPARE(redrawn.session.history()->undoText(), QStringLiteral("Redraw Section 1"));
}

void TestPenScripts::parallelPlanesLieAtTheirDistance()
{
    PenRun run;
    QVERIFY(run.play(QStringLiteral("parallel_plane")));
    const Frame &first = run.sections()[0]->frame, &second = run.last().frame;
    QVERIFY(first.normal().cross(second.normal()).norm() < 1e-12);
    QVERIFY(std::abs(first.height(second.origin) - 20.0) < 1e-9);
}

void TestPenScripts::theGroundCutsFlat()
{
    PenRun run;
    QVERIFY(run.play(QStringLiteral("cut_at_the_ground")));
    const std::vector<Vec3> corners = run.corners();
    QVERIFY(has(corners, {-40, 0, 0}) && has(corners, {40, 0, 0}));
    QVERIFY(std::abs(run.last().shape->area() - 80.0 * 60.0) < 1e-6);
}

void TestPenScripts::theViewComesBack()
{
    for (const char *name : {"escape_in_the_turn", "escape_brings_the_view_back"}) {
        PenRun run, plain;
        QVERIFY(run.play(QLatin1String(name)));
        QVERIFY(plain.play(QStringLiteral("first_section")));
        const Camera &now = run.interaction.camera(), &before = plain.interaction.camera();
        QVERIFY(now.orientation.angularDistance(before.orientation) < 1e-9);
        QVERIFY((now.target - before.target).norm() < 1e-9);
    }
}

FFF_TEST(TestPenScripts)
#include "tests/told.h"
#include "tst_pen_scripts.moc"
