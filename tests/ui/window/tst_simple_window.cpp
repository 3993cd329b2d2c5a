// The window of a class: what draws, checks and exports, and nothing else; and back.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/bindings.h"
#include "tests/test_program.h"
#include "tests/ui/dialogs/export_hand.h"
#include "tests/ui/docks/values_hand.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "ui/actions/action_finder.h"
#include "ui/settings/settings.h"
#include "ui/window/main_tool_bar.h"

#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestSimpleWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup()
    {
        settings().setSimpleWindow(false);
        closeWindow();
    }

    void itHasWhatDrawsChecksAndExports();
    void oneDrawsInIt();
    void allComesBackAsItWas();
    void valuesAreThereWhereThereAreSome();
    void theBarHasNoEmptyPlaces();
    void aKeyThatIsOffSaysSo();
    void exportAsksWhatIsNeeded();

private:
    QStringList seenDocks() const
    {
        QStringList seen;
        for (const QDockWidget *dock : m_window->findChildren<QDockWidget *>())
            if (dock->isVisible())
                seen += dock->objectName();
        seen.sort();
        return seen;
    }
    QStringList seenButtons() const
    {
        QStringList seen;
        auto *bar = m_window->findChild<MainToolBar *>();
        for (const QAction *action : bar->actions())
            if (action->isVisible() && !action->objectName().isEmpty())
                seen += action->objectName();
        return seen;
    }
};

void TestSimpleWindow::itHasWhatDrawsChecksAndExports()
{
    settings().setSimpleWindow(true);
    QTest::qWait(50);
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("checksDock")});
    QVERIFY(m_window->findChild<MainToolBar *>()->isVisible());
    const QStringList buttons = seenButtons();
    for (const char *id : {"file.save", "edit.undo", "section.pen", "section.addShape"})
        QVERIFY2(buttons.contains(QLatin1String(id)), id);
    for (const char *id :
         {"operation.linear", "edit.mirror", "physics.addWeight", "check.stress", "measure.ruler"})
        QVERIFY2(!buttons.contains(QLatin1String(id)), id);
    QStringList menus;
    for (const QAction *action : m_window->menuBar()->actions())
        if (action->isVisible())
            menus += action->text().remove(u'&');
    QCOMPARE(menus, (QStringList{QStringLiteral("File"), QStringLiteral("Edit"),
                                 QStringLiteral("View"), QStringLiteral("Section"),
                                 QStringLiteral("Checks"), QStringLiteral("Help")}));
    QSet<QString> found;
    for (const ListedAction &listed : listedActions(*m_window->menuBar()))
        found += listed.id;
    for (const char *id : {"file.export", "file.settings", "section.redraw", "check.showAssembly",
                           "point.delete", "help.firstSteps"})
        QVERIFY2(found.contains(QLatin1String(id)), id);
    for (const char *id : {"operation.grid", "value.handOn", "view.newValue", "template.addMesh",
                           "fabricate.stocks", "section.mark", "physics.pull"})
        QVERIFY2(!found.contains(QLatin1String(id)), id);
    for (const char *id : {"fabricate.sheets", "view.docks", "view.values"})
        bench().run(QLatin1String(id)); // nobody brings in another panel
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("checksDock")});
}

void TestSimpleWindow::oneDrawsInIt()
{
    settings().setSimpleWindow(true);
    m_view->setFocus();
    drag({middle() + QPoint(-90, 60), middle() + QPoint(-90, -60), middle() + QPoint(90, -60),
          middle() + QPoint(90, 60), middle() + QPoint(-88, 58)});
    QTRY_COMPARE(count(), std::size_t(1));
    click(middle());
    QTRY_COMPARE(interaction().selection().size(), std::size_t(1));
    key(Qt::Key_Delete);
    QTRY_COMPARE(count(), std::size_t(0));
}

// Wrong: a teacher who looks at what the class sees has to put all panels back.
void TestSimpleWindow::allComesBackAsItWas()
{
    const QStringList docks = seenDocks(), buttons = seenButtons();
    settings().setSimpleWindow(true);
    QTest::qWait(50);
    QVERIFY(seenDocks() != docks);
    settings().setSimpleWindow(false);
    QTest::qWait(50);
    QCOMPARE(seenDocks(), docks);
    QCOMPARE(seenButtons(), buttons);
    QVERIFY(bench().commands().isShown("operation.linear"));
}

// Wrong: a sample with sliders had none.
void TestSimpleWindow::valuesAreThereWhereThereAreSome()
{
    settings().setSimpleWindow(true);
    Document document = adjustable();
    Value width = *document.values.find(std::string_view("width"));
    width.isShown = true;
    document = changeValue(std::move(document), std::move(width)).value();
    session().reset(document);
    m_window->showDocument();
    QTest::qWait(50);
    QCOMPARE(seenDocks(),
             (QStringList{QStringLiteral("checksDock"), QStringLiteral("valuesDock")}));
    QVERIFY(!m_window->findChild<QWidget *>(QStringLiteral("valuesHandOn"))->isVisible());
    for (const QDockWidget *dock : m_window->findChildren<QDockWidget *>())
        if (dock->isVisible())
            QVERIFY2(dock->features() == QDockWidget::NoDockWidgetFeatures,
                     qPrintable(dock->objectName()));
    bench().run(QStringLiteral("value.set"), {{"name", "width"}, {"expression", "50 mm"}});
    QCOMPARE(session().committed().document.values.find(std::string_view("width"))->typed,
             std::string("50 mm"));
    session().reset(newDocument());
    QTest::qWait(50);
    QCOMPARE(seenDocks(), QStringList{QStringLiteral("checksDock")});
}

void TestSimpleWindow::theBarHasNoEmptyPlaces()
{
    const auto isTidy = [this] {
        bool wasSeparator = true;
        for (const QAction *action : m_window->findChild<MainToolBar *>()->actions()) {
            if (!action->isVisible())
                continue;
            if (action->isSeparator() && wasSeparator)
                return false;
            wasSeparator = action->isSeparator();
        }
        return true;
    };
    QVERIFY(isTidy());
    settings().setSimpleWindow(true);
    QTest::qWait(50);
    QVERIFY(isTidy());
    settings().setSimpleWindow(false);
    QTest::qWait(50);
    QVERIFY(isTidy());
    int separators = 0;
    for (const QAction *action : m_window->findChild<MainToolBar *>()->actions())
        separators += action->isSeparator() && action->isVisible() ? 1 : 0;
    QVERIFY(separators >= 4); // they came back
}

// Wrong: what a lesson's sheet says is pressed, and nothing at all happens.
void TestSimpleWindow::aKeyThatIsOffSaysSo()
{
    const auto *sentence = m_window->findChild<QLabel *>(QStringLiteral("statusSentence"));
    const auto says = [sentence] {
        return sentence->text().contains(QStringLiteral("simple window does without"));
    };
    settings().setSimpleWindow(true);
    m_view->setFocus();
    for (const auto &[letter, modifiers] :
         {std::pair(Qt::Key_L, Qt::KeyboardModifiers(Qt::ControlModifier)),
          std::pair(Qt::Key_W, Qt::KeyboardModifiers())}) { // of the window, and of the view
        key(Qt::Key_1); // looks from the front: what was said is over
        key(letter, modifiers);
        QTRY_VERIFY(says());
        press(middle());
        release(middle());
        QTRY_VERIFY(!says());
    }
    settings().setSimpleWindow(false);
    session().reset(squareDocument());
    m_view->setFocus();
    key(Qt::Key_L, Qt::ControlModifier);
    QTRY_VERIFY(interaction().tool()); // it is the command's again
    QVERIFY(!says());
}

// Wrong: a class reads of lead-ins and bridges before it has cut anything.
void TestSimpleWindow::exportAsksWhatIsNeeded()
{
    session().reset(squareDocument());
    const auto rows = [this] {
        QStringList seen;
        inExportPanel(*m_window, [&seen](QDialog *dialog) {
            for (const char *name : {"exportMachine", "exportKerf", "exportClearance", "exportFile",
                                     "exportSpacing", "exportBridges"}) {
                const auto *row = dialog->findChild<QWidget *>(QLatin1String(name));
                if (row && row->isVisible())
                    seen += QLatin1String(name);
            }
        });
        return seen;
    };
    QCOMPARE(rows().size(), qsizetype(6));
    settings().setSimpleWindow(true);
    QCOMPARE(rows(),
             (QStringList{QStringLiteral("exportMachine"), QStringLiteral("exportKerf"),
                          QStringLiteral("exportClearance"), QStringLiteral("exportFile")}));
}

FFF_TEST_WITH(TestSimpleWindow, runInWindowProgram<TestSimpleWindow>)
#include "tst_simple_window.moc"
