// What is drawn on a section is drawn as it is seen: which way the view turns for it, and whether.
// Rulers and shapes by numbers where whoever looks has them before their eyes.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/draw_words.h"
#include "core/interaction/facing.h"
#include "core/interaction/mark_words.h"
#include "core/interaction/snapping.h"
#include "core/interaction/stroke_gesture.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

/// A plate turned about the upright and then leaning back, seen from the front; selected.
void addTurnedPlate(Desk &desk, double turn, double lean = 0.0)
{
    const Eigen::AngleAxisd about(radians(turn), Vec3::UnitY());
    const Eigen::AngleAxisd back(-radians(lean), Vec3::UnitX());
    const Frame frame{Vec3(30, 120, -20), about * (back * Vec3::UnitX()),
                      about * (back * Vec3::UnitY())};
    desk.session.commit(QStringLiteral("Draw"),
                        withSection(desk.session.committed().document,
                                    polygonShape(rectangle(-60, -40, 60, 40)), frame));
    desk.interaction.select({desk.sections().back()->id});
}

Vec2 on(const Desk &desk, double x, double y)
{
    return desk.screen(desk.sections().back()->frame.toWorld({x, y}));
}

double turnedBy(const Camera &a, const Camera &b)
{
    return degrees(a.orientation.angularDistance(b.orientation));
}

/// Of the plane's normal to the line of sight, degrees; above 90 it is seen from behind.
double facedAt(const Desk &desk, const Section &section)
{
    return degrees(std::acos(
        std::clamp(section.frame.normal().dot(desk.interaction.camera().backward()), -1.0, 1.0)));
}

} // namespace

class TestFacing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holesAreDrawnAsTheSectionIsSeen_data();
    void holesAreDrawnAsTheSectionIsSeen();
    void theFirstDragSaysWhatTheHoleIsIn();
    void aClickPicksWhatTheHoleIsIn();
    void slitsTurnToTheNearerSideWhateverTheLean();
    void engravingIsOnTheFrontAndReadsRight_data();
    void engravingIsOnTheFrontAndReadsRight();
    void rulersCountFromTheSectionsOrigin();
    void snappingOnAGridOfItsOwnKnowsTheGround();
    void figuresComeBeforeWhoeverLooks();
    void theFirstSectionDoesNotLean();
};

void TestFacing::holesAreDrawnAsTheSectionIsSeen_data()
{
    QTest::addColumn<double>("turn");
    for (const double turn : {0.0, 20.0, -29.0, 31.0, 50.0, -80.0, 100.0, 140.0, 155.0, 180.0})
        QTest::addRow("turned by %g", turn) << turn;
}

void TestFacing::holesAreDrawnAsTheSectionIsSeen()
{
    QFETCH(double, turn);
    const double off = std::min(std::abs(turn), 180.0 - std::abs(turn));
    for (const char *command : {"section.addHole", "section.redraw"}) {
        Desk desk;
        addTurnedPlate(desk, turn);
        const Camera before = desk.interaction.camera();
        desk.run(command);
        desk.wait(2000.0);
        const double now = turnedBy(before, desk.interaction.camera());
        if (off < 30.0)
            QVERIFY(isSameCamera(before, desk.interaction.camera()));
        else
            QVERIFY2(std::abs(now - off) < 0.1, qPrintable(QString::number(now)));
        // And it can be drawn on at once.
        desk.press(on(desk, -20, -20));
        for (const Vec2 &p : {Vec2(20, -20), Vec2(20, 20), Vec2(-20, 20)})
            desk.moveTo(on(desk, p.x(), p.y()));
        desk.release(desk.cursor);
        QCOMPARE(desk.steps(), 2);
        QCOMPARE(desk.sections().size(), std::size_t(1));
    }
}

// Wrong: who is told that O draws holes presses O, draws, and has a slit, or nothing.
void TestFacing::theFirstDragSaysWhatTheHoleIsIn()
{
    for (const double turn : {0.0, 50.0, 140.0}) {
        Desk desk;
        desk.addPlate(-200.0);
        addTurnedPlate(desk, turn);
        desk.interaction.select({});
        const Camera before = desk.interaction.camera();
        desk.run("section.addHole");
        QCOMPARE(desk.hint(), hints::kDrawHoleOnAny);
        desk.drag({on(desk, -20, -20), on(desk, 20, -20), on(desk, 20, 20), on(desk, -20, 20),
                   on(desk, -20, -20)});
        QCOMPARE(desk.sections().back()->shape->holes().size(), std::size_t(1));
        const Box2 hole = desk.sections().back()->shape->holes().front().bounds();
        QVERIFY(hole.center().norm() < 5.0);
        QVERIFY((hole.max - hole.min - Vec2(40, 40)).norm() < 10.0);
        QCOMPARE(desk.interaction.selection(), std::vector{desk.sections().back()->ref()});
        QVERIFY(turnedBy(before, desk.interaction.camera()) < 1e-6);
        QVERIFY(!desk.interaction.tool());
    }
}

// Wrong: a click beside any section, or on one, would end it.
void TestFacing::aClickPicksWhatTheHoleIsIn()
{
    Desk desk;
    addTurnedPlate(desk, 50.0);
    desk.interaction.select({});
    const Camera before = desk.interaction.camera();
    desk.run("section.addHole");
    desk.click(Vec2(5, 5));
    QCOMPARE(desk.hint(), hints::kDrawHoleOnAny);
    desk.click(on(desk, 0, 0));
    desk.wait(2000.0);
    QCOMPARE(desk.hint(), hints::kDrawHole);
    QVERIFY(std::abs(turnedBy(before, desk.interaction.camera()) - 50.0) < 0.1);
    desk.drag({on(desk, -20, -20), on(desk, 20, -20), on(desk, 20, 20), on(desk, -20, 20)});
    QCOMPARE(desk.sections().back()->shape->holes().size(), std::size_t(1));
    // Asked for again it is laid down.
    desk.interaction.select({});
    desk.run("section.addHole");
    QVERIFY(desk.interaction.tool());
    desk.run("section.addHole");
    QVERIFY(!desk.interaction.tool());
}

/// The new section leans by −5° … 5° from upright: the turn is to the side that is nearer.
void TestFacing::slitsTurnToTheNearerSideWhateverTheLean()
{
    for (const double turn : {-70.0, -50.0, -20.0, 0.0, 20.0, 50.0, 70.0})
        for (int lean = -5; lean <= 5; ++lean)
            for (const bool isSectionLeaning : {false, true}) {
                Desk desk;
                desk.interaction.settings().snaps = false;
                addTurnedPlate(desk, turn, isSectionLeaning ? lean : 0.0);
                const Camera before = desk.interaction.camera();
                const double slit = isSectionLeaning ? 0.0 : std::tan(radians(lean)) * 60.0;
                desk.press(on(desk, 0, 0));
                desk.moveTo(on(desk, 0.7 * slit, 42), {}, 1);
                desk.wait(kTurnTime);
                QVERIFY(desk.interaction.overlay().find<sign::Capsule>());
                const Vec3 normal =
                    desk.interaction.overlay().find<sign::Capsule>()->canvas.normal();
                const Camera &after = desk.interaction.camera();
                QVERIFY(normal.dot(after.backward()) > 0.86);
                QVERIFY2(normal.dot(before.backward()) > -0.0088,
                         qPrintable(QStringLiteral("turned %1, leaning %2").arg(turn).arg(lean)));
                QVERIFY(turnedBy(before, after) < 95.0);
            }
}

void TestFacing::engravingIsOnTheFrontAndReadsRight_data()
{
    QTest::addColumn<double>("turn");
    for (const double turn : {0.0, 25.0, -50.0, 80.0, 100.0, 150.0, 180.0})
        QTest::addRow("turned by %g", turn) << turn;
}

// Wrong: what is written from behind is cut as its mirror image.
void TestFacing::engravingIsOnTheFrontAndReadsRight()
{
    QFETCH(double, turn);
    Desk desk;
    addTurnedPlate(desk, turn);
    const Camera before = desk.interaction.camera();
    desk.run("section.mark");
    QCOMPARE(desk.hint() == hints::kEngravesFront, std::abs(turn) > 90.0);
    desk.wait(2000.0);
    if (std::abs(turn) < 30.0)
        QVERIFY(isSameCamera(before, desk.interaction.camera()));
    QVERIFY(facedAt(desk, *desk.sections().back()) < 30.0); // never from behind
    const Vec2 at = on(desk, 15, -10);
    desk.click(at);
    QCOMPARE(desk.sections().back()->marks.size(), std::size_t(1));
    const Section &section = *desk.sections().back();
    const Lettering &words = *section.marks.front()->lettering;
    QVERIFY((words.at - Vec2(15, -10)).norm() < 0.6);
    // From left to right for who clicked, and upright.
    const Vec2 along(std::cos(words.turn), std::sin(words.turn));
    const Vec2 seen = desk.screen(section.frame.toWorld(words.at + along)) -
                      desk.screen(section.frame.toWorld(words.at));
    QVERIFY(seen.x() > 0.0 && std::abs(seen.y()) < 1e-6 * seen.x() + 1e-9);
}

// Wrong: on a plane that rises by 3° they count from where it meets the ground, metres away.
void TestFacing::rulersCountFromTheSectionsOrigin()
{
    for (const double lean : {0.0, 3.0, 60.0, 87.0, 88.0, 90.0}) {
        Desk desk;
        addTurnedPlate(desk, 10.0, lean);
        const Vec3 origin = desk.sections().back()->frame.origin;
        for (const char *command : {"section.redraw", "section.mark"}) {
            desk.run(command);
            desk.wait(2000.0);
            desk.moveTo(on(desk, 0, 0));
            const auto *rulers = desk.interaction.overlay().find<sign::Rulers>();
            QVERIFY(rulers);
            QVERIFY((rulers->grid.origin - origin).norm() < 1e-9);
            desk.interaction.layDown(desk.time);
            desk.wait(2000.0);
        }
        // Of a new section from where its slit begins.
        Camera front;
        front.target = origin;
        front.millimetresPerPixel = 0.5;
        if (lean > 45.0)
            QVERIFY(orientationOfView("top", front.orientation));
        desk.interaction.setCamera(front);
        desk.press(on(desk, 10, 5));
        desk.moveTo(on(desk, 75, 8));
        desk.wait(kTurnTime);
        const Vec2 start = desk.cursor;
        for (const Vec2 &p : {Vec2(90, 60), Vec2(90, -80), Vec2(-80, -80)})
            desk.moveTo(start + p);
        const auto *rulers = desk.interaction.overlay().find<sign::Rulers>();
        QVERIFY(rulers);
        const Vec3 counted = rulers->grid.origin;
        desk.release(desk.cursor);
        QCOMPARE(desk.sections().size(), std::size_t(2));
        QVERIFY((counted - desk.sections().back()->frame.origin).norm() < 1e-9);
    }
}

void TestFacing::snappingOnAGridOfItsOwnKnowsTheGround()
{
    const Frame canvas{Vec3(10, 83, 5), Vec3::UnitX(), Vec3(0, 0.8, -0.6)};
    const Eigen::Quaterniond front = Eigen::Quaterniond::Identity();
    const SnapTargets far(canvas, front), own(canvas, ownGrid(canvas, front));
    QVERIFY(own.toGrid(Vec2::Zero()).norm() < 1e-12);
    QVERIFY(std::abs(*far.ground()) < 1e-9);
    const Vec3 ground = own.grid().toWorld({30.0, *own.ground()});
    QVERIFY(std::abs(ground.y()) < 1e-9);
    const Vec2 near = own.fromGrid({33.0, *own.ground() + 1.5});
    const Snap snap = snapped(near, own, 0.5, {});
    QVERIFY(snap.isOnGround);
    QVERIFY(std::abs(canvas.toWorld(snap.point).y()) < 1e-9);
}

// Wrong: a shape by numbers lies behind the model, or on a plane that is seen on edge.
void TestFacing::figuresComeBeforeWhoeverLooks()
{
    for (const char *view : {"front", "right", "back", "top", "iso1", "iso3"})
        for (const double turn : {0.0, 35.0, 90.0, 170.0})
            for (const double lean : {0.0, 30.0, 88.0})
                for (const bool isSelected : {false, true}) {
                    Desk desk;
                    desk.addPlate(-40.0);
                    addTurnedPlate(desk, turn, lean);
                    const SectionRef plane = desk.sections()[isSelected ? 0 : 1]->id;
                    desk.interaction.select(isSelected ? std::vector<SectionRef>{plane}
                                                       : std::vector<SectionRef>());
                    Camera camera = desk.interaction.camera();
                    QVERIFY(orientationOfView(view, camera.orientation));
                    desk.interaction.setCamera(camera);
                    desk.run("section.addStar", {{"as", "section"}});
                    desk.wait(2000.0);
                    QCOMPARE(desk.sections().size(), std::size_t(3));
                    const Section &star = *desk.sections().back();
                    const Section &on = *desk.session.committed().find(plane);
                    QVERIFY(star.frame.normal().cross(on.frame.normal()).norm() < 1e-9);
                    QVERIFY(std::abs(on.frame.height(star.frame.origin)) < 1e-6);
                    QVERIFY(isFaced(star.frame.normal(), desk.interaction.camera().backward()));
                    for (const Vec2 &p : star.shape->region().outer) {
                        const Vec2 at = desk.screen(star.frame.toWorld(p));
                        QVERIFY((at.array() > 0.0).all() && (at.array() < kViewport.array()).all());
                        QVERIFY(star.frame.toWorld(p).y() > -1e-6 || lean > 45.0);
                        QVERIFY(locate(on.frame.toLocal(star.frame.toWorld(p)),
                                       on.shape->region()) == Side::Outside);
                    }
                }
    // Without anything there, in a plane that is faced.
    for (const char *view : {"front", "right", "top", "iso2"}) {
        Desk desk;
        Camera camera = desk.interaction.camera();
        QVERIFY(orientationOfView(view, camera.orientation));
        desk.interaction.setCamera(camera);
        desk.run("section.addCircle");
        desk.wait(2000.0);
        QCOMPARE(desk.sections().size(), std::size_t(1));
        QVERIFY(
            isFaced(desk.sections().front()->frame.normal(), desk.interaction.camera().backward()));
    }
}

// Wrong: drawn in a view of a corner, the first section leaned in two directions, and so did all
// that was drawn on it.
void TestFacing::theFirstSectionDoesNotLean()
{
    for (double turn = -180.0; turn <= 180.0; turn += 7.5) {
        for (double down = -90.0; down <= 90.0; down += 7.5) {
            Camera camera;
            camera.orientation = Eigen::AngleAxisd(radians(turn), Vec3::UnitY()) *
                                 Eigen::AngleAxisd(-radians(down), Vec3::UnitX());
            const Frame canvas = firstCanvas(camera);
            const Vec3 normal = canvas.normal();
            QVERIFY(std::abs(normal.norm() - 1.0) < 1e-12);
            QVERIFY(std::abs(std::abs(down) < 45.0 ? normal.y() : std::abs(normal.y()) - 1.0) <
                        1e-12 ||
                    std::abs(down) == 45.0);
            // Seen from its front, the right to the right.
            QVERIFY(normal.dot(camera.backward()) > 0.7);
            QVERIFY(canvas.x.dot(camera.right()) > 0.96);
            QVERIFY(canvas.y.dot(camera.up()) > 0.7);
            if (std::abs(std::remainder(turn, 90.0)) < 15.0)
                QVERIFY(std::abs(canvas.x.cwiseAbs().maxCoeff() - 1.0) < 1e-12);
        }
    }
    Camera front;
    QVERIFY(firstCanvas(front) ==
            (Frame{Vec3(0.0, kFirstPlaneHeight, 0.0), Vec3::UnitX(), Vec3::UnitY()}));
}

FFF_TEST(TestFacing)
#include "tst_facing.moc"
