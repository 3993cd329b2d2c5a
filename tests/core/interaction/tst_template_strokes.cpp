// Sections that are drawn over a mesh: along its cut, free of it, and of all of it at once.
#include "tests/core/interaction/desk.h"

#include "core/assembly/joint_state.h"
#include "core/geometry/segment_distance.h"
#include "core/interaction/pen_marks.h"
#include "core/interaction/template_guides.h"
#include "core/io/document_file.h"
#include "core/io/fff_format.h"
#include "core/model/figures.h"
#include "core/model/point_edits.h"
#include "core/model/template_edits.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_cut.h"
#include "core/templates/template_mesh.h"
#include "tests/core/io/written_meshes.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kBall = 60.0; // mm, radius

/// A mesh whose middle is that of the first plane.
void addMesh(Desk &desk, const MeshDraft &draft)
{
    Template one;
    one.name = "Ball";
    one.file = "ball.stl";
    one.mesh = makeTemplateMesh(mended(draft).value().mesh, {}).value();
    one.scale = 1.0;
    one.frame.origin = {0.0, kFirstPlaneHeight, 0.0};
    const Document next = addTemplate(desk.session.committed().document, one).value();
    desk.session.commit(QStringLiteral("Add template"), next);
}

void addBall(Desk &desk)
{
    addMesh(desk, sphere(kBall, 120, 180));
}

/// Four quarters, off the circle by a 4000th of its radius.
CurvePath circle(double radius)
{
    constexpr double kHandle = 0.5519150244935106;
    std::vector<Vec2> points{{radius, 0.0}};
    Vec2 from(radius, 0.0);
    for (int i = 0; i < 4; ++i) {
        const Vec2 to = perpendicular(from);
        points.insert(points.end(), {from + kHandle * to, to + kHandle * from, to});
        from = to;
    }
    points.back() = points.front();
    return CurvePath::fromPoints(std::move(points)).value();
}

/// A drawing as large as the ball, with a hole in it and an upright line to its left, so far before
/// the first plane.
void addRings(Desk &desk, double before = 0.0, bool isFlipped = false)
{
    Template one;
    one.kind = TemplateKind::Curves;
    one.name = "Rings";
    one.file = "rings.svg";
    std::vector<CurvePath> lines{circle(kBall), circle(25.0)};
    for (const double x : {-90.0, 90.0}) // so that the middle is that of the rings
        lines.push_back(CurvePath::fromLine({{x, -50.0}, {x, 50.0}}).value());
    one.curves = makeTemplateCurves(std::move(lines)).value();
    one.frame.origin = {0.0, kFirstPlaneHeight, before};
    one.isFlipped = isFlipped;
    const Document next = addTemplate(desk.session.committed().document, one).value();
    desk.session.commit(QStringLiteral("Add template"), next);
}

/// How far the contour is from the ball, at most, mm.
double offBall(const Section &section)
{
    double most = 0.0;
    for (const Vec2 &p : section.shape->contour().polygon(0.005)) {
        const Vec3 at = section.frame.toWorld(p) - Vec3(0.0, kFirstPlaneHeight, 0.0);
        most = std::max(most, std::abs(at.norm() - kBall));
    }
    return most;
}

/// Round in the front plane, so far off the ball's outline, with a wobble.
void drawRound(Desk &desk, double off, double share, Modifiers modifiers = {})
{
    const auto at = [&](double t) {
        const double a = 2.0 * std::numbers::pi * t;
        const double r = kBall + off + 1.5 * std::sin(19.0 * t) + std::sin(53.0 * t);
        return desk.plate(r * std::cos(a), r * std::sin(a));
    };
    desk.moveTo(at(0.0), modifiers);
    desk.press(at(0.0), Button::Left, modifiers);
    for (int i = 1; i <= 90; ++i)
        desk.moveTo(at(share * i / 90), modifiers, 1);
    desk.release(desk.cursor, Button::Left, modifiers);
}

constexpr double kAcross = 20.0; // mm

/// A plate that stands across the first plane, away from the outline of the ball.
void addAcross(Desk &desk)
{
    const Frame frame{{kAcross, kFirstPlaneHeight, 0.0}, -Vec3::UnitZ(), Vec3::UnitY()};
    desk.session.commit(QStringLiteral("Draw"),
                        withSection(desk.session.committed().document,
                                    polygonShape(rectangle(-30, -15, 30, 15)), frame));
}

const sign::Guides *guidesShown(const Desk &desk)
{
    return desk.interaction.overlay().drawn.find<sign::Guides>();
}

} // namespace

class TestTemplateStrokes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFirstSectionFollowsTheMesh();
    void ctrlAndSnapLeaveIt();
    void onlyWhatIsNearIsCaught();
    void whatItFollowsIsTold();
    void aSectionAcrossFollowsIt();
    void theWholeGuideAtOnce();
    void itSlidesInFromWhereTheStrokeLeft_data();
    void itSlidesInFromWhereTheStrokeLeft();
    void holesOfTheCutAreHolesOfTheSection();
    void aSlitBesideTheMesh();
    void aPlaneIsTakenWithAClick();
    void hiddenOnesAreNoGuides();
    void pointsOfThePenLieOnTheMesh();
    void draggedPointsComeToLieOnTheMesh();
    void draggedPointsAreCaughtWherePlanesCross();
    void shapesLieAtGuides();
    void undoGivesBackWhatWasThere();
    void linesOfADrawingAreGuides();
    void ofADrawingAllAtOnce();
    void openLinesCatchPointsToo();
    void aDrawingInAnotherPlaneIsNone();
    void aDrawingOnASectionIsAGuideForItsHoles();
    void fromTheFileToUndone_data();
    void fromTheFileToUndone();
};

void TestTemplateStrokes::theFirstSectionFollowsTheMesh()
{
    Desk desk;
    addBall(desk);
    drawRound(desk, 3.0, 0.98);
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY2(offBall(*desk.sections()[0]) < 0.06,
             qPrintable(QString::number(offBall(*desk.sections()[0]))));
    QVERIFY(desk.sections()[0]->shape->contour().segmentCount() < 24);
}

void TestTemplateStrokes::ctrlAndSnapLeaveIt()
{
    Desk free;
    addBall(free);
    free.interaction.settings().snaps = false;
    drawRound(free, 3.0, 0.98);
    QCOMPARE(free.sections().size(), std::size_t(1));
    QVERIFY(offBall(*free.sections()[0]) > 2.0);
}

// Wrong: from how far a stroke is caught cannot be set.
void TestTemplateStrokes::onlyWhatIsNearIsCaught()
{
    Desk desk;
    addBall(desk);
    desk.interaction.settings().guideReach = 0.2;
    drawRound(desk, 3.0, 0.98);
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY(offBall(*desk.sections()[0]) > 2.0);
    desk.run("edit.undo");
    desk.run("section.pen");
    for (double angle : {0.3, 1.4, 2.9, 4.1, 5.5})
        desk.click(desk.plate((kBall + 1.0) * std::cos(angle), (kBall + 1.0) * std::sin(angle)));
    const PenMarks *path = desk.interaction.overlay().find<PenMarks>();
    QVERIFY(path && path->points.size() == 5);
    for (const PathPoint &point : path->points)
        QVERIFY(std::abs(point.at.norm() - kBall) > 0.05);
}

/// While it is drawn: on which template, how much of it and how far off the rest is.
void TestTemplateStrokes::whatItFollowsIsTold()
{
    Desk desk;
    addBall(desk);
    const auto at = [&](double angle, double off) {
        return desk.plate((kBall + off) * std::cos(angle), (kBall + off) * std::sin(angle));
    };
    desk.moveTo(at(0.0, 1.0));
    desk.press(at(0.0, 1.0));
    for (int i = 1; i <= 40; ++i)
        desk.moveTo(at(0.04 * i, 1.0), {}, 20);
    QVERIFY(guidesShown(desk) && guidesShown(desk)->followed);
    QCOMPARE(guidesShown(desk)->followed->name, std::string("Ball"));
    QVERIFY(guidesShown(desk)->followed->isBegun);
    QVERIFY(guidesShown(desk)->followed->share > 0.95);
    QVERIFY(guidesShown(desk)->followed->farthest < 1.5);
    for (int i = 1; i <= 40; ++i)
        desk.moveTo(at(1.6 + 0.04 * i, 30.0 * std::sin(0.05 * i)), {}, 20);
    const sign::FollowedGuide told = *guidesShown(desk)->followed;
    QVERIFY2(told.share > 0.4 && told.share < 0.8, qPrintable(QString::number(told.share)));
    QVERIFY2(std::abs(told.farthest - 30.0) < 2.0, qPrintable(QString::number(told.farthest)));
    desk.release(desk.cursor);

    Desk free; // nothing is caught
    addBall(free);
    free.run("section.snap");
    free.moveTo(free.plate(kBall, 0.0));
    free.press(free.plate(kBall, 0.0));
    free.moveTo(free.plate(kBall, 20.0), {}, 20);
    free.moveTo(free.plate(kBall - 5.0, 40.0), {}, 20);
    QVERIFY(guidesShown(free) && !guidesShown(free)->followed);
}

/// Both halves of the stroke: a plane of its own, whose cut is another circle.
void TestTemplateStrokes::aSectionAcrossFollowsIt()
{
    Desk desk;
    addBall(desk);
    drawRound(desk, 2.0, 0.98);
    QCOMPARE(desk.sections().size(), std::size_t(1));
    desk.moveTo(desk.plate(20, 30));
    desk.press(desk.plate(20, 30));
    desk.moveTo(desk.plate(20, 62));
    QVERIFY(guidesShown(desk));
    desk.wait(2000.0); // the view turns
    QVERIFY(guidesShown(desk));
    QVERIFY(desk.interaction.hasGuide());
    const sign::Guides guides = *guidesShown(desk);
    QCOMPARE(guides.loops->size(), std::size_t(1));
    // Along it from where it is nearest, all round.
    Polygon loop = guides.loops->front().points;
    const auto start =
        std::min_element(loop.begin(), loop.end(), [&](const Vec2 &a, const Vec2 &b) {
            const Vec2 end(32.0, 0.0);
            return (a - end).norm() < (b - end).norm();
        });
    std::rotate(loop.begin(), start, loop.end());
    for (std::size_t i = 0; i < loop.size(); i += 3)
        desk.moveTo(desk.screen(guides.canvas.toWorld(1.02 * loop[i])), {}, 1);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY2(offBall(*desk.sections()[1]) < 0.06,
             qPrintable(QString::number(offBall(*desk.sections()[1]))));
    QVERIFY(desk.sections()[1]->parent);
    QCOMPARE(desk.session.currentAnalysis().assembly.joints.size(), std::size_t(1));
}

void TestTemplateStrokes::theWholeGuideAtOnce()
{
    Desk desk;
    addBall(desk);
    drawRound(desk, 2.0, 0.98);
    desk.moveTo(desk.plate(10, 30));
    desk.press(desk.plate(10, 30));
    desk.moveTo(desk.plate(12, 66));
    desk.wait(2000.0);
    QVERIFY(desk.commands.isEnabled("section.takeGuide"));
    const int steps = desk.steps();
    desk.run("section.takeGuide");
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QCOMPARE(desk.steps(), steps + 1);
    QVERIFY(offBall(*desk.sections()[1]) < 0.06);
    QVERIFY(!desk.interaction.hasGesture());
    desk.release(desk.cursor); // comes to nothing more
    QCOMPARE(desk.sections().size(), std::size_t(2));
}

void TestTemplateStrokes::itSlidesInFromWhereTheStrokeLeft_data()
{
    QTest::addColumn<double>("side");
    QTest::newRow("upwards") << 1.0;
    QTest::newRow("downwards") << -1.0;
}

// Wrong: two discs through each other opened upwards, wherever the stroke had left.
void TestTemplateStrokes::itSlidesInFromWhereTheStrokeLeft()
{
    QFETCH(double, side);
    Desk desk;
    addBall(desk);
    drawRound(desk, 2.0, 0.98);
    desk.moveTo(desk.plate(10, 30 * side));
    desk.press(desk.plate(10, 30 * side));
    desk.moveTo(desk.plate(10, 66 * side));
    desk.wait(2000.0);
    desk.run("section.takeGuide");
    desk.release(desk.cursor);
    const Model &model = desk.session.model();
    QCOMPARE(model.sectionCount(), std::size_t(2));
    const auto state = jointState(model, JointRef(model.ref(0), model.ref(1)));
    QVERIFY(state && state->sign != 0);
    QVERIFY(-state->openingOfB().y() * side > 0.9); // the first one's
    desk.run("edit.undo");
    QCOMPARE(desk.sections().size(), std::size_t(1));
}

void TestTemplateStrokes::holesOfTheCutAreHolesOfTheSection()
{
    Desk desk;
    addMesh(desk, torus(60, 20, 160, 80)); // about z: the front plane cuts a ring
    drawRound(desk, 80.0 - kBall, 0.5);    // any stroke, to have the guides
    desk.run("edit.undo");
    desk.moveTo(desk.plate(80, 0));
    desk.press(desk.plate(80, 0));
    desk.moveTo(desk.plate(80, 20));
    QVERIFY(desk.interaction.hasGuide());
    desk.run("section.takeGuide");
    QCOMPARE(desk.sections().size(), std::size_t(1));
    const Shape &shape = *desk.sections()[0]->shape;
    QCOMPARE(shape.holes().size(), std::size_t(1));
    const double pi = std::numbers::pi;
    QVERIFY(std::abs(shape.area() / (pi * (6400 - 1600)) - 1.0) < 0.01);
}

void TestTemplateStrokes::aSlitBesideTheMesh()
{
    Desk desk;
    addMesh(desk, sphere(10.0, 40, 60));
    desk.addPlate(0.0, {100, 60});
    desk.moveTo(desk.plate(80, 30));
    desk.press(desk.plate(80, 30));
    desk.moveTo(desk.plate(80, 75));
    desk.wait(2000.0);
    // The plane at x = 80 does not meet the small ball at all.
    QVERIFY(!desk.interaction.hasGuide());
    desk.run("section.takeGuide"); // does nothing
    QCOMPARE(desk.sections().size(), std::size_t(1));
}

void TestTemplateStrokes::aPlaneIsTakenWithAClick()
{
    Desk desk;
    addBall(desk);
    desk.run("section.planeFront");
    desk.wait(2000.0);
    QVERIFY(desk.interaction.hasGuide());
    const sign::Guides *guides = desk.interaction.overlay().held.find<sign::Guides>();
    QVERIFY(guides);
    desk.click(desk.screen(guides->canvas.toWorld(guides->loops->front().points[7])));
    QCOMPARE(desk.sections().size(), std::size_t(1));
}

void TestTemplateStrokes::hiddenOnesAreNoGuides()
{
    Desk desk;
    addBall(desk);
    desk.run("template.set", {{"template", "Ball"}, {"hidden", "true"}});
    drawRound(desk, 3.0, 0.98);
    QVERIFY(offBall(*desk.sections()[0]) > 2.0);
}

// Wrong: a stroke follows the mesh, but a point of the pen is set beside it.
void TestTemplateStrokes::pointsOfThePenLieOnTheMesh()
{
    const auto off = [](const Vec2 &p) { return std::abs(p.norm() - kBall); };
    for (const bool isFree : {false, true}) {
        Desk desk;
        addBall(desk);
        desk.run("section.pen");
        for (double angle : {0.3, 1.4, 2.9, 4.1, 5.5}) {
            const double r = kBall + 4.0 * std::cos(7.0 * angle);
            desk.click(desk.plate(r * std::cos(angle), r * std::sin(angle)),
                       isFree ? kControl : Modifiers{});
        }
        QVERIFY(desk.interaction.overlay().find<sign::Guides>());
        const PenMarks *path = desk.interaction.overlay().find<PenMarks>();
        QCOMPARE(path->points.size(), std::size_t(5));
        double most = 0.0;
        for (const PathPoint &point : path->points)
            most = std::max(most, off(point.at));
        QVERIFY2(isFree ? most > 1.0 : most < 0.05, qPrintable(QString::number(most)));
    }
}

// The same of a point that is dragged; what is held with it moves along.
void TestTemplateStrokes::draggedPointsComeToLieOnTheMesh()
{
    Desk desk;
    addBall(desk);
    desk.addPlate(0.0, {30, 20});
    desk.interaction.select({desk.sections().front()->id});
    const auto corner = [&desk] { return position(*desk.sections().front()->shape, {0, 2}); };
    const Vec2 before = corner();
    const Vec2 nearBall = (kBall - 0.8) * before.normalized();
    desk.drag({desk.plate(before.x(), before.y()), desk.plate(nearBall.x(), nearBall.y())});
    QVERIFY(std::abs(corner().norm() - kBall) < 0.05);
    desk.session.history()->undo();
    desk.interaction.settings().snaps = false;
    desk.drag({desk.plate(before.x(), before.y()), desk.plate(nearBall.x(), nearBall.y())});
    QVERIFY((corner() - nearBall).norm() < 1e-6);
}

// Wrong: a contour that goes through where two sections meet is a little off the other one's.
void TestTemplateStrokes::draggedPointsAreCaughtWherePlanesCross()
{
    const Vec2 crossing(kAcross, std::sqrt(kBall * kBall - kAcross * kAcross));
    Desk desk;
    addBall(desk);
    desk.addPlate(0.0, {30, 20});
    const SectionId plate = desk.sections().front()->id;
    addAcross(desk);
    desk.interaction.select({plate});
    const auto corner = [&] {
        return position(*desk.session.committed().document.find(plate)->shape, {0, 2});
    };
    const Vec2 before = corner(), near = crossing + Vec2(0.6, -0.4);
    desk.drag({desk.plate(before.x(), before.y()), desk.plate(near.x(), near.y())});
    QVERIFY((corner() - crossing).norm() < 0.05);
    desk.session.history()->undo();
    // Past it the guide alone; hidden, the other section draws nothing to it.
    desk.drag({desk.plate(before.x(), before.y()), desk.plate(42.0, 44.0)});
    QVERIFY(std::abs(corner().norm() - kBall) < 0.05);
    QVERIFY((corner() - crossing).norm() > 10.0);
    desk.session.history()->undo();
    ViewState view = desk.interaction.view();
    view.hidden.insert(desk.sections().back()->ref());
    desk.interaction.setView(view);
    desk.interaction.select({plate});
    desk.drag({desk.plate(before.x(), before.y()), desk.plate(near.x(), near.y())});
    QVERIFY(std::abs(corner().norm() - kBall) < 0.05);
    QVERIFY((corner() - crossing).norm() > 0.3);
}

// The same of the middle of a shape.
void TestTemplateStrokes::shapesLieAtGuides()
{
    const Vec2 crossing(kAcross, std::sqrt(kBall * kBall - kAcross * kAcross));
    for (const bool isFree : {false, true}) {
        Desk desk;
        addBall(desk);
        addAcross(desk);
        desk.run("section.addShape", {{"figure", "circle"}});
        const auto middle = [&desk] {
            const Section &section = *desk.sections().back();
            const Vec3 at = section.frame.toWorld(figureOf(section, 0)->centre);
            return Vec2(at.x(), at.y() - kFirstPlaneHeight);
        };
        desk.interaction.settings().snaps = !isFree;
        desk.moveTo(desk.plate(crossing.x() + 0.6, crossing.y() - 0.4));
        QVERIFY(desk.interaction.overlay().find<sign::Guides>());
        desk.click(desk.plate(crossing.x() + 0.6, crossing.y() - 0.4));
        QCOMPARE(desk.sections().size(), std::size_t(2));
        QCOMPARE((middle() - crossing).norm() < 0.05, !isFree);
        desk.run("edit.undo");
        desk.click(desk.plate(-42.0, 44.0));
        QCOMPARE(desk.sections().size(), std::size_t(2));
        QCOMPARE(std::abs(middle().norm() - kBall) < 0.05, !isFree);
    }
}

void TestTemplateStrokes::undoGivesBackWhatWasThere()
{
    Desk desk;
    const Document before = desk.session.committed().document;
    addBall(desk);
    drawRound(desk, 2.0, 0.98);
    desk.run("template.set", {{"size", "200"}, {"x", "30"}, {"opacity", "50"}});
    const Template &one = *desk.session.committed().document.templates[0];
    QVERIFY(std::abs(one.scale * one.mesh->mesh->size() - 200.0) < 1e-9);
    QCOMPARE(one.opacity, 0.5);
    desk.run("template.toGround");
    QVERIFY(std::abs(worldBounds(*desk.session.committed().document.templates[0],
                                 *desk.session.committed().document.templates[0]->mesh)
                         .min.y()) < 1e-9);
    desk.run("template.remove");
    QVERIFY(desk.session.committed().document.templates.empty());
    while (desk.session.history()->canUndo())
        desk.run("edit.undo");
    QVERIFY(desk.session.committed().document == before);
}

// A drawing has the very lines that are followed.
void TestTemplateStrokes::linesOfADrawingAreGuides()
{
    for (const bool isFlipped : {false, true}) {
        Desk desk;
        addRings(desk, 0.0, isFlipped);
        drawRound(desk, 3.0, 0.98);
        QCOMPARE(desk.sections().size(), std::size_t(1));
        QVERIFY2(offBall(*desk.sections()[0]) < 0.05,
                 qPrintable(QString::number(offBall(*desk.sections()[0]))));
        QVERIFY(desk.sections()[0]->shape->contour().segmentCount() < 12);
    }
}

void TestTemplateStrokes::ofADrawingAllAtOnce()
{
    for (const bool isFlipped : {false, true}) {
        Desk desk;
        addRings(desk, 0.0, isFlipped);
        desk.moveTo(desk.plate(80, 0));
        desk.press(desk.plate(80, 0));
        desk.moveTo(desk.plate(80, 20));
        QVERIFY(desk.interaction.hasGuide());
        QCOMPARE(guidesShown(desk)->loops->size(), std::size_t(4));
        desk.run("section.takeGuide");
        QCOMPARE(desk.sections().size(), std::size_t(1));
        const Shape &shape = *desk.sections()[0]->shape;
        QCOMPARE(shape.contour().segmentCount(), 4);
        QCOMPARE(shape.holes().size(), std::size_t(1));
        QVERIFY(std::abs(shape.area() / (std::numbers::pi * (3600 - 625)) - 1.0) < 1e-3);
    }
}

// Wrong: an open line caught points between its end and its start.
void TestTemplateStrokes::openLinesCatchPointsToo()
{
    Desk desk;
    addRings(desk);
    desk.run("section.pen");
    desk.click(desk.plate(-92, 30));
    desk.click(desk.plate(-88, -20));
    desk.click(desk.plate(-75, 0));
    desk.click(desk.plate(23, 4));
    const PenMarks *path = desk.interaction.overlay().find<PenMarks>();
    QVERIFY(path && path->points.size() == 4);
    QCOMPARE(path->points[0].at.x(), -90.0);
    QCOMPARE(path->points[1].at.x(), -90.0);
    QVERIFY(path->points[2].at.x() > -80.0);
    QVERIFY(std::abs(path->points[3].at.norm() - 25.0) < 0.05);
}

void TestTemplateStrokes::aDrawingInAnotherPlaneIsNone()
{
    Desk desk;
    addRings(desk, 0.2);
    drawRound(desk, 3.0, 0.98);
    QVERIFY(offBall(*desk.sections()[0]) > 2.0);
}

void TestTemplateStrokes::aDrawingOnASectionIsAGuideForItsHoles()
{
    Desk desk;
    desk.addPlate(0.0, {150, 80});
    const Section &plate = *desk.sections()[0];
    addRings(desk, 40.0);
    desk.interaction.select({plate.id});
    desk.run("template.lay", {{"plane", "section"}});
    desk.run("template.set", {{"size", "60"}});
    const TemplateGuides guides(desk.session.committed(), nullptr, plate.frame);
    QVERIFY(!guides.isEmpty());
    const auto whole = guides.whole(0.0);
    QVERIFY(whole && whole->holes.size() == 1);
    QVERIFY((whole->contour.bounds().center() - plate.shape->bounds().center()).norm() < 1e-6);
    QVERIFY(std::abs(whole->contour.signedArea() / (std::numbers::pi * 400.0) - 1.0) < 1e-3);
    // Across it there is none.
    const Frame across{plate.frame.origin, plate.frame.x, plate.frame.normal()};
    QVERIFY(TemplateGuides(desk.session.committed(), nullptr, across).isEmpty());
}

void TestTemplateStrokes::fromTheFileToUndone_data()
{
    QTest::addColumn<bool>("isMesh");
    QTest::newRow("a mesh") << true;
    QTest::newRow("a drawing") << false;
}

/// All of it as one sitting: a file, a section along its guide, another one across, a whole guide,
/// saved and opened, and everything undone. What was caught lies on what was cut to 0.05 mm.
void TestTemplateStrokes::fromTheFileToUndone()
{
    QFETCH(const bool, isMesh);
    QTemporaryDir folder;
    const QString path =
        folder.filePath(isMesh ? QStringLiteral("ball.stl") : QStringLiteral("disc.svg"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(isMesh ? QByteArray::fromStdString(stlBytes(sphere(kBall, 120, 180)))
                      : QByteArray("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"120mm\" "
                                   "height=\"120mm\" viewBox=\"0 0 120 120\">"
                                   "<circle cx=\"60\" cy=\"60\" r=\"60\"/></svg>"));
    file.close();
    Desk desk;
    const Document beginning = desk.session.committed().document;
    desk.run("template.add", {{"file", path.toStdString()}, {"size", "120"}});
    desk.run("template.set", {{"y", std::to_string(kFirstPlaneHeight)}});
    const auto offGuide = [&desk](const Section &section) {
        const Template &one = *desk.session.committed().document.templates.front();
        const std::vector<TemplateLoop> loops =
            one.mesh ? loopsOn(section.frame, one, *one.mesh)
                     : loopsOn(section.frame, one, *worldPlacement(one, desk.session.committed()),
                               *one.curves);
        double most = 0.0;
        for (const Vec2 &p : section.shape->contour().polygon(0.002)) {
            double nearest = 1e9;
            for (const TemplateLoop &loop : loops)
                for (std::size_t i = 0; i < loop.points.size(); ++i)
                    nearest = std::min(
                        nearest, distanceToSegment(p, loop.points[i],
                                                   loop.points[(i + 1) % loop.points.size()]));
            most = std::max(most, nearest);
        }
        return most;
    };
    drawRound(desk, 2.0, 0.98);
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY2(offGuide(*desk.sections()[0]) < 0.05,
             qPrintable(QString::number(offGuide(*desk.sections()[0]))));
    desk.moveTo(desk.plate(10, 30));
    desk.press(desk.plate(10, 30));
    desk.moveTo(desk.plate(12, 66));
    desk.wait(2000.0);
    if (isMesh) {
        desk.run("section.takeGuide");
        desk.release(desk.cursor);
        QCOMPARE(desk.sections().size(), std::size_t(2));
        QVERIFY(offGuide(*desk.sections()[1]) < 0.05);
    } else { // across a drawing there is nothing to follow
        QVERIFY(!desk.interaction.hasGuide());
        const Vec2 from = desk.cursor;
        for (int i = 1; i <= 40; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 41;
            desk.moveTo(from + Vec2(80.0 * std::sin(angle), 70.0 - 70.0 * std::cos(angle)), {}, 1);
        }
        desk.release(desk.cursor);
        QCOMPARE(desk.sections().size(), std::size_t(2));
    }
    const Document drawn = desk.session.committed().document;
    const QString saved = folder.filePath(QStringLiteral("a.fff"));
    QVERIFY(io::writeDocument(saved, drawn));
    const auto read = io::readDocument(saved);
    QVERIFY(read && read->document.templates.front()->isRead());
    QVERIFY(io::writeFff(read->document).value() == io::writeFff(drawn).value());
    while (desk.session.history()->canUndo())
        desk.run("edit.undo");
    QVERIFY(desk.session.committed().document == beginning);
    while (desk.session.history()->canRedo())
        desk.run("edit.redo");
    QVERIFY(desk.session.committed().document == drawn);
}

FFF_TEST(TestTemplateStrokes)
#include "tst_template_strokes.moc"
