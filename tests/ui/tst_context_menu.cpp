// The menu of a right click in a real window, and another model that is inserted.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/document_file.h"
#include "core/model/origin.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "ui/base/theme.h"
#include "ui/files/document_files.h"

#include <QMenu>

using namespace fff;
using namespace fff::ui;

class TestContextMenu : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        openWindow();
        drawFirst();
        drawSecond();
        m_view->setFocus();
        key(Qt::Key_0);
        QTRY_VERIFY(!interaction().isAnimating());
        bench().select({});
    }
    void cleanup() { closeWindow(); }

    void onASection();
    void onWhatIsSelectedAllStays();
    void onAPoint();
    void onASectionThatIsMade();
    void inTheColoursOfTheTheme();
    void besideEverything();
    void aDragTurnsTheView();
    void byKey();
    void notWhileSomethingIsDrawn();
    void anotherModelComesBeside();
    void whatCannotBeInserted();

private:
    QMenu *menu() const
    {
        for (QMenu *menu : m_view->findChildren<QMenu *>(QStringLiteral("contextMenu")))
            if (menu->isVisible())
                return menu;
        return nullptr;
    }
    QStringList ids() const
    {
        QStringList ids;
        for (const QAction *action : menu()->actions())
            ids += action->objectName();
        return ids;
    }
    void choose(const char *id)
    {
        for (QAction *action : menu()->actions())
            if (action->objectName() == QLatin1String(id)) {
                QTest::mouseClick(menu(), Qt::LeftButton, {},
                                  menu()->actionGeometry(action).center());
                return;
            }
        QFAIL(id);
    }
    void rightClick(const QPoint &inView)
    {
        move(inView);
        const QPoint at = m_view->mapTo(m_window.get(), inView);
        QTest::mousePress(m_window->windowHandle(), Qt::RightButton, {}, at, 5);
        QTest::mouseRelease(m_window->windowHandle(), Qt::RightButton, {}, at, 5);
    }
    /// A place of the section that no other one hides, and no point of its.
    QPoint placeOf(int section) const
    {
        const Vec2 size(m_view->width(), m_view->height());
        const Model &model = session().committed();
        for (int y = 120; y < m_view->height() - 40; y += 7)
            for (int x = 20; x < m_view->width() - 160; x += 7) {
                const auto hits = pick(model, interaction().camera().rayThrough(Vec2(x, y), size));
                if (hits.size() == 1 && hits.front().section == section)
                    return {x + 12, y + 12};
            }
        return {};
    }
};

// Wrong: what can be done with a section would be in menus far away only.
void TestContextMenu::onASection()
{
    rightClick(placeOf(0));
    QTRY_VERIFY(menu());
    QCOMPARE(interaction().selection(), std::vector<SectionRef>{first().ref()});
    const QStringList there = ids();
    for (const char *id : {"section.transform", "edit.duplicate", "edit.delete", "section.lock",
                           "view.hide", "section.redraw"})
        QVERIFY2(there.contains(QLatin1String(id)), id);
    QVERIFY(!there.contains(QStringLiteral("section.removeHoles"))); // it has none
    choose("edit.duplicate");
    QTRY_COMPARE(count(), std::size_t(3));
    QVERIFY(!menu());
}

// Wrong: in dark its icons, which are light then, would lie on white.
void TestContextMenu::inTheColoursOfTheTheme()
{
    settings().setColourScheme(ColourScheme::Dark);
    rightClick(placeOf(0));
    QTRY_VERIFY(menu());
    QCOMPARE(menu()->palette().color(QPalette::Window), theme().palette().color(QPalette::Window));
    const QList<QMenu *> deeper = menu()->findChildren<QMenu *>();
    QVERIFY(!deeper.isEmpty());
    for (const QMenu *one : deeper)
        QCOMPARE(one->palette().color(QPalette::Window), theme().palette().color(QPalette::Window));
    menu()->close();
    QTRY_VERIFY(!menu());
    settings().setColourScheme(ColourScheme::System);
}

// Wrong: a menu on one of several would leave only that one selected.
void TestContextMenu::onWhatIsSelectedAllStays()
{
    bench().run(QStringLiteral("edit.selectAll"));
    rightClick(placeOf(0));
    QTRY_VERIFY(menu());
    QCOMPARE(interaction().selection().size(), std::size_t(2));
    choose("edit.delete");
    QTRY_COMPARE(count(), std::size_t(0));
}

// Wrong: points would be deleted with their section, or the menu would be about another one.
void TestContextMenu::onAPoint()
{
    bench().select({first().ref()});
    const Section &section = first();
    const QPoint at = onScreen(section.frame.toWorld(section.shape->contour().segment(2).p0));
    move(at);
    QTRY_VERIFY(interaction().hoveredPoint());
    rightClick(at);
    QTRY_VERIFY(menu());
    QCOMPARE(interaction().points().points().size(), std::size_t(1));
    const int points = section.shape->contour().segmentCount();
    choose("point.delete");
    QTRY_COMPARE(first().shape->contour().segmentCount(), points - 1);
}

// Wrong: nobody would find how to edit what an operation makes.
void TestContextMenu::onASectionThatIsMade()
{
    bench().run(QStringLiteral("operation.linear"),
                {{"section", session().committed().section(1)->name},
                 {"along", first().name},
                 {"count", "4"}});
    bench().select({});
    key(Qt::Key_Home);
    QTRY_VERIFY(!interaction().isAnimating());
    const int made = static_cast<int>(count()) - 1;
    const QPoint at = placeOf(made);
    QVERIFY(!at.isNull());
    rightClick(at);
    QTRY_VERIFY(menu());
    const SectionRef chosen = interaction().selection().front();
    QVERIFY(chosen.operation.isValid());
    QVERIFY(ids().contains(QStringLiteral("operation.detach")));
    choose("operation.leaveOut");
    QTRY_COMPARE(static_cast<int>(count()), made);
}

// Wrong: the view itself would have no menu.
void TestContextMenu::besideEverything()
{
    bench().run(QStringLiteral("edit.selectAll"));
    rightClick({30, m_view->height() - 30});
    QTRY_VERIFY(menu());
    QVERIFY(ids().contains(QStringLiteral("edit.paste")));
    QVERIFY(ids().contains(QStringLiteral("view.fitAll")));
    QTest::keyClick(menu(), Qt::Key_Escape);
    QTRY_VERIFY(!menu());
    QCOMPARE(interaction().selection().size(), std::size_t(2)); // nothing was done
}

// Wrong: turning the view with the right button would end in a menu.
void TestContextMenu::aDragTurnsTheView()
{
    const Camera before = interaction().camera();
    const QPoint from = m_view->mapTo(m_window.get(), QPoint(100, 300));
    QTest::mousePress(m_window->windowHandle(), Qt::RightButton, {}, from, 5);
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(m_window->windowHandle(), from + QPoint(10 * i, 0), 5);
    QTest::mouseRelease(m_window->windowHandle(), Qt::RightButton, {}, from + QPoint(50, 0), 5);
    QTRY_VERIFY(!(interaction().camera() == before));
    QVERIFY(!menu());
}

// Wrong: without a mouse there would be no menu.
void TestContextMenu::byKey()
{
    bench().select({first().ref()});
    m_view->setFocus();
    QContextMenuEvent asked(QContextMenuEvent::Keyboard, QPoint(5, 5),
                            m_view->mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(m_view, &asked);
    QTRY_VERIFY(menu());
    QVERIFY(ids().contains(QStringLiteral("section.transform")));
    QTest::keyClick(menu(), Qt::Key_Down);
    QTest::keyClick(menu(), Qt::Key_Return);
    QTRY_VERIFY(interaction().tool());
}

// Wrong: a slip of the other button would break off what is drawn.
void TestContextMenu::notWhileSomethingIsDrawn()
{
    const QPoint on = placeOf(0);
    move(on);
    press(on);
    move(on + QPoint(12, 0));
    QVERIFY(interaction().hasGesture());
    rightClick(on + QPoint(12, 0));
    QVERIFY(!menu());
    key(Qt::Key_Escape);
    release(on + QPoint(12, 0));
    key(Qt::Key_P);
    rightClick(on);
    QVERIFY(!menu());
}

// Wrong: a model could not be made of others.
void TestContextMenu::anotherModelComesBeside()
{
    const Document before = session().committed().document;
    const QString path = m_folder->filePath(QStringLiteral("other.fff"));
    QVERIFY(io::writeDocument(path, before));
    auto *files = m_window->findChild<DocumentFiles *>();
    QVERIFY(files->insertFile(path));
    QCOMPARE(count(), std::size_t(4));
    QCOMPARE(session().history()->undoText(), QStringLiteral("Insert other.fff"));
    QCOMPARE(interaction().selection().size(), std::size_t(2));
    const auto boxOf = [this](std::size_t a, std::size_t b) {
        Box3 box;
        for (const std::size_t i : {a, b}) {
            const Section &section = *session().committed().section(i);
            box.extend(worldBounds(*section.shape, section.frame));
        }
        return box;
    };
    QVERIFY(boxOf(2, 3).min.x() > boxOf(0, 1).max.x() + 19.0);
    QVERIFY(files->name().startsWith(QStringLiteral("untitled"))); // it is still this model
    session().history()->undo();
    QVERIFY(session().committed().document.isSame(before));
}

// Wrong: a file that is no model, or has nothing in it, would be a step of the history.
void TestContextMenu::whatCannotBeInserted()
{
    auto *files = m_window->findChild<DocumentFiles *>();
    const int before = steps();
    QVERIFY(!files->insertFile(m_folder->filePath(QStringLiteral("missing.fff"))));
    const QString empty = m_folder->filePath(QStringLiteral("empty.fff"));
    QVERIFY(io::writeDocument(empty, newDocument()));
    QVERIFY(!files->insertFile(empty));
    QCOMPARE(steps(), before);
}

FFF_TEST_WITH(TestContextMenu, runInWindowProgram<TestContextMenu>)
#include "tst_context_menu.moc"
