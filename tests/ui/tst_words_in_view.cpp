// All words and marks that lie over the view at once, on models that are full of problems.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/strength.h"
#include "core/interaction/gizmo.h"
#include "core/interaction/view_cube.h"
#include "core/interaction/view_fit.h"
#include "core/io/document_file.h"
#include "core/operations/operation_kind.h"
#include "core/session/check_list.h"
#include "core/session/session.h"
#include "core/session/session_commands.h"
#include "core/session/session_host.h"
#include "tests/test_program.h"
#include "ui/docks/check_entries.h"
#include "ui/docks/shown_problems.h"
#include "ui/view/legend.h"
#include "ui/view/measure_marks.h"
#include "ui/view/overlay_painter.h"

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>

#include <memory>
#include <string_view>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

/// What a window of 1440 × 900 leaves between its docks, and one of 1024 × 640 beside them.
const Vec2 kViews[] = {Vec2(860.0, 760.0), Vec2(713.0, 496.0)};

/// Whether a line passes through a box, by its pieces: no code of the product.
bool crosses(const QRectF &box, const Vec2 &from, const Vec2 &to)
{
    for (int i = 0; i <= 200; ++i) {
        const Vec2 p = from + (to - from) * (i / 200.0);
        if (box.contains(QPointF(p.x(), p.y())))
            return true;
    }
    return false;
}

double radiusOf(const PlacedMark &mark)
{
    return mark.isDot ? kDotRadius : kMarkRadius;
}

QRectF boxOf(const PlacedMark &mark)
{
    const double half = radiusOf(mark);
    return {mark.centre.x() - half, mark.centre.y() - half, 2.0 * half, 2.0 * half};
}

} // namespace

class TestWordsInView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingLiesOnAnything_data();
    void nothingLiesOnAnything();

private:
    struct Desk
    {
        Session session;
        SessionHost host{session};
        Interaction interaction{host};
        CommandRegistry commands;
        CheckList list{session};
        std::vector<CheckEntry> entries;
        std::optional<StressMarks> stress;
    };
    /// What there is over the view besides the marks of problems.
    struct Case
    {
        Vec2 view;
        Camera camera;
        bool hasGizmo = false;  // a section is moved: then no problem is marked
        int hovered = -1;       // which of the marks the cursor is on
        bool hasStress = false; // with its legend, forces and a card
    };
    void look(const Case &at, Desk &desk);

    int m_numbers = 0, m_dots = 0, m_words = 0; // of the last look
};

void TestWordsInView::nothingLiesOnAnything_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("mirrors");
    const QString samples = QStringLiteral(FFF_SAMPLES), shared = QStringLiteral(FFF_SHARED_MODELS);
    QTest::newRow("bridge") << shared + QStringLiteral("/bridge.txt") << false;
    QTest::newRow("octopus") << shared + QStringLiteral("/octopus.txt") << false;
    for (const char *name : {"fish", "chair", "glass_holder"})
        QTest::newRow(name) << samples + u'/' + QLatin1String(name) + QStringLiteral(".fff")
                            << false;
    QTest::newRow("dinosaur") << samples + QStringLiteral("/dinosaur.fff") << false;
    QTest::newRow("mirrored dinosaur") << samples + QStringLiteral("/dinosaur.fff") << true;
}

/// Words on words, on the gizmo, under the cube or beyond the edge: they can all not be read.
void TestWordsInView::nothingLiesOnAnything()
{
    QFETCH(QString, file);
    QFETCH(bool, mirrors);
    if (!QFile::exists(file))
        FFF_WITHOUT_SHARED();
    Desk desk;
    desk.host.attach(desk.interaction);
    registerSessionCommands(desk.commands, desk.session, desk.interaction);
    const auto read = io::readDocument(file);
    QVERIFY(read);
    Document document = read->document;
    // A weight on each of some sections: words that all want the same places.
    for (std::size_t i = 0; i < document.sections.size(); i += 4) {
        Load load;
        load.id = LoadId{500 + static_cast<int>(i)};
        load.name = "A weight with quite a name";
        load.section = document.sections[i]->id;
        load.position = document.sections[i]->shape->bounds().center();
        load.mass = 0.1;
        document.loads.push_back(load);
    }
    desk.session.reset(document);
    if (mirrors)
        QVERIFY(desk.commands.run("operation.mirror", {}, 1.0));
    // What can be done about them takes longer, and is not shown in the view.
    constexpr int kLongest = 300000; // ms
    const auto isChecked = [&] {
        const Document &now = desk.session.model().document;
        return desk.list.plan() && desk.list.plan()->analysis->model.document.isSame(now) &&
               desk.list.model().document.isSame(now) && desk.list.age() == CheckList::Age::Current;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isChecked(), kLongest);
    desk.entries = checkEntries(desk.list, {});
    StrengthCaches caches;
    const AnalysisPointer analysis = desk.session.analysisPointer();
    desk.stress = stressMarksOf(analysis, strengthOf(*analysis, StrengthRules(), caches), 0.01);
    desk.stress->safety = 2.0;
    if (!desk.stress->lines.empty()) {
        desk.stress->lit = static_cast<int>(desk.stress->lines.size()) - 1;
        desk.stress->hasCard = true;
    }
    const Model &model = desk.session.model();
    if (const auto &joints = analysis->assembly.joints; !joints.empty()) {
        const auto refOf = [&](int section) {
            return model.ref(static_cast<std::size_t>(section));
        };
        desk.interaction.selectJoint(JointRef(refOf(joints[0].a), refOf(joints[0].b)));
    }
    for (const Vec2 &view : kViews)
        for (const char *from : {"iso1", "front", "top", "iso3"})
            for (const double zoom : {1.0, 3.0, 0.25}) {
                desk.interaction.setViewport(view);
                Camera camera;
                QVERIFY(orientationOfView(from, camera.orientation));
                desk.interaction.fitAll(camera, 0.0, 0.0);
                camera = zoomed(desk.interaction.camera(), zoom, 0.5 * view, view);
                for (const bool hasGizmo : {false, true})
                    look({view, camera, hasGizmo}, desk);
                look({view, camera, false, -1, true}, desk);
                for (int mark = 0; mark < 12; mark += 3)
                    look({view, camera, false, mark}, desk);
                look({view, camera}, desk);
                if (QTest::currentTestFailed())
                    return;
                if (zoom == 1.0 && std::string_view(from) == "iso1")
                    qInfo("%.0f x %.0f: %d rows, %d numbers, %d dots, %d words", view.x(), view.y(),
                          static_cast<int>(desk.entries.size()), m_numbers, m_dots, m_words);
            }
}

void TestWordsInView::look(const Case &at, Desk &desk)
{
    const Model &model = desk.session.model();
    const Vec2 &size = at.view;
    desk.interaction.setCamera(at.camera);
    std::optional<Finding> chosen;
    if (!desk.entries.empty() && desk.entries.front().number > 0)
        chosen = desk.entries.front().finding();
    // Verdicts, chips of the view and the bar of a tool.
    std::vector<QRectF> covers{{10.0, 10.0, 420.0, 27.0}, {10.0, 44.0, 150.0, 24.0}};
    if (at.hasGizmo)
        covers.emplace_back(0.5 * size.x() - 200.0, size.y() - 54.0, 400.0, 40.0);
    if (at.hasStress)
        covers.push_back(legendRoom(size));
    std::vector<Box2> covered;
    for (const QRectF &box : covers)
        covered.push_back({{box.left(), box.top()}, {box.right(), box.bottom()}});
    Hovered hovered = desk.interaction.hovered();
    OverlayScene scene{desk.interaction.overlay(), hovered, at.camera, size};
    const std::vector<ProblemMark> marks = marksOf(desk.entries, desk.list.model(), chosen);
    const ShownProblems shown = shownProblems(desk.entries, desk.list.model(), chosen, nullptr);
    scene.problems = shown.look;
    if (!at.hasGizmo) {
        scene.problemMarks = marks;
        scene.marks = placeMarks(marks, at.camera, size, {}, covered);
    }
    const auto over = static_cast<std::size_t>(std::max(at.hovered, 0));
    if (at.hovered >= 0 && over < scene.marks.size()) {
        const ProblemMark &mark = marks[scene.marks[over].marks.front()];
        hovered.problem = mark.number;
        hovered.problemPlace = mark.place;
    }
    scene.dimensions = loadSigns(model, {}, {}, {});
    scene.selected = desk.interaction.overlay().selected;
    const Gizmo gizmo = gizmoOf(model, {model.ref(0)}, false, at.camera.orientation);
    if (at.hasGizmo)
        scene.selected.add(GizmoMarks{gizmo, GizmoPart::MoveX, GizmoMarks::Value{12.3}});
    if (at.hasStress)
        scene.stress = &*desk.stress;
    scene.covered = covers;
    std::vector<QRectF> words;
    scene.words = &words;
    QImage image(static_cast<int>(size.x()), static_cast<int>(size.y()),
                 QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&image);
    paintOverlay(painter, scene, ViewStyle(), QLocale::c());
    painter.end();

    const QRectF view(0.0, 0.0, size.x(), size.y());
    const Vec2 cube = *cubeCentre(size);
    covers.emplace_back(cube.x() - 0.5 * kCubeRoom, cube.y() - 0.5 * kCubeRoom, kCubeRoom,
                        kCubeRoom);
    const GizmoLook look(gizmo, at.camera, size);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const QRectF &box = words[i];
        QVERIFY(view.contains(box));
        for (const QRectF &cover : covers)
            QVERIFY(!box.intersects(cover));
        for (std::size_t k = 0; k < i; ++k)
            QVERIFY(!box.intersects(words[k]));
        for (const PlacedMark &mark : scene.marks)
            QVERIFY(!box.intersects(boxOf(mark)));
        const GizmoPart arrows[] = {GizmoPart::MoveX, GizmoPart::MoveY, GizmoPart::MoveZ};
        for (int axis : {0, 1, 2})
            if (at.hasGizmo && look.isSeen(arrows[axis]))
                QVERIFY(!crosses(box, look.centre(), look.tip(axis)));
    }
    m_numbers = m_dots = 0;
    for (std::size_t i = 0; i < scene.marks.size(); ++i) {
        const PlacedMark &mark = scene.marks[i];
        ++(mark.isDot ? m_dots : m_numbers);
        QVERIFY(mark.isDot || view.contains(boxOf(mark)));
        for (const QRectF &cover : covers)
            QVERIFY(!boxOf(mark).intersects(cover));
        for (std::size_t k = 0; k < i; ++k)
            QVERIFY((mark.centre - scene.marks[k].centre).norm() >=
                    radiusOf(mark) + radiusOf(scene.marks[k]));
    }
    QVERIFY(m_numbers <= static_cast<int>(kMostNumbers));
    m_words = static_cast<int>(words.size());
}

FFF_TEST_WITH(TestWordsInView, fff::testing::runWithin<TestWordsInView, QApplication>)
#include "tst_words_in_view.moc"
