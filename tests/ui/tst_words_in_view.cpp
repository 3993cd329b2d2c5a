// All words and marks that lie over the view at once, on models that are full of problems.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/gizmo.h"
#include "core/interaction/view_cube.h"
#include "core/io/document_file.h"
#include "core/operations/operation_kind.h"
#include "core/session/check_list.h"
#include "core/session/session.h"
#include "core/session/session_commands.h"
#include "core/session/session_host.h"
#include "tests/test_program.h"
#include "ui/docks/check_entries.h"
#include "ui/view/measure_marks.h"
#include "ui/view/overlay_painter.h"

#include <QApplication>
#include <QFile>
#include <QImage>
#include <QPainter>

#include <memory>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

const Vec2 kView(860.0, 760.0);

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
    };
    void lookFrom(const char *from, Desk &desk);
};

void TestWordsInView::nothingLiesOnAnything_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("mirrors");
    const QString samples = QStringLiteral(FFF_SAMPLES), shared = QStringLiteral(FFF_SHARED_MODELS);
    QTest::newRow("bridge") << shared + QStringLiteral("/bridge.txt") << false;
    QTest::newRow("octopus") << shared + QStringLiteral("/octopus.txt") << false;
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
    desk.interaction.setViewport(kView);
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
    for (const char *from : {"iso1", "front", "top"})
        lookFrom(from, desk);
}

void TestWordsInView::lookFrom(const char *from, Desk &desk)
{
    const Model &model = desk.session.model();
    Camera camera;
    QVERIFY(orientationOfView(from, camera.orientation));
    camera = fitted(camera, model.bounds(), kView);
    desk.interaction.setCamera(camera);

    const std::vector<CheckEntry> entries = checkEntries(desk.list, {});
    std::optional<Finding> chosen;
    if (!entries.empty() && entries.front().number > 0)
        chosen = entries.front().finding();
    OverlayScene scene{desk.interaction.overlay(), desk.interaction.hovered(), camera, kView};
    scene.problemMarks = marksOf(entries, desk.list.model(), chosen);
    scene.marks = placeMarks(scene.problemMarks, camera, kView, {});
    for (const CheckEntry &entry : entries)
        if (entry.finding().kind->look)
            scene.problems = entry.finding().kind->look(entry.finding());
    scene.dimensions = loadSigns(model, {}, {}, {});
    Overlay overlay;
    const Gizmo gizmo = gizmoOf(model, {model.ref(0)}, false, camera.orientation);
    overlay.held.add(GizmoMarks{gizmo, GizmoPart::MoveX, GizmoMarks::Value{12.3}});
    scene.selected = overlay.held;
    const QRectF bar(10.0, 10.0, 420.0, 27.0);
    scene.covered = {bar};
    std::vector<QRectF> words;
    scene.words = &words;
    QImage image(static_cast<int>(kView.x()), static_cast<int>(kView.y()),
                 QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&image);
    paintOverlay(painter, scene, ViewStyle(), QLocale::c());
    painter.end();

    QVERIFY(!words.empty());
    const QRectF view(0.0, 0.0, kView.x(), kView.y());
    const Vec2 cube = *cubeCentre(kView);
    const QRectF room(cube.x() - 0.5 * kCubeRoom, cube.y() - 0.5 * kCubeRoom, kCubeRoom, kCubeRoom);
    const GizmoLook look(gizmo, camera, kView);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const QRectF &box = words[i];
        QVERIFY(view.contains(box));
        QVERIFY(!box.intersects(room));
        QVERIFY(!box.intersects(bar));
        for (std::size_t k = 0; k < i; ++k)
            QVERIFY(!box.intersects(words[k]));
        for (const PlacedMark &mark : scene.marks)
            QVERIFY(!box.intersects(boxOf(mark)));
        const GizmoPart arrows[] = {GizmoPart::MoveX, GizmoPart::MoveY, GizmoPart::MoveZ};
        for (int axis : {0, 1, 2})
            if (look.isSeen(arrows[axis]))
                QVERIFY(!crosses(box, look.centre(), look.tip(axis)));
    }
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < scene.marks.size(); ++i) {
        const PlacedMark &mark = scene.marks[i];
        numbers += !mark.isDot;
        QVERIFY(!boxOf(mark).intersects(room));
        for (std::size_t k = 0; k < i; ++k)
            QVERIFY((mark.centre - scene.marks[k].centre).norm() >=
                    radiusOf(mark) + radiusOf(scene.marks[k]));
    }
    QVERIFY(numbers <= kMostNumbers);
    qInfo("%s: %d rows, %d places, %d numbers, %d dots, %d words", from,
          static_cast<int>(entries.size()), static_cast<int>(scene.problemMarks.size()),
          static_cast<int>(numbers), static_cast<int>(scene.marks.size() - numbers),
          static_cast<int>(words.size()));
}

FFF_TEST_WITH(TestWordsInView, fff::testing::runWithin<TestWordsInView, QApplication>)
#include "tst_words_in_view.moc"
