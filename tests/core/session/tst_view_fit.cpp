// What is seen fills the view: its outline on the screen, worked out from the curves of contours.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/view_cube.h"
#include "core/interaction/view_fit.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QFile>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kNear = 2.0; // px
const char *const kViews[] = {"front",  "right", "back", "left", "top",
                              "bottom", "iso1",  "iso2", "iso3", "iso4"};

/// Of both faces of all sections that are seen, px.
Box2 outlineOf(const Model &model, const Camera &camera, const Vec2 &viewport,
               const ViewState &view = {})
{
    constexpr int kChords = 64;
    Box2 box;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        if (view.isHidden(section.ref()))
            continue;
        const double half = 0.5 * model.document.stockOf(section).thickness;
        const Contour &contour = section.shape->contour();
        for (int k = 0; k < contour.segmentCount(); ++k)
            for (int t = 0; t < kChords; ++t)
                for (const double side : {-half, half})
                    box.extend(camera.toScreen(
                        section.frame.toWorld(contour.segment(k).at(double(t) / kChords)) +
                            side * section.frame.x.cross(section.frame.y),
                        viewport));
    }
    return box;
}

/// In the middle of the room that is left, and against two of its sides.
bool fills(const Box2 &seen, const Vec2 &viewport, const ViewMargins &margins)
{
    const double left = seen.min.x() - margins.left, top = seen.min.y() - margins.top,
                 right = viewport.x() - margins.right - seen.max.x(),
                 bottom = viewport.y() - margins.bottom - seen.max.y();
    const bool isAcross = std::max(left, right) < kNear, isUpright = std::max(top, bottom) < kNear;
    return std::min({left, top, right, bottom}) > -kNear && (isAcross || isUpright);
}

/// The same, or beside or below the cube, which would be over it.
void checkFills(const Box2 &seen, const Vec2 &viewport, const ViewMargins &margins)
{
    ViewMargins beside = margins, below = margins;
    if (const std::optional<Vec2> cube = cubeCentre(viewport)) {
        beside.right = std::max(beside.right, viewport.x() - cube->x() + 0.5 * kCubeRoom);
        below.top = std::max(below.top, cube->y() + 0.5 * kCubeRoom);
    }
    QVERIFY2(fills(seen, viewport, margins) || fills(seen, viewport, beside) ||
                 fills(seen, viewport, below),
             qPrintable(QStringLiteral("%1 %2 %3 %4")
                            .arg(seen.min.x())
                            .arg(seen.min.y())
                            .arg(viewport.x() - seen.max.x())
                            .arg(viewport.y() - seen.max.y())));
}

ViewMargins plainMargins(const Vec2 &viewport)
{
    return {0.08 * viewport.x(), 0.08 * viewport.y(), 0.08 * viewport.x(), 0.08 * viewport.y()};
}

Document fileOf(const QString &file)
{
    const auto read = io::readDocument(file);
    return read ? read->document : Document();
}

} // namespace

class TestViewFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theOutlineTouchesTheMargin_data()
    {
        QTest::addColumn<QString>("file");
        const QString samples = QStringLiteral(FFF_SAMPLES),
                      shared = QStringLiteral(FFF_SHARED_MODELS);
        for (const char *name : {"dinosaur", "fish", "chair", "gears", "tree", "bridge"})
            QTest::newRow(name) << samples + u'/' + QLatin1String(name) + QStringLiteral(".fff");
        for (const char *name : {"octopus", "teaser_waterglass1", "spider"})
            QTest::newRow(name) << shared + u'/' + QLatin1String(name) + QStringLiteral(".txt");
    }

    /// The box of a turned model is much larger than what is seen of it.
    void theOutlineTouchesTheMargin()
    {
        QFETCH(QString, file);
        if (!QFile::exists(file))
            FFF_WITHOUT_SHARED();
        Desk desk;
        desk.session.reset(fileOf(file));
        const Model &model = desk.session.model();
        QVERIFY(model.sectionCount() > 0);
        std::mt19937 random(20261126); // NOLINT
        std::normal_distribution<double> part;
        for (const Vec2 &viewport : {Vec2(860.0, 760.0), Vec2(713.0, 512.0), Vec2(480.0, 900.0)}) {
            desk.interaction.setViewport(viewport);
            for (const Projection projection : {Projection::Orthographic, Projection::Perspective})
                for (int i = 0; i < 20; ++i) {
                    Camera camera;
                    camera.projection = projection;
                    if (i < 10)
                        QVERIFY(orientationOfView(kViews[i], camera.orientation));
                    else
                        camera.orientation = Eigen::Quaterniond(part(random), part(random),
                                                                part(random), part(random))
                                                 .normalized();
                    desk.interaction.fitAll(camera, desk.time, 0.0);
                    checkFills(outlineOf(model, desk.interaction.camera(), viewport), viewport,
                               plainMargins(viewport));
                    if (QTest::currentTestFailed())
                        return;
                }
        }
    }

    /// A model whose head is behind the verdicts, or its feet behind a bar.
    void whatStandsOverTheViewLeavesLessRoom()
    {
        Desk desk;
        desk.session.reset(fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
        const Vec2 viewport(700.0, 420.0);
        desk.interaction.setViewport(viewport);
        desk.interaction.setCovered(
            {{{10.0, 10.0}, {400.0, 70.0}}, {{100.0, 340.0}, {600.0, 406.0}}});
        for (const char *name : kViews) {
            Camera camera;
            QVERIFY(orientationOfView(name, camera.orientation));
            desk.interaction.fitAll(camera, desk.time, 0.0);
            const Box2 seen = outlineOf(desk.session.model(), desk.interaction.camera(), viewport);
            QVERIFY(seen.min.y() >= 70.0 && seen.max.y() <= 340.0);
            checkFills(seen, viewport, {0.08 * 700.0, 78.0, 0.08 * 700.0, 88.0});
        }
        // However much stands there, a model is not drawn upside down or as a point.
        desk.interaction.setCovered({{{0.0, 0.0}, {700.0, 205.0}}, {{0.0, 215.0}, {700.0, 420.0}}});
        desk.interaction.fitAll(desk.interaction.camera(), desk.time, 0.0);
        QVERIFY(outlineOf(desk.session.model(), desk.interaction.camera(), viewport).size().y() >
                100.0);
    }

    // Wrong: the key of the colours lies over the foot that is red.
    void nothingIsUnderWhatStandsUpright()
    {
        Desk desk;
        desk.session.reset(fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
        const Vec2 viewport(700.0, 520.0);
        desk.interaction.setViewport(viewport);
        int smaller = 0;
        for (const Box2 &key : {Box2{{584.0, 110.0}, {692.0, 357.0}}, Box2{{0, 60}, {100, 500}}})
            for (const char *name : kViews) {
                Camera camera;
                QVERIFY(orientationOfView(name, camera.orientation));
                desk.interaction.setCovered({});
                desk.interaction.fitAll(camera, desk.time, 0.0);
                const double whole = desk.interaction.camera().millimetresPerPixel;
                desk.interaction.setCovered({key});
                desk.interaction.fitAll(camera, desk.time, 0.0);
                for (const Vec3 &p : outlinePoints(desk.session.model(), ViewState())) {
                    const Vec2 at = desk.interaction.camera().toScreen(p, viewport);
                    QVERIFY2(!((at - key.min).minCoeff() > 0.0 && (key.max - at).minCoeff() > 0.0),
                             name);
                }
                smaller += desk.interaction.camera().millimetresPerPixel > whole ? 1 : 0;
            }
        QVERIFY(smaller > 0);
    }

    void whatIsHiddenTakesNoRoom()
    {
        Desk desk;
        desk.session.reset(fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
        const Vec2 &viewport = desk.interaction.viewport();
        ViewState view;
        for (std::size_t i = 1; i < desk.session.model().sectionCount(); ++i)
            view.hidden.insert(desk.session.model().ref(i));
        desk.interaction.setView(view);
        desk.interaction.fitAll(desk.interaction.camera(), desk.time, 0.0);
        checkFills(outlineOf(desk.session.model(), desk.interaction.camera(), viewport, view),
                   viewport, plainMargins(viewport));
    }

    /// Who is led to a place has to see where in the model it is.
    void aShareLeavesRoomAround()
    {
        Desk desk;
        desk.session.reset(fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
        const Model &model = desk.session.model();
        const Vec2 viewport(860.0, 760.0);
        desk.interaction.setViewport(viewport);
        int halved = 0;
        for (const Projection projection : {Projection::Orthographic, Projection::Perspective})
            for (const char *name : {"front", "top", "iso1"}) {
                Camera camera;
                camera.projection = projection;
                QVERIFY(orientationOfView(name, camera.orientation));
                desk.interaction.fitAll(camera, desk.time, 0.0);
                const double all = desk.interaction.camera().millimetresPerPixel;
                for (std::size_t i = 0; i < model.sectionCount(); i += 4) {
                    desk.interaction.select({model.ref(i)});
                    desk.run("view.fitSelection", {{"share", "0.5"}});
                    desk.wait(1000.0);
                    ViewState view;
                    for (std::size_t k = 0; k < model.sectionCount(); ++k)
                        if (k != i)
                            view.hidden.insert(model.ref(k));
                    const Camera &now = desk.interaction.camera();
                    const Vec2 size = outlineOf(model, now, viewport, view).size();
                    const Vec2 most = 0.5 * 0.84 * viewport;
                    const bool isWhole = std::abs(now.millimetresPerPixel / all - 1.0) < 1e-9;
                    QVERIFY(isWhole || (size.array() < most.array() + kNear).all());
                    QVERIFY(now.millimetresPerPixel < all * 1.001);
                    QVERIFY(now.millimetresPerPixel > all / 3.6); // in perspective: about
                    halved += size.cwiseQuotient(most).maxCoeff() > 0.98 ? 1 : 0;
                }
            }
        QVERIFY(halved > 0);

        // A small part of a large model: half of the view is not enough.
        desk.session.reset(withSection(
            withSection(newDocument(), polygonShape(rectangle(-200, 0, 200, 100)), front()),
            polygonShape(rectangle(0, 0, 4, 4)), front(50)));
        desk.interaction.fitAll(Camera(), desk.time, 0.0);
        const double large = desk.interaction.camera().millimetresPerPixel;
        desk.interaction.select({desk.session.model().ref(1)});
        desk.run("view.fitSelection", {{"share", "0.5"}});
        desk.wait(1000.0);
        const double ratio = large / desk.interaction.camera().millimetresPerPixel;
        QVERIFY2(ratio > 2.7 && ratio < 3.6, qPrintable(QString::number(ratio)));
        QVERIFY(!desk.commands.run("view.fitSelection", {{"share", "0"}}, desk.time));
        QVERIFY(!desk.commands.run("view.fitSelection", {{"share", "1.5"}}, desk.time));
    }

    /// A dock that opens hides a part of the model, or leaves a hole beside it.
    void itFollowsTheRoomUntilSomebodyLooksCloser()
    {
        Desk desk;
        desk.session.reset(fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
        Camera camera;
        QVERIFY(orientationOfView("iso1", camera.orientation));
        desk.interaction.fitAll(camera, desk.time, 0.0);
        const Vec2 narrow(640.0, 700.0);
        desk.interaction.setViewport(narrow);
        const Model &model = desk.session.model();
        checkFills(outlineOf(model, desk.interaction.camera(), narrow), narrow,
                   plainMargins(narrow));
        desk.interaction.setCovered({{{100.0, 600.0}, {500.0, 690.0}}});
        QVERIFY(outlineOf(model, desk.interaction.camera(), narrow).max.y() < 600.0);
        desk.interaction.setCovered({});

        desk.wheel({300.0, 300.0}, 1.0);
        const Camera closer = desk.interaction.camera();
        desk.interaction.setViewport({900.0, 700.0});
        desk.interaction.setCovered({{{100.0, 600.0}, {500.0, 690.0}}});
        QVERIFY(desk.interaction.camera() == closer);
    }

    /// Wrong: an edit, then a dock, and a third of the model is behind it.
    void itFollowsTheRoomAlsoAfterAnEdit()
    {
        for (const bool isAsOpened : {true, false}) {
            Desk desk;
            desk.session.reset(
                fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
            if (!isAsOpened)
                desk.interaction.fitAll(desk.interaction.camera(), desk.time, 0.0);
            desk.click({10.0, 10.0});
            const Document &now = desk.session.committed().document;
            desk.session.commit(QStringLiteral("Rename"),
                                *renameSection(now, now.sections.front()->id, "Body"));
            const Camera before = desk.interaction.camera();
            desk.interaction.setCovered({{{100.0, 600.0}, {500.0, 690.0}}}); // other words
            QVERIFY(desk.interaction.camera() == before);
            desk.interaction.setCovered({});
            const Vec2 narrow(500.0, 700.0);
            desk.interaction.setViewport(narrow);
            checkFills(outlineOf(desk.session.model(), desk.interaction.camera(), narrow), narrow,
                       plainMargins(narrow));
        }
    }

    /// Wrong: docks come, and the ground is below the view.
    void anEmptyViewFollowsTheRoom()
    {
        Desk desk;
        desk.interaction.fitAll(desk.interaction.camera(), desk.time, 0.0);
        desk.interaction.setViewport({700.0, 545.0});
        const Vec2 ground = desk.interaction.camera().toScreen(Vec3::Zero(), {700.0, 545.0});
        QVERIFY2(ground.y() > 300.0 && ground.y() < 545.0, qPrintable(QString::number(ground.y())));
        // What is drawn there does not leap.
        const Camera before = desk.interaction.camera();
        const Document &now = desk.session.committed().document;
        desk.session.commit(QStringLiteral("Draw"),
                            withSection(now, polygonShape(rectangle(0, 0, 20, 20)), front()));
        desk.interaction.setViewport({690.0, 545.0});
        QCOMPARE(desk.interaction.camera().millimetresPerPixel, before.millimetresPerPixel);
    }

    /// Wrong: a tool is taken up, its bar comes, and the model leaps from under the cursor.
    void itStaysUnderTheBarOfATool()
    {
        Desk desk;
        desk.session.reset(fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
        const Box2 badges{{100.0, 10.0}, {500.0, 40.0}};
        const Box2 bar{{100.0, 600.0}, {500.0, 790.0}};
        desk.interaction.setCovered({badges});
        desk.interaction.fitAll(desk.interaction.camera(), desk.time, 0.0);
        const Camera before = desk.interaction.camera();
        desk.interaction.setCovered({badges}, {bar});
        QVERIFY(desk.interaction.camera() == before);
        QCOMPARE(desk.interaction.covered().size(), std::size_t(2)); // marks keep out of it
        // Nor when a badge has other words meanwhile.
        desk.interaction.setCovered({{{100.0, 10.0}, {540.0, 40.0}}}, {bar});
        QVERIFY(desk.interaction.camera() == before);
        desk.interaction.setCovered({badges});
        QVERIFY(desk.interaction.camera() == before);
        // Who fits the model while it is there sees all of it.
        desk.interaction.setCovered({badges}, {bar});
        desk.interaction.fitAll(desk.interaction.camera(), desk.time, 0.0);
        QVERIFY(
            outlineOf(desk.session.model(), desk.interaction.camera(), desk.interaction.viewport())
                .max.y() < 600.0);
    }

    /// What is drawn would slip away from under the hand.
    void itStaysWhileOneDraws()
    {
        Desk desk;
        desk.session.reset(fileOf(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/dinosaur.fff")));
        desk.interaction.fitAll(desk.interaction.camera(), desk.time, 0.0);
        const Vec2 middle = 0.5 * desk.interaction.viewport();
        desk.press(middle, Button::Right);
        desk.send(Desk::Type::Move, middle + Vec2(30.0, 0.0));
        const Camera turning = desk.interaction.camera();
        desk.interaction.setCovered({{{100.0, 600.0}, {500.0, 790.0}}});
        QVERIFY(desk.interaction.camera() == turning);
    }
};

FFF_TEST(TestViewFit)
#include "tst_view_fit.moc"
