// A model that was handed on for adjusting, in a real window: what is there, what a hand can do,
// and the way back.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/test_program.h"
#include "tests/ui/docks/values_hand.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "ui/actions/action_finder.h"
#include "ui/files/document_files.h"
#include "ui/window/adjust_bar.h"
#include "ui/window/main_tool_bar.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QUndoStack>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

/// The width is shown, and has a note; a half of it is not.
Document handed(bool isHandedOn = true)
{
    Document document = adjustable();
    Value width = *document.values.find(std::string_view("width"));
    width.isShown = true;
    width.note = "of the board";
    document = changeValue(std::move(document), std::move(width)).value();
    document.opensForAdjusting = isHandedOn;
    return document;
}

} // namespace

class TestAdjusting : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void theWindowHasWhatIsNeeded();
    void menusHaveNoMoreThanCanBeDone();
    void nothingInTheViewEdits();
    void valuesAreSetAndTakenBack();
    void handingOnAndEditingAreSteps();
    void theAuthorsWindowComesBackAsItWas();
    void aFileOpensLikeThat();
    void whoOpensValuesSeesThem();
    void withoutAShownValueThereIsNothingToHandOn();

private:
    void show(const Document &document)
    {
        session().reset(document);
        m_window->showDocument();
        QTest::qWait(50);
    }
    QStringList seenDocks() const
    {
        QStringList seen;
        for (const QDockWidget *dock : m_window->findChildren<QDockWidget *>())
            if (dock->isVisible())
                seen += dock->objectName();
        seen.sort(); // raising one puts it behind the others
        return seen;
    }
    ValuesDock &dock() const { return *m_window->findChild<ValuesDock *>(); }
    QPushButton *button(const char *name) const
    {
        return m_window->findChild<QPushButton *>(QLatin1String(name));
    }
    QAction *actionNamed(const char *id) const
    {
        return m_window->findChild<QAction *>(QLatin1String(id));
    }
    QStringList shownRows() const
    {
        QStringList names;
        for (const ValueRow *row : m_window->findChildren<ValueRow *>())
            if (row->isVisible())
                names += row->findChild<QLineEdit *>(QStringLiteral("valueName"))->text();
        return names;
    }
};

void TestAdjusting::theWindowHasWhatIsNeeded()
{
    show(handed());
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("valuesDock")});
    QVERIFY(m_window->findChild<AdjustBar *>()->isVisible());
    QVERIFY(!m_window->findChild<MainToolBar *>()->isVisible());
    QVERIFY(button("adjustExport")->isVisible() && button("adjustExport")->isEnabled());
    QVERIFY(m_view->isVisible());
    QVERIFY(m_window->findChild<QWidget *>(QStringLiteral("badges"))->isVisible());
    // Only what is shown, and what it is for; it says what this is, and how to get out of it.
    QCOMPARE(shownRows(), QStringList{QStringLiteral("width")});
    QCOMPARE(dock().findChild<QLabel *>(QStringLiteral("valueNote"))->text(),
             QStringLiteral("of the board"));
    QVERIFY(dock().findChild<QLabel *>(QStringLiteral("valuesPurpose"))->isVisible());
    QVERIFY(!button("valueAdd")->isVisible());
    QVERIFY(button("valuesHandOn")->isVisible());
    QVERIFY(dock().features() == QDockWidget::NoDockWidgetFeatures);
    // Nobody brings another dock in by a way round.
    for (const char *id : {"fabricate.sheets", "view.docks", "view.resetWindow"})
        bench().run(QLatin1String(id));
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("valuesDock")});
}

// Wrong: what cannot be done is offered, in a menu, the search or by its key.
void TestAdjusting::menusHaveNoMoreThanCanBeDone()
{
    show(handed());
    QStringList menus;
    for (const QAction *action : m_window->menuBar()->actions()) {
        if (!action->isVisible())
            continue;
        menus += action->text().remove(u'&');
        int rows = 0;
        for (const QAction *row : action->menu()->actions())
            rows += !row->isSeparator() && row->isVisible() ? 1 : 0;
        QVERIFY2(rows > 0, qPrintable(action->text()));
    }
    QCOMPARE(menus, (QStringList{QStringLiteral("File"), QStringLiteral("Edit"),
                                 QStringLiteral("View"), QStringLiteral("Checks"),
                                 QStringLiteral("Help")}));
    QSet<QString> found;
    for (const ListedAction &listed : listedActions(*m_window->menuBar()))
        found += listed.id;
    for (const char *id : {"file.save", "file.export", "edit.undo", "view.fitAll", "value.handOn",
                           "check.showAssembly"})
        QVERIFY2(found.contains(QLatin1String(id)), id);
    for (const char *id : {"section.pen", "edit.delete", "edit.paste", "file.insert", "view.hide",
                           "operation.linear", "fabricate.stocks", "view.newValue"})
        QVERIFY2(!found.contains(QLatin1String(id)), id);
    QCOMPARE(actionNamed("value.handOn")->text(), QStringLiteral("Edit the design"));
}

void TestAdjusting::nothingInTheViewEdits()
{
    show(handed());
    bench().run(QStringLiteral("view.front"));
    QTRY_VERIFY(!interaction().isAnimating());
    const Document before = session().committed().document;
    const Section &board = first();
    const QPoint inside = onScreen(board.frame.toWorld(Vec2(30, 10)));
    m_view->setFocus();
    click(inside);
    QVERIFY(interaction().selection().empty());
    for (const Qt::Key pressed : {Qt::Key_Delete, Qt::Key_P, Qt::Key_G, Qt::Key_T, Qt::Key_O,
                                  Qt::Key_H, Qt::Key_W, Qt::Key_Left})
        key(pressed);
    key(Qt::Key_A, Qt::ControlModifier);
    key(Qt::Key_D, Qt::ControlModifier);
    QVERIFY(!interaction().tool());
    QVERIFY(interaction().selection().empty());
    // A drag out of the section turns the view.
    const Camera camera = interaction().camera();
    drag({inside, inside + QPoint(0, -120), inside + QPoint(160, -200), inside + QPoint(5, -260)});
    QTRY_VERIFY(!interaction().isAnimating());
    QVERIFY(!(interaction().camera() == camera));
    QVERIFY(session().committed().document.isSame(before));
    QCOMPARE(steps(), 0);
    // The menu of a right click has what looks.
    const QPoint at = m_view->mapTo(m_window.get(), middle());
    QTest::mousePress(m_window->windowHandle(), Qt::RightButton, {}, at, 5);
    QTest::mouseRelease(m_window->windowHandle(), Qt::RightButton, {}, at, 5);
    QMenu *menu = nullptr;
    QTRY_VERIFY((menu = m_view->findChild<QMenu *>(QStringLiteral("contextMenu"))));
    QStringList ids;
    for (const QAction *action : menu->actions())
        if (!action->isSeparator() && action->isVisible())
            ids += action->objectName();
    menu->close();
    QVERIFY(ids.contains(QStringLiteral("view.fitAll")));
    QVERIFY(!ids.contains(QStringLiteral("edit.selectAll")));
    QVERIFY(!ids.contains(QStringLiteral("section.pen")));
}

void TestAdjusting::valuesAreSetAndTakenBack()
{
    show(handed());
    const double before = session().committed().document.stocks.front()->thickness;
    bench().run(QStringLiteral("value.set"),
                {{"name", "width"}, {"expression", "60 mm"}}); // as a script does
    QCOMPARE(session().committed().document.stocks.front()->thickness, 6.0);
    QVERIFY(actionNamed("edit.undo")->isEnabled());
    actionNamed("edit.undo")->trigger();
    QCOMPARE(session().committed().document.stocks.front()->thickness, before);
    QVERIFY(session().committed().document.opensForAdjusting);
    // Enter goes to the first value.
    m_view->setFocus();
    key(Qt::Key_Return);
    QVERIFY(dock().isAncestorOf(QApplication::focusWidget()));
}

void TestAdjusting::handingOnAndEditingAreSteps()
{
    show(handed(false));
    actionNamed("view.values")->trigger();
    QTRY_VERIFY(dock().isVisible());
    QCOMPARE(actionNamed("value.handOn")->text(), QStringLiteral("Share for adjusting"));
    QTest::mouseClick(button("valuesHandOn"), Qt::LeftButton);
    QVERIFY(session().committed().document.opensForAdjusting);
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("valuesDock")});
    QCOMPARE(steps(), 1);
    QVERIFY(!session().isClean());
    session().history()->undo();
    QVERIFY(!session().committed().document.opensForAdjusting);
    QVERIFY(seenDocks().size() > 1);
    session().history()->redo();
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("valuesDock")});
    QTest::mouseClick(button("valuesHandOn"), Qt::LeftButton);
    QVERIFY(!session().committed().document.opensForAdjusting);
    QVERIFY(actionNamed("section.pen")->isVisible());
    QVERIFY(actionNamed("section.pen")->isEnabled());
    m_view->setFocus();
    bench().select({session().committed().ref(0)});
    QCOMPARE(interaction().selection().size(), std::size_t(1));
}

// Wrong: whoever looked at what others will see has to put all panels back.
void TestAdjusting::theAuthorsWindowComesBackAsItWas()
{
    show(handed(false));
    m_window->findChild<QDockWidget *>(QStringLiteral("historyDock"))->raise();
    bench().run(QStringLiteral("fabricate.sheets"));
    QTest::qWait(300);
    const QStringList before = seenDocks();
    const bool hadBar = m_window->findChild<MainToolBar *>()->isVisible();
    bench().run(QStringLiteral("value.handOn"));
    QTest::qWait(300);
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("valuesDock")});
    bench().run(QStringLiteral("value.handOn"));
    QTest::qWait(300);
    QCOMPARE(seenDocks(), before);
    QCOMPARE(m_window->findChild<MainToolBar *>()->isVisible(), hadBar);
    QVERIFY(!m_window->findChild<AdjustBar *>()->isVisible());
}

void TestAdjusting::aFileOpensLikeThat()
{
    const QString path = m_folder->filePath(QStringLiteral("handed.fff"));
    QVERIFY(io::writeDocument(path, handed()));
    QVERIFY(m_window->files().openFile(path, true)); // a copy is one, too
    m_window->showDocument();
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("valuesDock")});
    QVERIFY(session().isClean());
    // What was adjusted is saved as such.
    bench().run(QStringLiteral("value.set"), {{"name", "width"}, {"expression", "50 mm"}});
    const QString other = m_folder->filePath(QStringLiteral("adjusted.fff"));
    QVERIFY(m_window->files().saveFile(other));
    const auto read = io::readDocument(other);
    QVERIFY(read && read->document.opensForAdjusting);
    QCOMPARE(read->document.values.find(std::string_view("width"))->typed, std::string("50 mm"));
    // Another model in the same window is one to draw in.
    session().reset(squareDocument());
    QVERIFY(m_window->findChild<MainToolBar *>()->isVisible());
    QVERIFY(!m_window->findChild<AdjustBar *>()->isVisible());
}

// Wrong: a sample with sliders opens, and nobody sees that it has some.
void TestAdjusting::whoOpensValuesSeesThem()
{
    const QString path = m_folder->filePath(QStringLiteral("design.fff"));
    QVERIFY(io::writeDocument(path, handed(false)));
    QVERIFY(!dock().isVisible());
    QVERIFY(m_window->files().openFile(path));
    m_window->showDocument();
    QTRY_VERIFY(dock().isVisible() && !dock().visibleRegion().isEmpty());
    QCOMPARE(shownRows().first(), QStringLiteral("width"));
    // Once: who closes the panel has it closed.
    dock().close();
    m_window->showDocument();
    QVERIFY(!dock().isVisible());
}

void TestAdjusting::withoutAShownValueThereIsNothingToHandOn()
{
    show(adjustable());
    actionNamed("view.values")->trigger();
    QTRY_VERIFY(dock().isVisible());
    QVERIFY(!button("valuesHandOn")->isVisible());
    QVERIFY(!actionNamed("value.handOn")->isEnabled());
    // Somebody's file may be so all the same.
    Document nothing = adjustable();
    nothing.opensForAdjusting = true;
    show(nothing);
    QVERIFY(shownRows().isEmpty());
    QVERIFY(button("valuesHandOn")->isVisible());
    QTest::mouseClick(button("valuesHandOn"), Qt::LeftButton);
    QVERIFY(!session().committed().document.opensForAdjusting);
}

FFF_TEST_WITH(TestAdjusting, runInWindowProgram<TestAdjusting>)
#include "tst_adjusting.moc"
