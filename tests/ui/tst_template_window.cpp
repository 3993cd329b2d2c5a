// Drawing over a mesh in the window with real events: its list, its guides, and the key that takes
// one whole while the button is held.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/suggesting/first_slices.h"
#include "core/model/template_edits.h"
#include "core/operations/evaluate.h"
#include "core/templates/moved_template.h"
#include "core/templates/template_mesh.h"
#include "core/templates/template_picture.h"
#include "tests/core/io/written_meshes.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "ui/base/message_bar.h"
#include "ui/view/flat_painter.h"

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::ui;

class TestTemplateWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void shiftEnterTakesTheGuideAcross();
    void theListHidesLocksAndRemoves();
    void turnedByNumbers();
    void itsSizeLeavesItOnTheGround();
    void slicesAreThoseThatHold();
    void anotherMeshMayHaveTheSameScale();
    void itsFileIsFoundLinkedAndKept();
    void suggestionsComeOneStepEach();
    void whatIsUndoneBehindAnotherTabEnds();
    void facetsTakeThePlaceOfTheMesh();
    void aPictureIsSeenLaidAndTraced();

private:
    /// On the ground, and chosen in the list.
    void chooseBall()
    {
        addBall();
        bench().run(QStringLiteral("template.toGround"));
        auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("templatesDock"));
        dock->show();
        dock->raise();
        auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("templateTree"));
        tree->setCurrentItem(tree->topLevelItem(0));
    }
    void type(const char *field, const QString &text)
    {
        auto *edit = m_window->findChild<QDoubleSpinBox *>(QLatin1String(field));
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        QTest::keyClick(edit, Qt::Key_Return);
    }
    /// The dialog that comes up takes this file.
    static void chooseFile(const QString &path)
    {
        QTimer::singleShot(0, qApp, [path] {
            auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            dialog->setDirectory(QFileInfo(path).path());
            dialog->selectFile(path);
            dialog->findChild<QLineEdit *>(QStringLiteral("fileNameEdit"))
                ->setText(QFileInfo(path).fileName());
            QMetaObject::invokeMethod(dialog, "accept");
        });
    }
    bool isSeen(const char *button) const
    {
        return m_window->findChild<QPushButton *>(QLatin1String(button))->isVisible();
    }
    void push(const char *button)
    {
        QTest::mouseClick(m_window->findChild<QPushButton *>(QLatin1String(button)),
                          Qt::LeftButton);
    }
    void addBall()
    {
        Template one;
        one.name = "Ball";
        one.file = "ball.stl";
        one.mesh = makeTemplateMesh(mended(test::sphere(60.0, 60, 90)).value().mesh, {}).value();
        one.frame.origin = {0.0, kFirstPlaneHeight, 0.0};
        session().commit(QStringLiteral("Add"),
                         addTemplate(session().committed().document, one).value());
    }
    const Template &ball() const { return *session().committed().document.templates.front(); }
};

// Wrong: actions are told of a guide when the stroke is over, and their key does nothing before.
void TestTemplateWindow::shiftEnterTakesTheGuideAcross()
{
    drawFirst();
    QCOMPARE(count(), std::size_t(1));
    addBall();
    pullSlit();
    QVERIFY(interaction().hasGuide());
    key(Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(count(), std::size_t(2));
    QVERIFY(!interaction().hasGesture());
    release(m_cursor);
    QCOMPARE(count(), std::size_t(2));
    for (const Vec2 &p : session().committed().section(1)->shape->contour().polygon(0.01)) {
        const Vec3 at = session().committed().section(1)->frame.toWorld(p);
        QVERIFY(std::abs((at - Vec3(0.0, kFirstPlaneHeight, 0.0)).norm() - 60.0) < 0.2);
    }
}

void TestTemplateWindow::theListHidesLocksAndRemoves()
{
    addBall();
    auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("templatesDock"));
    dock->show();
    dock->raise();
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("templateTree"));
    QCOMPARE(tree->topLevelItemCount(), 1);
    QCOMPARE(tree->topLevelItem(0)->text(0), QStringLiteral("Ball"));
    tree->setCurrentItem(tree->topLevelItem(0));
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_Space);
    QVERIFY(ball().isHidden);
    QTest::keyClick(tree, Qt::Key_Space);
    QVERIFY(!ball().isHidden);
    QTest::keyClick(tree, Qt::Key_L);
    QVERIFY(ball().isLocked);
    QTest::keyClick(tree, Qt::Key_Delete);
    QVERIFY(session().committed().document.templates.empty());
    QCOMPARE(tree->topLevelItemCount(), 0);
    session().history()->undo();
    QCOMPARE(tree->topLevelItemCount(), 1);
}

void TestTemplateWindow::turnedByNumbers()
{
    chooseBall();
    const Frame before = ball().frame;
    type("templateTurnX", QStringLiteral("90"));
    QVERIFY((ball().frame.y - Vec3::UnitZ()).norm() < 1e-12);
    QVERIFY(ball().frame.origin == before.origin);
    type("templateTurnZ", QStringLiteral("30"));
    QVERIFY(std::abs(turnsOf(ball()).x() - std::numbers::pi / 2.0) < 1e-9);
    QVERIFY(std::abs(turnsOf(ball()).z() - std::numbers::pi / 6.0) < 1e-9);
    type("templateTurnZ", QStringLiteral("0"));
    type("templateTurnX", QStringLiteral("0"));
    QVERIFY(ball().frame.x == before.x && ball().frame.y == before.y);
}

// Wrong: a ball that came 254 mm large and is made 80 mm hovers 87 mm above the ground.
void TestTemplateWindow::itsSizeLeavesItOnTheGround()
{
    chooseBall();
    type("templateSize", QStringLiteral("80"));
    const Box3 box = worldBounds(ball(), *ball().mesh);
    QVERIFY(std::abs(box.size().y() - 80.0) < 0.1);
    QVERIFY(std::abs(box.min.y()) < 1e-6);
}

// Wrong: what one click makes cannot be made of anything.
void TestTemplateWindow::slicesAreThoseThatHold()
{
    chooseBall();
    const int before = steps();
    push("templateSlices");
    QCOMPARE(steps(), before + 1);
    QCOMPARE(session().committed().document.operations.size(), std::size_t(1));
    const Operation &made = *session().committed().document.operations.front();
    QVERIFY(made.kind == "slices");
    const Document alone = addTemplate(newDocument(), ball()).value();
    const FirstSlices planes = firstSlices(evaluate(alone), alone.templates.front()->id).value();
    const auto number = made.parameters.find("count");
    QVERIFY(number == made.parameters.end() ? planes.count == FirstSlices().count
                                            : std::get<double>(number->second) == planes.count);
    const auto choice = made.parameters.find("direction");
    QVERIFY(choice == made.parameters.end()
                ? planes.direction == FirstSlices().direction
                : std::get<std::string>(choice->second) == planes.direction);
}

// Wrong: a cup and its saucer, which are two files without a unit, come equally large.
void TestTemplateWindow::anotherMeshMayHaveTheSameScale()
{
    QTemporaryDir folder;
    const auto write = [&](const QString &name, double radius) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(test::stlBytes(test::sphere(radius, 30, 40))));
    };
    write(QStringLiteral("large.stl"), 60.0);
    write(QStringLiteral("small.stl"), 15.0);
    const auto add = [&](const QString &name) {
        chooseFile(folder.filePath(name));
        push("templateAdd");
    };
    const auto *bar = m_window->findChild<MessageBar *>();
    add(QStringLiteral("large.stl"));
    QVERIFY(!bar->isVisible());
    add(QStringLiteral("small.stl"));
    QVERIFY(bar->isVisible());
    const auto verbs = bar->findChildren<QPushButton *>();
    const auto verb = std::find_if(verbs.begin(), verbs.end(), [](const QPushButton *one) {
        return one->text() == QStringLiteral("Scale it like large");
    });
    QVERIFY(verb != verbs.end());
    (*verb)->click();
    const auto &all = session().committed().document.templates;
    QVERIFY(std::abs(all[0]->scale - all[1]->scale) < 1e-9);
    QVERIFY(std::abs(worldBounds(*all[1], *all[1]->mesh).min.y()) < 1e-6);
}

// Wrong: a model that was sent without its mesh has no mesh ever again.
void TestTemplateWindow::itsFileIsFoundLinkedAndKept()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("moved.stl"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(test::stlBytes(test::sphere(60.0, 30, 40))));
    file.close();
    Template gone;
    gone.name = "Gone";
    gone.file = "/nowhere/gone.stl";
    gone.frame.origin = {5.0, 60.0, 0.0};
    gone.scale = 0.5;
    auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("templatesDock"));
    dock->hide();
    session().reset(addTemplate(newDocument(), gone).value());
    QTRY_VERIFY(dock->isVisible()); // whoever opens it sees what is missing, and what to do
    dock->raise();
    const auto one = [this]() -> const Template & {
        return *session().committed().document.templates.front();
    };
    QVERIFY(isSeen("templateFind") && !isSeen("templateLink") && !isSeen("templateKeep"));
    const Document before = session().committed().document;
    chooseFile(path);
    push("templateFind");
    QVERIFY(one().mesh);
    QVERIFY(one().blob.empty());
    QCOMPARE(QString::fromStdString(one().file), path);
    QVERIFY(one().frame == gone.frame && one().scale == gone.scale);
    QVERIFY(!isSeen("templateFind") && isSeen("templateKeep"));
    push("templateKeep");
    QVERIFY(!one().blob.empty());
    QVERIFY(session().committed().document.findBlob(one().blob));
    QVERIFY(one().mesh && one().frame == gone.frame);
    QVERIFY(isSeen("templateLink"));
    chooseFile(path);
    push("templateLink");
    QVERIFY(one().blob.empty());
    QVERIFY(session().committed().document.blobs.empty()); // the model's file gets smaller
    // Another kind of thing is refused, and all stays.
    const QString picture = folder.filePath(QStringLiteral("a.png"));
    QVERIFY(QImage(8, 8, QImage::Format_RGB32).save(picture));
    push("templateKeep");
    chooseFile(picture);
    push("templateLink");
    QVERIFY(one().mesh && !one().blob.empty());
    while (session().history()->canUndo() && !session().committed().document.isSame(before))
        session().history()->undo();
    QVERIFY(!one().mesh);
    QVERIFY(isSeen("templateFind"));
}

// One that is not liked goes for the next: nobody has to undo it, nor does it stay in the history.
void TestTemplateWindow::suggestionsComeOneStepEach()
{
    chooseBall();
    const auto *another = m_window->findChild<QPushButton *>(QStringLiteral("suggestAnother"));
    const auto *more = m_window->findChild<QPushButton *>(QStringLiteral("suggestOneMore"));
    QVERIFY(!another->isEnabled() && !more->isEnabled());
    const int before = steps();

    push("suggestSections");
    const std::size_t found = count();
    QVERIFY(found >= 4);
    QCOMPARE(steps(), before + 1);
    QVERIFY(another->isEnabled() && more->isEnabled());
    const Document first = session().committed().document;

    push("suggestOneMore");
    QCOMPARE(count(), found + 1);
    QCOMPARE(steps(), before + 2);
    type("suggestCount.field", QStringLiteral("3"));
    push("suggestSections"); // another number: not three more
    QCOMPARE(count(), std::size_t(3));
    QCOMPARE(steps(), before + 1);

    push("suggestAnother");
    QVERIFY(!session().committed().document.isSame(first));
    QCOMPARE(steps(), before + 1);
    session().history()->undo();
    QCOMPARE(count(), std::size_t(0));
    QVERIFY(!another->isEnabled() && !more->isEnabled());
    push("suggestSections"); // what was undone is no reason to go on from there
    QCOMPARE(steps(), before + 1);
}

// Wrong: the button that is no longer to be pressed, behind another tab, gives the focus away, and
// what looks for somebody to take it never ends.
void TestTemplateWindow::whatIsUndoneBehindAnotherTabEnds()
{
    chooseBall();
    push("suggestSections");
    m_window->findChild<QPushButton *>(QStringLiteral("suggestOneMore"))->setFocus();
    push("suggestOneMore");
    for (const char *name : {"historyDock", "outlineDock"}) {
        if (auto *dock = m_window->findChild<QDockWidget *>(QLatin1String(name))) {
            dock->show();
            dock->raise();
            QTest::qWait(20);
        }
    }
    while (session().history()->canUndo())
        session().history()->undo();
    QCOMPARE(count(), std::size_t(0));
    QVERIFY(m_window->focusWidget());
}

void TestTemplateWindow::facetsTakeThePlaceOfTheMesh()
{
    chooseBall();
    const int before = steps();
    type("facetFaces.field", QStringLiteral("20"));
    push("makeFacets");
    QVERIFY(count() >= 8 && count() <= 20);
    QVERIFY(ball().isHidden);
    QCOMPARE(steps(), before + 1);
    type("facetFaces.field", QStringLiteral("12"));
    push("makeFacets"); // fewer, not more besides
    QVERIFY(count() >= 4 && count() <= 12);
    QCOMPARE(steps(), before + 1);
    session().history()->undo();
    QCOMPARE(count(), std::size_t(0));
    QVERIFY(!ball().isHidden);
}

// Wrong: what can be read as a template is not to be seen, or has buttons that do nothing.
void TestTemplateWindow::aPictureIsSeenLaidAndTraced()
{
    constexpr int kAcross = 200, kRadius = 70; // px
    auto picture = std::make_shared<TemplatePicture>();
    picture->width = picture->height = kAcross;
    for (int y = 0; y < kAcross; ++y)
        for (int x = 0; x < kAcross; ++x) {
            const bool isDark = std::hypot(x + 0.5 - kAcross / 2, y + 0.5 - kAcross / 2) < kRadius;
            for (const int value : {isDark ? 20 : 255, isDark ? 20 : 255, isDark ? 20 : 255, 255})
                picture->rgba.push_back(static_cast<std::uint8_t>(value));
        }
    Template one;
    one.kind = TemplateKind::Picture;
    one.name = "Disc";
    one.file = "disc.png";
    one.picture = picture;
    one.scale = 0.5; // mm a pixel
    session().commit(QStringLiteral("Add"),
                     addTemplate(session().committed().document, one).value());
    auto *dock = m_window->findChild<QDockWidget *>(QStringLiteral("templatesDock"));
    dock->show();
    dock->raise();
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("templateTree"));
    tree->setCurrentItem(tree->topLevelItem(0));
    const auto flats = [this] { return flatsOf(session().model()); };
    QCOMPARE(flats().size(), std::size_t(1));
    QCOMPARE(flats().front().over, Vec3(Vec3::Zero()));
    QCOMPARE(imageOf(flats().front(), 64).size(), QSize(64, 64));
    QVERIFY(qGray(imageOf(flats().front(), 64).pixel(32, 32)) < 40);
    // What is of meshes alone is not offered.
    QVERIFY(!m_window->findChild<QPushButton *>(QStringLiteral("makeFacets"))->isVisible());
    push("flat.side");
    QVERIFY(std::abs(ball().frame.normal().x()) > 0.99);
    push("flat.front");
    QVERIFY(std::abs(ball().frame.normal().z()) > 0.99);
    push("flat.flip");
    QVERIFY(ball().isFlipped);
    push("flat.sections");
    QCOMPARE(count(), std::size_t(1));
    const double area = session().committed().document.sections.front()->shape->area();
    QVERIFY2(std::abs(area / (std::numbers::pi * 35.0 * 35.0) - 1.0) < 0.02,
             qPrintable(QString::number(area)));
    // Hidden it is not seen.
    tree->setFocus();
    QTest::keyClick(tree, Qt::Key_Space);
    QVERIFY(flats().empty());
}

FFF_TEST_WITH(TestTemplateWindow, runInWindowProgram<TestTemplateWindow>)
#include "tst_template_window.moc"
