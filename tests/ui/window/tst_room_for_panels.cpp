// How panels and the view share a window, with real events: nothing lies over anything else, and
// what is read stays where it was.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"

#include <QDockWidget>
#include <QLabel>
#include <QTabBar>

using namespace fff;
using namespace fff::ui;

class TestRoomForPanels : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { closeWindow(); }

    void sheetsDoNotLieOverTheView_data();
    void sheetsDoNotLieOverTheView();
    void whatWasFittedIsStillSeen();
    void titlesOfBothSidesAreLevel();
    void theHeadStaysWhileAStrokeIsDrawn();

private:
    QRect inWindow(const QWidget *widget) const
    {
        return {widget->mapTo(m_window.get(), QPoint()), widget->size()};
    }
    QDockWidget *dock(const char *name) const
    {
        return m_window->findChild<QDockWidget *>(QLatin1String(name));
    }
    void showSheets()
    {
        bench().run(QStringLiteral("fabricate.sheets"));
        QTRY_VERIFY(dock("sheetsDock")->isVisible());
        QTest::qWait(250); // docks slide in
    }
    /// How high on the screen an icon or a title is.
    int topOf(const char *label) const
    {
        return inWindow(m_window->findChild<QLabel *>(QLatin1String(label))).top();
    }
};

void TestRoomForPanels::sheetsDoNotLieOverTheView_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("the least window") << QSize(1024, 640);
    QTest::newRow("the usual one") << QSize(1440, 900);
}

// Wrong: the view keeps more height than there is, and its lower part is under the dock.
void TestRoomForPanels::sheetsDoNotLieOverTheView()
{
    QFETCH(QSize, size);
    openWindow(size);
    drawFirst();
    showSheets();
    const QRect view = inWindow(m_view), sheets = inWindow(dock("sheetsDock"));
    QVERIFY2(
        !view.intersects(sheets),
        qPrintable(
            QStringLiteral("view to %1, sheets from %2").arg(view.bottom()).arg(sheets.top())));
    QVERIFY2(view.height() >= 240, qPrintable(QString::number(view.height())));
    QVERIFY(m_window->rect().contains(sheets));
}

void TestRoomForPanels::whatWasFittedIsStillSeen()
{
    openWindow({1024, 640});
    drawFirst();
    bench().run(QStringLiteral("view.fitAll"));
    showSheets();
    const QRect seen = inWindow(m_view).intersected(m_window->rect());
    const Section &section = first();
    const Box2 bounds = section.shape->bounds();
    for (const Vec2 &corner : {bounds.min, bounds.max}) {
        const QPoint there = m_view->mapTo(m_window.get(), onScreen(section.frame.toWorld(corner)));
        QVERIFY(seen.contains(there));
        QVERIFY(!inWindow(dock("sheetsDock")).contains(there));
    }
}

// Wrong: at the right a row of tabs stands above the title that says the same.
void TestRoomForPanels::titlesOfBothSidesAreLevel()
{
    openWindow();
    QCOMPARE(inWindow(dock("propertiesDock")).top(), inWindow(dock("outlineDock")).top());
    // In a narrow window all of them are tabs at the right, which are looked for at the top.
    m_window->resize(1024, 640);
    m_window->resetLayout();
    QTest::qWait(50);
    for (const QTabBar *tabs :
         m_window->findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
        if (tabs->isVisible())
            QVERIFY(inWindow(tabs).top() < inWindow(dock("propertiesDock")).top());
}

// Wrong: icon and name jump by some pixels as soon as the hand draws, and jump back.
void TestRoomForPanels::theHeadStaysWhileAStrokeIsDrawn()
{
    openWindow();
    drawFirst();
    const int before = topOf("propertiesIcon");
    pullSlit();
    QTRY_VERIFY(m_window->findChild<QLabel *>(QStringLiteral("drawnIcon"))->isVisible());
    QCOMPARE(topOf("drawnIcon"), before);
    release(m_cursor);
}

FFF_TEST_WITH(TestRoomForPanels, runInWindowProgram<TestRoomForPanels>)
#include "tst_room_for_panels.moc"
