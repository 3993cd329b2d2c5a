// The pen in a real window: mouse, keys, and the bar for numbers.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/tool.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "ui/window/canvas_bar.h"

#include <QAction>
#include <QDoubleSpinBox>

#include <cmath>

using namespace fff;
using namespace fff::ui;

class TestPenWindow : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow({1280, 800}); }
    void cleanup() { closeWindow(); }

    void aRectangleByClicks();
    void numbersAreTyped();
    void escapeClosesTheBarFirst();
    void tabGoesRoundTheBar();
    void theBarFitsANarrowView();
    void backspaceAndUndo();
    void digitsTurnTheViewWithoutThePen();
    void aParallelPlaneHasItsDistance();
    void snapIsKept();
    void restingPaintsNothing();

private:
    /// Of a place in the front plane, mm.
    QPoint inFront(double x, double y) const { return onScreen({x, y, 0.0}); }
    void setPoint(double x, double y);
    void type(const QString &text);
    void takePen();
    QDoubleSpinBox *field(const char *name) const
    {
        return m_window->findChild<QDoubleSpinBox *>(QLatin1String(name));
    }
    CanvasBar *bar() const { return m_window->findChild<CanvasBar *>(); }
    std::size_t pointCount() const
    {
        const auto *pen = interaction().overlay().find<PenMarks>();
        return pen ? pen->points.size() : 0;
    }
    Vec3 point(std::size_t i) const
    {
        const PenMarks &pen = *interaction().overlay().find<PenMarks>();
        return pen.canvas.toWorld(pen.points[i].at);
    }
};

void TestPenWindow::setPoint(double x, double y)
{
    const QPoint at = inFront(x, y);
    move(at);
    // Slow enough for two of them to be none: a double click closes.
    press(at, {}, 420);
    release(at);
}

void TestPenWindow::type(const QString &text)
{
    for (const QChar c : text)
        QTest::keyClick(m_window->windowHandle(), c.toLatin1(), Qt::NoModifier, 5);
}

void TestPenWindow::takePen()
{
    key(Qt::Key_P);
    QVERIFY(interaction().tool());
    QVERIFY(m_window->findChild<QAction *>(QStringLiteral("section.pen"))->isChecked());
}

void TestPenWindow::aRectangleByClicks()
{
    takePen();
    for (const Vec2 &corner : {Vec2(-30, 40), Vec2(30, 40), Vec2(30, 80), Vec2(-30, 80)})
        setPoint(corner.x(), corner.y());
    QCOMPARE(pointCount(), std::size_t(4));
    QVERIFY(session().hasPreview());
    key(Qt::Key_Return);
    QCOMPARE(count(), std::size_t(1));
    QCOMPARE(steps(), 1);
    const Shape &shape = *first().shape;
    QCOMPARE(shape.contour().segmentCount(), 4);
    QVERIFY(std::abs(shape.area() - 2400.0) < 1e-6);
    key(Qt::Key_P);
    QVERIFY(!interaction().tool());
}

/// A whole triangle without the mouse.
void TestPenWindow::numbersAreTyped()
{
    takePen();
    type(QStringLiteral("-20.5"));
    QVERIFY(bar()->isVisible());
    QVERIFY(field("canvasX")->hasFocus());
    key(Qt::Key_Tab);
    QVERIFY(field("canvasY")->hasFocus());
    type(QStringLiteral("12"));
    // Shown before it is set.
    QCOMPARE(pointCount(), std::size_t(0));
    QVERIFY(interaction().overlay().find<PenMarks>()->next);
    const PenMarks &pen = *interaction().overlay().find<PenMarks>();
    QVERIFY((pen.canvas.toWorld(*pen.next) - Vec3(-20.5, 12, 0)).norm() < 1e-9);
    key(Qt::Key_Return);
    QCOMPARE(pointCount(), std::size_t(1));
    QVERIFY((point(0) - Vec3(-20.5, 12, 0)).norm() < 1e-9);
    QVERIFY(!bar()->isVisible());
    QVERIFY(m_view->hasFocus());

    type(QStringLiteral("@"));
    QVERIFY(field("canvasLength")->hasFocus());
    type(QStringLiteral("40+1"));
    key(Qt::Key_Tab);
    QVERIFY(field("canvasAngle")->hasFocus());
    type(QStringLiteral("0"));
    key(Qt::Key_Return);
    QCOMPARE(pointCount(), std::size_t(2));
    QVERIFY((point(1) - Vec3(20.5, 12, 0)).norm() < 1e-9);

    type(QStringLiteral("0"));
    key(Qt::Key_Tab);
    type(QStringLiteral("62"));
    key(Qt::Key_Return);
    key(Qt::Key_Return);
    QCOMPARE(count(), std::size_t(1));
    QVERIFY(std::abs(first().shape->area() - 0.5 * 41 * 50) < 1e-6);
}

void TestPenWindow::escapeClosesTheBarFirst()
{
    takePen();
    setPoint(0, 60);
    type(QStringLiteral("7"));
    QVERIFY(bar()->isVisible());
    key(Qt::Key_Escape);
    QVERIFY(!bar()->isVisible());
    QVERIFY(m_view->hasFocus());
    QCOMPARE(pointCount(), std::size_t(1));
    key(Qt::Key_Escape);
    QCOMPARE(pointCount(), std::size_t(0));
    QVERIFY(interaction().tool());
    key(Qt::Key_Escape);
    QVERIFY(!interaction().tool());
}

void TestPenWindow::tabGoesRoundTheBar()
{
    takePen();
    setPoint(0, 60);
    type(QStringLiteral("7"));
    for (const char *name : {"canvasY", "canvasLength", "canvasAngle", "canvasX"}) {
        key(Qt::Key_Tab);
        QVERIFY(field(name)->hasFocus());
    }
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    QVERIFY(field("canvasAngle")->hasFocus());
    // A click in the view sets its own point and forgets the numbers.
    setPoint(40, 60);
    QVERIFY(!bar()->isVisible());
    QCOMPARE(pointCount(), std::size_t(2));
    QVERIFY(std::abs(point(1).x() - 40.0) < 5.0);
}

void TestPenWindow::theBarFitsANarrowView()
{
    m_window->resize(1024, 640);
    QTRY_COMPARE(m_window->width(), 1024);
    takePen();
    setPoint(0, 60);
    type(QStringLiteral("7"));
    QVERIFY(field("canvasAngle")->isVisible());
    QTRY_VERIFY(m_view->rect().contains(bar()->geometry()));
    for (const char *name : {"canvasX", "canvasY", "canvasLength", "canvasAngle"})
        QVERIFY(bar()->rect().contains(field(name)->geometry()));
}

void TestPenWindow::backspaceAndUndo()
{
    takePen();
    for (const Vec2 &corner : {Vec2(-30, 40), Vec2(30, 40), Vec2(30, 80)})
        setPoint(corner.x(), corner.y());
    QAction *undo = m_window->findChild<QAction *>(QStringLiteral("edit.undo"));
    QVERIFY(undo->isEnabled());
    key(Qt::Key_Backspace);
    QCOMPARE(pointCount(), std::size_t(2));
    key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(pointCount(), std::size_t(3));
    key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(pointCount(), std::size_t(2));
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(pointCount(), std::size_t(3));
    QCOMPARE(steps(), 0);
    key(Qt::Key_Escape);
    QVERIFY(!undo->isEnabled());
}

/// The pen borrows digits from the views, and gives them back.
void TestPenWindow::digitsTurnTheViewWithoutThePen()
{
    const Camera before = interaction().camera();
    takePen();
    key(Qt::Key_3);
    QVERIFY(bar()->isVisible());
    QCOMPARE(interaction().targetCamera().orientation.angularDistance(before.orientation), 0.0);
    key(Qt::Key_Escape);
    key(Qt::Key_Escape);
    key(Qt::Key_3);
    QVERIFY(!bar()->isVisible());
    QVERIFY(interaction().targetCamera().orientation.angularDistance(before.orientation) > 1.0);
}

void TestPenWindow::aParallelPlaneHasItsDistance()
{
    aRectangleByClicks();
    bench().run(QStringLiteral("edit.selectAll"));
    bench().run(QStringLiteral("section.planeParallel"));
    QVERIFY(bar()->isVisible());
    QVERIFY(field("canvasDistance")->isVisible());
    QVERIFY(!field("canvasX")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    type(QStringLiteral("31"));
    QVERIFY(field("canvasDistance")->hasFocus());
    QCOMPARE(interaction().numbers().front().value, 31.0);
    key(Qt::Key_Return);
    QVERIFY(m_view->hasFocus());
    QVERIFY(bar()->isVisible()); // it can be changed until something is drawn
    key(Qt::Key_Escape);
    QVERIFY(!interaction().tool());
    QVERIFY(!bar()->isVisible());
}

void TestPenWindow::snapIsKept()
{
    QVERIFY(interaction().settings().snaps);
    key(Qt::Key_Q);
    QVERIFY(!interaction().settings().snaps);
    QVERIFY(!m_window->findChild<QAction *>(QStringLiteral("section.snap"))->isChecked());
    const Settings again(m_folder->filePath(QStringLiteral("settings.ini")));
    QVERIFY(!again.isOn(DrawingSwitch::Snap));
}

/// An open path is no reason to paint while nothing changes.
void TestPenWindow::restingPaintsNothing()
{
    takePen();
    for (const Vec2 &corner : {Vec2(-30, 40), Vec2(30, 40), Vec2(30, 80)})
        setPoint(corner.x(), corner.y());
    move(inFront(-20, 90));
    QTest::qWait(1500); // the analysis of the preview, and the picture in full
    const int before = m_view->paintCount();
    QTest::qWait(300);
    QCOMPARE(m_view->paintCount(), before);
}

FFF_TEST_WITH(TestPenWindow, runInWindowProgram<TestPenWindow>)
#include "tst_pen_window.moc"
