// The way of somebody who has never done it, in a real window: two sections, five clicks, and the
// fish has its ribs.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/pick.h"
#include "core/operations/operation_kind.h"
#include "tests/test_program.h"
#include "tests/told.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"

#include <QAbstractButton>
#include <QImage>
#include <QStatusBar>
#include <QToolBar>
#include <QTreeWidget>

using namespace fff;
using namespace fff::ui;

class TestOperationsWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void fiveClicksMakeTheRibs();
    void whatIsMadeIsViolet();

private:
    QAction *action(const char *id) { return m_window->findChild<QAction *>(QLatin1String(id)); }
    /// A place of the section that no other one hides.
    QPoint placeOf(int section);
    void turnToCorner();
    void clickButton(const char *id);
    void makeRibs();
    /// How many pixels of the view are violet.
    int violet();
};

QPoint TestOperationsWindow::placeOf(int section)
{
    const Model &model = session().committed();
    const Vec2 size(m_view->width(), m_view->height());
    for (int y = 40; y < m_view->height(); y += 6)
        for (int x = 10; x < m_view->width(); x += 6) {
            const auto hits = pick(model, interaction().camera().rayThrough(Vec2(x, y), size));
            // The badges and the cube lie over the view.
            const bool isCovered = (y < 80) || (x > m_view->width() - 150 && y < 170);
            if (!isCovered && !hits.empty() && hits.front().section == section)
                return {x, y};
        }
    return {};
}

void TestOperationsWindow::turnToCorner()
{
    m_view->setFocus();
    key(Qt::Key_0);
    QTRY_VERIFY(!interaction().isAnimating());
    key(Qt::Key_Home);
    QTRY_VERIFY(!interaction().isAnimating());
}

void TestOperationsWindow::clickButton(const char *id)
{
    auto *bar = m_window->findChild<QToolBar *>(QStringLiteral("mainToolBar"));
    QWidget *button = bar->widgetForAction(action(id));
    QVERIFY(button);
    QTest::mouseClick(button, Qt::LeftButton);
}

void TestOperationsWindow::makeRibs()
{
    drawFirst();
    drawSecond();
    turnToCorner();
    bench().select({});
    clickButton("operation.linear"); // 1
    QVERIFY(interaction().tool());
    QVERIFY(action("operation.linear")->isChecked());
    click(placeOf(1)); // 2
    QCOMPARE(fff::test::roleAskedFor(interaction().hint()), std::string("along"));
    move(placeOf(0));
    QTRY_VERIFY2(session().hasPreview(), "seen before it is done");
    click(placeOf(0)); // 3
    QTRY_VERIFY(count() > 2);
}

// Wrong: what the paper's fish takes would be known to those alone who wrote the program.
void TestOperationsWindow::fiveClicksMakeTheRibs()
{
    makeRibs();
    QCOMPARE(steps(), 3);
    const std::size_t ribs = count() - 2;
    QVERIFY(ribs >= 2);
    // What was made is selected, its panel is open.
    auto *scale = m_window->findChild<QWidget *>(QStringLiteral("scale"));
    QVERIFY(scale && scale->isVisible());
    const SectionPointer before = session().committed().section(2);
    QWidget *button = nullptr;
    for (QAbstractButton *each : scale->findChildren<QAbstractButton *>())
        if (each->text() == QStringLiteral("By local thickness"))
            button = each;
    QVERIFY(button);
    QTest::mouseClick(button, Qt::LeftButton); // 4
    QCOMPARE(steps(), 4);
    QCOMPARE(count() - 2, ribs);
    QVERIFY2(session().committed().section(2)->shape != before->shape, "by the spine's thickness");
    auto *tree = m_window->findChild<QTreeWidget *>(QStringLiteral("operationTree"));
    QVERIFY(tree->isVisible());
    QVERIFY(tree->topLevelItem(0)->isSelected());
    // Back, and the very objects are there again.
    session().history()->undo();
    QCOMPARE(session().committed().section(2), before);
    // Beside the model, a click lets it be. (5)
    click({20, m_view->height() - 60});
    QVERIFY(!interaction().selectedOperation().isValid());
}

int TestOperationsWindow::violet()
{
    const QImage image = m_view->grabFramebuffer();
    int count = 0;
    for (int y = 0; y < image.height(); y += 2)
        for (int x = 0; x < image.width(); x += 2) {
            const QColor c = image.pixelColor(x, y);
            count += c.blue() > c.green() + 25 && c.red() > c.green() + 4 ? 1 : 0;
        }
    return count;
}

// Wrong: nobody would see which sections a number moves.
void TestOperationsWindow::whatIsMadeIsViolet()
{
    makeRibs();
    QTRY_VERIFY(violet() > 100);
    const int made = violet();
    bench().select({});
    QTRY_VERIFY(violet() < made / 10);
}

FFF_TEST_WITH(TestOperationsWindow, runInWindowProgram<TestOperationsWindow>)
#include "tst_operations_window.moc"
