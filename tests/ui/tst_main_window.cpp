// The window as a person uses it: real events, from the first stroke to the file for the cutter.
// First: Qt 6.4's moc fails on standard headers that it meets before one of Qt's.
#include <QTest>

#include "core/base/units.h"
#include "core/interaction/section_editing.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_program.h"
#include "ui/base/message_bar.h"
#include "ui/base/theme.h"
#include "ui/bench/first_sections.h"
#include "ui/bench/viewport.h"
#include "ui/bench/workbench.h"
#include "ui/docks/outline_dock.h"
#include "ui/docks/properties_dock.h"
#include "ui/files/document_files.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeWidget>

#include <cmath>

using namespace fff;
using namespace fff::ui;

class TestMainWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        // A connection to what is not made yet is one that never speaks.
        QTest::failOnWarning(QRegularExpression(QStringLiteral("QObject::connect")));
        openWindow();
    }
    void cleanup() { closeWindow(); }

    void theFirstFiveMinutes();
    void aClickSelectsInViewOutlineAndProperties();
    void aModelStaysWholeInSight();
    void theOutlineRenames();
    void theFilterFindsSections();
    void aThicknessIsOneStep();
    void leavingAFieldChangesNothing_data();
    void leavingAFieldChangesNothing();
    void whatIsTypedIsSaved_data();
    void whatIsTypedIsSaved();
    void whatIsTypedIsAskedAbout();
    void undoTakesBackWhatIsTyped();
    void exportLeavesOutWhatIsBeingDrawn();
    void exportRefusesClosedSlits();
    void aSelectedRowIsOfOneColour_data();
    void aSelectedRowIsOfOneColour();
    void unsavedChangesAreAskedAbout();
    void anUnreadableFileChangesNothing();
    void importsKeepTheirTitleAndAskForAName();
    void nothingIsPaintedWhenNothingChanges();
    void badgesCostTheViewNoFrame();
    void movingOverTheSamePaintsNothing();
    void aStepUnderTheCursorIsOutlined();
    void aProblemIsChosenByItsNumber();
    void viewActionsShowTheirState();
    void lettersWorkOnlyInTheView();
    void narrowWindowsHaveOneColumn();
    void otherWidthsKeepWhatWasArranged();

private:
    bool comesToRest();
};

void TestMainWindow::theFirstFiveMinutes()
{
    QCOMPARE(m_window->windowTitle(), QStringLiteral("untitled[*] \u2014 FlatFitFab"));
    drawFirst();
    drawSecond();
    QCOMPARE(session().currentAnalysis().assembly.joints.size(), std::size_t(1));
    QVERIFY(m_window->isWindowModified());

    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(1));
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(count(), std::size_t(2));
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(m_window.get(), Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(count(), std::size_t(2));

    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("pair.fff"));
    QVERIFY(m_window->files().saveFile(file));
    QCOMPARE(m_window->windowTitle(), QStringLiteral("pair.fff[*] \u2014 FlatFitFab"));
    QVERIFY(!m_window->isWindowModified());
    const Document saved = session().committed().document;
    QVERIFY(m_window->files().startNew());
    QCOMPARE(count(), std::size_t(0));
    // A copy must not write to what it was made from.
    QVERIFY(m_window->files().openFile(file, true));
    QVERIFY(m_window->files().path() != file);
    QCOMPARE(m_window->windowTitle(), QStringLiteral("pair.fff[*] \u2014 FlatFitFab"));
    QVERIFY(m_window->files().openFile(file));
    QVERIFY(session().committed().document == saved);

    const QString drawing = folder.filePath(QStringLiteral("pair.svg"));
    QVERIFY(m_window->files().exportFile(drawing));
    const Result<std::string> svg = io::readFile(drawing);
    QVERIFY(svg);
    int parts = 0;
    for (std::size_t at = svg->find("<g id=\"part"); at != std::string::npos;
         at = svg->find("<g id=\"part", at + 1))
        ++parts;
    QCOMPARE(parts, 2);
}

void TestMainWindow::aClickSelectsInViewOutlineAndProperties()
{
    drawFirst();
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("outlineTree"));
    auto *name = m_window->findChild<QLineEdit *>(QStringLiteral("propertiesName"));
    m_window->bench().select({});
    QVERIFY(tree->selectedItems().isEmpty());

    const Section &section = *session().committed().section(0);
    const QPoint middle = onScreen(section.frame.toWorld(section.shape->centroid()));
    move(middle + QPoint(3, 3));
    click(middle);
    QCOMPARE(tree->selectedItems().size(), 1);
    QCOMPARE(name->text(), QString::fromStdString(section.name));

    click(QPoint(8, 8));
    QVERIFY(interaction().selection().empty());
    QVERIFY(tree->selectedItems().isEmpty());

    tree->setCurrentItem(tree->topLevelItem(0));
    QCOMPARE(interaction().selection().size(), std::size_t(1));
}

// Wrong: a model is opened, the window made smaller, and half of the model is beyond its edge; or a
// person looks closer and the view jumps back.
void TestMainWindow::aModelStaysWholeInSight()
{
    session().reset(test::eggCrate(3, 3));
    Workbench &bench = m_window->bench();
    bench.showAll("iso1");
    const auto isWhole = [&] {
        const Model &model = session().model();
        const Vec2 &size = interaction().viewport();
        for (std::size_t i = 0; i < model.sectionCount(); ++i)
            for (const Vec2 &corner : model.section(i)->shape->region().outer) {
                const Vec2 at =
                    interaction().camera().toScreen(model.section(i)->frame.toWorld(corner), size);
                if (at.x() < 0.0 || at.y() < 0.0 || at.x() > size.x() || at.y() > size.y())
                    return false;
            }
        return true;
    };
    QVERIFY(isWhole());
    const Vec2 before = interaction().viewport();
    m_window->resize(1024, 640);
    QTRY_VERIFY(interaction().viewport() != before);
    QTRY_VERIFY(isWhole());
    QVERIFY(!interaction().canGoBack());

    // Nothing else is touched by that.
    const JointRef joint(session().committed().ref(0), session().committed().ref(3));
    bench.selectJoint(joint);
    m_window->resize(1200, 700);
    QTRY_VERIFY(isWhole());
    QVERIFY(interaction().selectedJoint() == joint);
    bench.run(QStringLiteral("section.pen")); // nothing is drawn with it yet

    QVERIFY(interaction().tool());
    const Vec2 drawing = interaction().viewport();
    m_window->resize(1300, 800);
    QTRY_VERIFY(interaction().viewport() != drawing);
    QVERIFY(interaction().tool());
    QTRY_VERIFY(isWhole());
    bench.escape();
    bench.showAll("iso1");

    Camera closer = interaction().camera();
    closer.millimetresPerPixel *= 0.5;
    bench.setCamera(closer);
    const Vec2 small = interaction().viewport();
    m_window->resize(1400, 900);
    QTRY_VERIFY(interaction().viewport() != small);
    QVERIFY(interaction().camera() == closer);
}

void TestMainWindow::theOutlineRenames()
{
    drawFirst();
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("outlineTree"));
    const int steps = session().history()->index();
    tree->setFocus();
    tree->setCurrentItem(tree->topLevelItem(0));
    QTest::keyClick(tree, Qt::Key_F2);
    auto *editor = qobject_cast<QLineEdit *>(QApplication::focusWidget());
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("Body"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(QString::fromStdString(session().committed().section(0)->name),
                 QStringLiteral("Body"));
    QCOMPARE(session().history()->index(), steps + 1);
    QTRY_COMPARE(tree->topLevelItem(0)->text(0), QStringLiteral("Body"));
}

void TestMainWindow::theFilterFindsSections()
{
    drawFirst();
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("outlineTree"));
    auto *filter = m_window->findChild<QLineEdit *>(QStringLiteral("outlineFilter"));
    QTest::keyClicks(filter, QStringLiteral("nothing is called so"));
    QVERIFY(tree->topLevelItem(0)->isHidden());
    filter->clear();
    QTest::keyClicks(filter, QStringLiteral("plywood")); // its stock
    QVERIFY(!tree->topLevelItem(0)->isHidden());
}

void TestMainWindow::aThicknessIsOneStep()
{
    drawFirst();
    m_window->bench().select({session().committed().ref(0)});
    auto *field = m_window->findChild<QDoubleSpinBox *>(QStringLiteral("sectionThickness"));
    QVERIFY(field->isVisible());
    const int steps = session().history()->index();
    const double before = field->value();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, field->locale().toString(4.5, 'f', 1));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(session().committed().document.stocks.front()->thickness, 4.5);
    QCOMPARE(session().history()->index(), steps + 1);

    // Several steps of an arrow are one step of the history.
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(field, Qt::Key_Up);
    QTRY_COMPARE(session().history()->index(), steps + 2);
    session().history()->undo();
    session().history()->undo();
    QCOMPARE(session().committed().document.stocks.front()->thickness, before);
    QCOMPARE(field->value(), before);
}

void TestMainWindow::leavingAFieldChangesNothing_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("thickness");
    QTest::newRow("more digits than shown") << 12.3456789 << 3.14159;
    QTest::newRow("half a digit") << 0.125 << 2.0625;
    QTest::newRow("far") << 123456.789 << 640.0;
    QTest::newRow("as far as can be") << -1e6 << 0.02;
    QTest::newRow("thicker than the field takes") << 0.0 << 5000.0;
    QTest::newRow("thinner than the field takes") << 0.0 << 0.001;
}

void TestMainWindow::leavingAFieldChangesNothing()
{
    QFETCH(double, x);
    QFETCH(double, thickness);
    drawFirst();
    Document document = session().committed().document;
    Stock stock = *document.find(first().stock);
    stock.thickness = thickness;
    Frame frame = first().frame;
    frame.origin.x() += x - positionOf(first()).x();
    Result<Document> next = setStock(std::move(document), stock);
    QVERIFY(next);
    next = moveSection(std::move(*next), first().id, frame);
    QVERIFY(next);
    session().commit(QStringLiteral("far"), std::move(*next));
    m_window->bench().select({session().committed().ref(0)});

    const int steps = session().history()->index();
    for (const char *name : {"positionX", "positionY", "positionZ", "sectionThickness"}) {
        auto *field = m_window->findChild<QDoubleSpinBox *>(QLatin1String(name));
        field->setFocus();
        QTRY_VERIFY(field->hasFocus());
        QTest::keyClick(field, Qt::Key_Tab);
        QVERIFY(!field->hasFocus());
    }
    QCOMPARE(session().history()->index(), steps);
    QCOMPARE(first().frame.origin.x(), frame.origin.x());
    QCOMPARE(session().committed().document.find(first().stock)->thickness, thickness);
    auto *field = m_window->findChild<QDoubleSpinBox *>(QStringLiteral("positionX"));
    QVERIFY(std::abs(field->value() - x) < 0.0051);
}

void TestMainWindow::whatIsTypedIsSaved_data()
{
    QTest::addColumn<QString>("field");
    QTest::newRow("number") << QStringLiteral("positionX");
    QTest::newRow("arrow") << QString();
    QTest::newRow("name") << QStringLiteral("propertiesName");
    QTest::newRow("name in the outline") << QStringLiteral("outlineTree");
}

/// Ctrl+S with the cursor still in the field.
void TestMainWindow::whatIsTypedIsSaved()
{
    QFETCH(QString, field);
    drawFirst();
    m_window->bench().select({session().committed().ref(0)});
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("typed.fff"));
    QVERIFY(m_window->files().saveFile(file));
    const double x = positionOf(first()).x();

    auto *editor =
        m_window->findChild<QWidget *>(field.isEmpty() ? QStringLiteral("positionX") : field);
    editor->setFocus();
    if (auto *tree = qobject_cast<QTreeWidget *>(editor)) {
        tree->setCurrentItem(tree->topLevelItem(0));
        QTest::keyClick(tree, Qt::Key_F2);
        editor = QApplication::focusWidget();
    }
    QVERIFY(editor->hasFocus());
    if (field.isEmpty()) {
        QTest::keyClick(editor, Qt::Key_Up);
    } else {
        QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(editor, QStringLiteral("77"));
    }
    QTest::keyClick(m_window.get(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!m_window->isWindowModified());
    if (!qobject_cast<QLineEdit *>(editor) || field != QStringLiteral("outlineTree"))
        QVERIFY(editor->hasFocus());

    const Result<io::LoadedDocument> loaded = io::readDocument(file, {});
    QVERIFY(loaded);
    const Section &saved = *loaded->document.sections.front();
    if (field.isEmpty())
        QVERIFY(std::abs(positionOf(saved).x() - x - 0.1) < 0.0051);
    else if (field == QStringLiteral("positionX"))
        QCOMPARE(positionOf(saved).x(), 77.0);
    else
        QCOMPARE(QString::fromStdString(saved.name), QStringLiteral("77"));
    QCoreApplication::processEvents();
    QVERIFY(session().isClean());
}

void TestMainWindow::whatIsTypedIsAskedAbout()
{
    drawFirst();
    m_window->bench().select({session().committed().ref(0)});
    session().setClean();
    auto *field = m_window->findChild<QDoubleSpinBox *>(QStringLiteral("positionX"));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("77"));
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    QVERIFY(!m_window->close());
    QCOMPARE(asked, 1);
    QCOMPARE(positionOf(first()).x(), 77.0);
}

void TestMainWindow::undoTakesBackWhatIsTyped()
{
    drawFirst();
    m_window->bench().select({session().committed().ref(0)});
    const double x = positionOf(first()).x();
    auto *field = m_window->findChild<QDoubleSpinBox *>(QStringLiteral("positionX"));
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("77"));
    m_window->findChild<QAction *>(QStringLiteral("edit.undo"))->trigger();
    QCOMPARE(count(), std::size_t(1));
    QCOMPARE(positionOf(first()).x(), x);
    QVERIFY(session().history()->canRedo());
}

void TestMainWindow::exportLeavesOutWhatIsBeingDrawn()
{
    drawFirst();
    QTemporaryDir folder;
    const QString before = folder.filePath(QStringLiteral("before.svg")),
                  during = folder.filePath(QStringLiteral("during.svg"));
    QVERIFY(m_window->files().exportFile(before));

    const Box3 box = worldBounds(*first().shape, first().frame);
    const QPoint start = onScreen(box.center()),
                 leave = onScreen({box.center().x(), box.max.y() + 4.0, box.center().z()});
    move(start);
    press(start);
    QPoint at;
    for (int i = 1; i <= 24; ++i) {
        at = start + (leave - start) * i / 24;
        move(at);
    }
    QTRY_VERIFY(interaction().overlay().find<sign::Capsule>());
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    const QPoint centre = (start + at) / 2;
    for (int i = 0; i <= 30; ++i) {
        const double angle = radians(90.0 + 345.0 * i / 40.0);
        at = centre + QPoint(static_cast<int>(90 * std::cos(angle)),
                             static_cast<int>(-130 * std::sin(angle)));
        move(at);
    }
    QTRY_VERIFY(session().hasPreview());
    QVERIFY(m_window->files().exportFile(during));
    QVERIFY(!session().hasPreview());
    release(at);
    QCOMPARE(count(), std::size_t(1));
    const Result<std::string> a = io::readFile(before), b = io::readFile(during);
    QVERIFY(a && b);
    QVERIFY(*a == *b);
}

void TestMainWindow::exportRefusesClosedSlits()
{
    drawFirst();
    drawSecond();
    Document document = session().committed().document;
    Stock stock = *document.find(first().stock);
    stock.kerf = stock.thickness + 1.0;
    Result<Document> next = setStock(std::move(document), stock);
    QVERIFY(next);
    session().commit(QStringLiteral("kerf"), std::move(*next));
    QTemporaryDir folder;
    const QString closed = folder.filePath(QStringLiteral("closed.svg"));
    QVERIFY(!m_window->files().exportFile(closed));
    QVERIFY(!QFile::exists(closed));
    auto *messages = m_window->findChild<MessageBar *>(QStringLiteral("messageBar"));
    QVERIFY(messages->isVisible());
    QVERIFY2(messages->text().contains(QString::fromStdString(first().name)),
             qPrintable(messages->text()));
    auto *stocks = messages->findChild<QPushButton *>(QStringLiteral("messageVerb"));
    QVERIFY(stocks && stocks->isVisible());
    QTest::mouseClick(stocks, Qt::LeftButton);
    auto *editor = m_window->findChild<QWidget *>(QStringLiteral("stockEditor"));
    QVERIFY(editor && editor->isVisible());
    editor->close();
    // Gone with its cause.
    QVERIFY(!m_window->files().exportFile(closed));
    QVERIFY(messages->isVisible());
    m_window->bench().run(QStringLiteral("edit.undo"));
    QVERIFY(!messages->isVisible());
}

void TestMainWindow::aSelectedRowIsOfOneColour_data()
{
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

void TestMainWindow::aSelectedRowIsOfOneColour()
{
    QFETCH(bool, isDark);
    const QPalette before = QApplication::palette();
    QApplication::setPalette(
        QPalette(isDark ? QColor(0x30, 0x30, 0x30) : QColor(0xf0, 0xf0, 0xf0)));
    QTRY_COMPARE(theme().isDark, isDark);
    drawFirst();
    drawSecond();
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("outlineTree"));
    m_window->bench().select({session().committed().ref(1)});
    QCOMPARE(tree->selectedItems().size(), 1);
    const QRect row = tree->visualItemRect(tree->selectedItems().front());
    const QImage image = tree->viewport()->grab().toImage();
    const QColor accent = theme().accent;
    QApplication::setPalette(before);
    // Above and below the words.
    for (int y : {row.top() + 1, row.top() + 3, row.bottom() - 3, row.bottom() - 1}) {
        for (int x = 0; x < image.width(); ++x)
            QVERIFY2(image.pixelColor(x, y) == accent,
                     qPrintable(QStringLiteral("%1 at %2, %3")
                                    .arg(image.pixelColor(x, y).name())
                                    .arg(x)
                                    .arg(y - row.top())));
    }
}

void TestMainWindow::unsavedChangesAreAskedAbout()
{
    drawFirst();
    int asked = 0;
    answer(QStringLiteral("Cancel"), &asked);
    QVERIFY(!m_window->close());
    QCOMPARE(asked, 1);
    QVERIFY(m_window->isVisible());
    answer(QStringLiteral("Don’t save"), &asked);
    QVERIFY(m_window->close());
    QCOMPARE(asked, 2);
}

void TestMainWindow::anUnreadableFileChangesNothing()
{
    drawFirst();
    auto *messages = m_window->findChild<MessageBar *>(QStringLiteral("messageBar"));
    QVERIFY(!messages->isVisible());
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("notes.fff"));
    QVERIFY(io::writeFile(file, "hello"));
    QVERIFY(!m_window->files().openFile(file));
    QVERIFY(messages->isVisible());
    QVERIFY(messages->text().contains(QStringLiteral("notes.fff")));
    QCOMPARE(count(), std::size_t(1));
}

void TestMainWindow::importsKeepTheirTitleAndAskForAName()
{
    const QString file = QStringLiteral(FFF_SHARED_MODELS "/bridge.txt");
    if (!QFile::exists(file))
        FFF_WITHOUT_SHARED();
    QVERIFY(m_window->files().openFile(file));
    QCOMPARE(m_window->windowTitle(), QStringLiteral("bridge.txt[*] \u2014 FlatFitFab"));
    QVERIFY(count() > 0);
    bool asked = false;
    QTimer::singleShot(300, this, [&asked] {
        if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget())) {
            asked = true;
            dialog->reject();
        }
    });
    QVERIFY(!m_window->files().save());
    QVERIFY(asked);
}

/// Whether a second goes by without a frame. What is still to come after the last change (the
/// picture in full, the name of what is under the cursor) takes as long as the machine is slow.
bool TestMainWindow::comesToRest()
{
    for (int seconds = 0; seconds < 20; ++seconds) {
        const int painted = m_view->paintCount();
        QTest::qWait(1000);
        if (m_view->paintCount() == painted)
            return true;
    }
    return false;
}

void TestMainWindow::nothingIsPaintedWhenNothingChanges()
{
    drawFirst();
    QVERIFY2(comesToRest(), "the view paints on and on");
}

void TestMainWindow::movingOverTheSamePaintsNothing()
{
    drawFirst();
    for (const QPoint &start : {onScreen(worldBounds(*first().shape, first().frame).center()),
                                QPoint(m_view->width() / 2, 14)}) {
        move(start);
        QVERIFY(comesToRest()); // its name is shown
        const int painted = m_view->paintCount();
        for (int i = 0; i < 8; ++i)
            move(start + QPoint(i, 0));
        QTest::qWait(200);
        QCOMPARE(m_view->paintCount(), painted);
    }
}

// Wrong: the outline stays, is painted again and again, or everything is drawn anew for it.
void TestMainWindow::aStepUnderTheCursorIsOutlined()
{
    drawFirst();
    drawSecond();
    m_window->findChild<FirstSections *>()->takeAsIs(); // what is wrong has its outlines
    m_window->bench().select({});
    m_window->findChild<QDockWidget *>(QStringLiteral("historyDock"))->raise();
    auto *list = m_window->findChild<QAbstractItemView *>(QStringLiteral("historyList"));
    QTRY_VERIFY(list->viewport()->isVisible());
    const auto moveTo = [&](const QPoint &inList) {
        QTest::mouseMove(m_window->windowHandle(), list->viewport()->mapTo(m_window.get(), inList),
                         5);
    };
    const auto row = [&](int i) { return list->visualRect(list->model()->index(i, 0)).center(); };
    moveTo(row(0));
    QVERIFY(comesToRest());
    const QImage before = m_view->grabFramebuffer();
    const int opaque = m_view->renderer().drawCount();
    moveTo(row(2));
    QTRY_VERIFY(!m_window->bench().outlined().empty());
    QVERIFY(comesToRest());
    QVERIFY(m_view->grabFramebuffer() != before);
    const int painted = m_view->paintCount();
    moveTo(row(2) + QPoint(6, 2));
    QTest::qWait(100);
    QCOMPARE(m_view->paintCount(), painted);
    moveTo(row(0));
    QTRY_VERIFY(m_window->bench().outlined().empty());
    QVERIFY(comesToRest());
    QCOMPARE(m_view->grabFramebuffer(), before);
    QCOMPARE(m_view->renderer().drawCount(), opaque);
}

// Wrong: numbers that cannot be clicked, or that draw, select or turn instead.
void TestMainWindow::aProblemIsChosenByItsNumber()
{
    drawFirst(); // which alone is only begun
    drawSecond();
    QTRY_VERIFY(!interaction().marks().empty());
    const auto place = [&] {
        const std::vector<PlacedMark> placed =
            placeMarks(interaction().marks(), interaction().camera(), interaction().viewport(), {});
        return placed.empty() ? Vec2(0, 0) : placed.front().centre;
    };
    const QPoint at(static_cast<int>(place().x()), static_cast<int>(place().y()));
    auto *row = m_window->findChild<QAbstractButton *>(QStringLiteral("checkRow0"));
    move(at);
    QTRY_COMPARE(interaction().hovered().problem, 1);
    const Camera camera = interaction().camera();
    press(at);
    release(at);
    QTRY_VERIFY(row->isChecked());
    QVERIFY(interaction().camera().target == camera.target); // it was in sight
    QCOMPARE(count(), std::size_t(2));
}

void TestMainWindow::viewActionsShowTheirState()
{
    drawFirst();
    const auto action = [this](const char *id) {
        return m_window->findChild<QAction *>(QLatin1String(id));
    };
    QVERIFY(!action("view.xray")->isChecked());
    QTest::keyClick(m_view, Qt::Key_X);
    QVERIFY(action("view.xray")->isChecked());
    QVERIFY(interaction().view().isXray);
    auto *chip = m_window->findChild<QAbstractButton *>(QStringLiteral("xrayChip"));
    QVERIFY(chip->isVisible()); // it says why the model looks so, and ends it
    QTest::mouseClick(chip, Qt::LeftButton);
    QVERIFY(!interaction().view().isXray && !chip->isVisible());
    QTest::keyClick(m_view, Qt::Key_X);
    QTest::keyClick(m_view, Qt::Key_V);
    QVERIFY(action("view.perspective")->isChecked());
    QTest::keyClick(m_view, Qt::Key_C);
    QVERIFY(action("view.clip")->isChecked());
    QVERIFY(m_window->findChild<QAbstractButton *>(QStringLiteral("cutChip"))->isVisible());
    m_window->bench().select({});
    QTest::keyClick(m_view, Qt::Key_Escape); // what is offered of the stroke goes first
    QTest::keyClick(m_view, Qt::Key_Escape);
    QVERIFY(!action("view.clip")->isChecked());
    const SectionRef ref = session().committed().ref(0);
    QVERIFY(!action("view.showAll")->isEnabled());
    m_window->bench().setHidden(ref, true);
    QVERIFY(m_window->bench().isHidden(ref));
    QVERIFY(action("view.showAll")->isEnabled());
    QTest::keyClick(m_view, Qt::Key_H, Qt::ShiftModifier);
    QVERIFY(!m_window->bench().isHidden(ref));
}

// Wrong: a model drawn anew for a word beside it.
void TestMainWindow::badgesCostTheViewNoFrame()
{
    drawFirst();
    auto *badge = m_window->findChild<QAbstractButton *>(QStringLiteral("badge0"));
    QTRY_VERIFY(badge && badge->isVisible());
    QTest::qWait(700); // the verdicts are in, the view is at rest
    const int painted = m_view->paintCount();
    for (int i = 0; i < 5; ++i) {
        badge->update();
        QTest::qWait(30);
    }
    QCOMPARE(m_view->paintCount(), painted);
}

void TestMainWindow::lettersWorkOnlyInTheView()
{
    drawFirst();
    const auto orientation = [this] { return interaction().camera().orientation; };
    const Eigen::Quaterniond front = orientation();
    auto *filter = m_window->findChild<QLineEdit *>(QStringLiteral("outlineFilter"));
    filter->setFocus();
    QTest::keyClick(filter, Qt::Key_2);
    QCOMPARE(filter->text(), QStringLiteral("2"));
    QTest::qWait(100);
    QVERIFY(orientation().isApprox(front));
    filter->clear();
    m_view->setFocus();
    QTest::keyClick(m_view, Qt::Key_2);
    Eigen::Quaterniond top;
    QVERIFY(orientationOfView("top", top));
    QTRY_VERIFY(std::abs(orientation().dot(top)) > 0.9999);
}

void TestMainWindow::narrowWindowsHaveOneColumn()
{
    auto *outline = m_window->findChild<OutlineDock *>();
    auto *properties = m_window->findChild<PropertiesDock *>();
    QCOMPARE(m_window->dockWidgetArea(outline), Qt::LeftDockWidgetArea);
    QCOMPARE(outline->width(), 264);
    QCOMPARE(properties->width(), 322);
    m_window->resize(1024, 640);
    QTRY_COMPARE(m_window->width(), 1024);
    QCOMPARE(m_window->dockWidgetArea(outline), Qt::RightDockWidgetArea);
    QTRY_VERIFY(m_view->width() >= 700);
    m_window->resize(1440, 900);
    QTRY_COMPARE(m_window->dockWidgetArea(outline), Qt::LeftDockWidgetArea);
}

// Wrong: a dock that was opened or moved goes where the program wants it because the window has
// another width.
void TestMainWindow::otherWidthsKeepWhatWasArranged()
{
    auto *outline = m_window->findChild<OutlineDock *>();
    auto *history = m_window->findChild<QDockWidget *>(QStringLiteral("historyDock"));
    auto *values = m_window->findChild<QDockWidget *>(QStringLiteral("valuesDock"));
    QVERIFY(history && values && values->isHidden());
    values->show();
    history->close();
    m_window->resize(1024, 640);
    QTRY_COMPARE(m_window->dockWidgetArea(outline), Qt::RightDockWidgetArea);
    QVERIFY(!values->isHidden());
    QVERIFY(history->isHidden());

    m_window->resize(1440, 900);
    QTRY_COMPARE(m_window->dockWidgetArea(outline), Qt::LeftDockWidgetArea);
    m_window->addDockWidget(Qt::LeftDockWidgetArea, values);
    m_window->resize(1024, 640);
    QTRY_COMPARE(m_window->width(), 1024);
    QCOMPARE(m_window->dockWidgetArea(outline), Qt::LeftDockWidgetArea);
    QCOMPARE(m_window->dockWidgetArea(values), Qt::LeftDockWidgetArea);
}

FFF_TEST_WITH(TestMainWindow, runInWindowProgram<TestMainWindow>)
#include "tst_main_window.moc"
