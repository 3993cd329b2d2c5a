// The pen in a real window: mouse, keys, and the bar for numbers.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/tool.h"
#include "ui/canvas_bar.h"
#include "ui/field_style.h"
#include "ui/main_window.h"
#include "ui/settings/settings.h"
#include "ui/viewport.h"
#include "ui/workbench.h"

#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QSurfaceFormat>
#include <QTemporaryDir>

#include <cmath>

using namespace fff;
using namespace fff::ui;

class TestPenWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();

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
    QPoint onScreen(double x, double y) const;
    void move(const QPoint &inView);
    void click(const QPoint &inView);
    void keyClick(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
    void type(const QString &text);
    void takePen();
    QDoubleSpinBox *field(const char *name) const
    {
        return m_window->findChild<QDoubleSpinBox *>(QLatin1String(name));
    }
    CanvasBar *bar() const { return m_window->findChild<CanvasBar *>(); }
    const Interaction &interaction() const { return m_window->bench().interaction(); }
    std::size_t pointCount() const
    {
        const auto &pen = interaction().overlay().pen;
        return pen ? pen->points.size() : 0;
    }
    Vec3 point(std::size_t i) const
    {
        const PenMarks &pen = *interaction().overlay().pen;
        return pen.canvas.toWorld(pen.points[i].at);
    }
    Session &session() { return m_window->bench().session(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    Viewport *m_view = nullptr;
};

void TestPenWindow::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    Settings::setFile(m_folder->filePath(QStringLiteral("settings.ini")));
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1280, 800);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QApplication::setActiveWindow(m_window.get());
    m_view = m_window->findChild<Viewport *>(QStringLiteral("viewport"));
    QTRY_VERIFY(m_view->isValid());
    QTRY_VERIFY(m_view->hasFocus());
}

void TestPenWindow::cleanup()
{
    m_window.reset();
}

/// Of a place in the front plane, mm.
QPoint TestPenWindow::onScreen(double x, double y) const
{
    const Vec2 p = interaction().camera().toScreen({x, y, 0.0}, interaction().viewport());
    return {static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y()))};
}

void TestPenWindow::move(const QPoint &inView)
{
    QTest::mouseMove(m_window->windowHandle(), m_view->mapTo(m_window.get(), inView), 5);
    QTest::qWait(10); // the moves of a burst are taken in
}

void TestPenWindow::click(const QPoint &inView)
{
    move(inView);
    const QPoint at = m_view->mapTo(m_window.get(), inView);
    // Slow enough for two of them to be none: a double click closes.
    QTest::mousePress(m_window->windowHandle(), Qt::LeftButton, {}, at, 420);
    QTest::mouseRelease(m_window->windowHandle(), Qt::LeftButton, {}, at, 5);
}

void TestPenWindow::keyClick(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(m_window->windowHandle(), key, modifiers, 5);
}

void TestPenWindow::type(const QString &text)
{
    for (const QChar c : text)
        QTest::keyClick(m_window->windowHandle(), c.toLatin1(), Qt::NoModifier, 5);
}

void TestPenWindow::takePen()
{
    keyClick(Qt::Key_P);
    QVERIFY(interaction().tool());
    QVERIFY(m_window->findChild<QAction *>(QStringLiteral("section.pen"))->isChecked());
}

void TestPenWindow::aRectangleByClicks()
{
    takePen();
    for (const Vec2 &corner : {Vec2(-30, 40), Vec2(30, 40), Vec2(30, 80), Vec2(-30, 80)})
        click(onScreen(corner.x(), corner.y()));
    QCOMPARE(pointCount(), std::size_t(4));
    QVERIFY(session().hasPreview());
    keyClick(Qt::Key_Return);
    QCOMPARE(session().committed().sectionCount(), std::size_t(1));
    QCOMPARE(session().history()->count(), 1);
    const Shape &shape = *session().committed().section(0)->shape;
    QCOMPARE(shape.contour().segmentCount(), 4);
    QVERIFY(std::abs(shape.area() - 2400.0) < 1e-6);
    keyClick(Qt::Key_P);
    QVERIFY(!interaction().tool());
}

/// A whole triangle without the mouse.
void TestPenWindow::numbersAreTyped()
{
    takePen();
    type(QStringLiteral("-20.5"));
    QVERIFY(bar()->isVisible());
    QVERIFY(field("canvasX")->hasFocus());
    keyClick(Qt::Key_Tab);
    QVERIFY(field("canvasY")->hasFocus());
    type(QStringLiteral("12"));
    // Shown before it is set.
    QCOMPARE(pointCount(), std::size_t(0));
    QVERIFY(interaction().overlay().pen->next);
    const PenMarks &pen = *interaction().overlay().pen;
    QVERIFY((pen.canvas.toWorld(*pen.next) - Vec3(-20.5, 12, 0)).norm() < 1e-9);
    keyClick(Qt::Key_Return);
    QCOMPARE(pointCount(), std::size_t(1));
    QVERIFY((point(0) - Vec3(-20.5, 12, 0)).norm() < 1e-9);
    QVERIFY(!bar()->isVisible());
    QVERIFY(m_view->hasFocus());

    type(QStringLiteral("@"));
    QVERIFY(field("canvasLength")->hasFocus());
    type(QStringLiteral("40+1"));
    keyClick(Qt::Key_Tab);
    QVERIFY(field("canvasAngle")->hasFocus());
    type(QStringLiteral("0"));
    keyClick(Qt::Key_Return);
    QCOMPARE(pointCount(), std::size_t(2));
    QVERIFY((point(1) - Vec3(20.5, 12, 0)).norm() < 1e-9);

    type(QStringLiteral("0"));
    keyClick(Qt::Key_Tab);
    type(QStringLiteral("62"));
    keyClick(Qt::Key_Return);
    keyClick(Qt::Key_Return);
    QCOMPARE(session().committed().sectionCount(), std::size_t(1));
    QVERIFY(std::abs(session().committed().section(0)->shape->area() - 0.5 * 41 * 50) < 1e-6);
}

void TestPenWindow::escapeClosesTheBarFirst()
{
    takePen();
    click(onScreen(0, 60));
    type(QStringLiteral("7"));
    QVERIFY(bar()->isVisible());
    keyClick(Qt::Key_Escape);
    QVERIFY(!bar()->isVisible());
    QVERIFY(m_view->hasFocus());
    QCOMPARE(pointCount(), std::size_t(1));
    keyClick(Qt::Key_Escape);
    QCOMPARE(pointCount(), std::size_t(0));
    QVERIFY(interaction().tool());
    keyClick(Qt::Key_Escape);
    QVERIFY(!interaction().tool());
}

void TestPenWindow::tabGoesRoundTheBar()
{
    takePen();
    click(onScreen(0, 60));
    type(QStringLiteral("7"));
    for (const char *name : {"canvasY", "canvasLength", "canvasAngle", "canvasX"}) {
        keyClick(Qt::Key_Tab);
        QVERIFY(field(name)->hasFocus());
    }
    keyClick(Qt::Key_Backtab, Qt::ShiftModifier);
    QVERIFY(field("canvasAngle")->hasFocus());
    // A click in the view sets its own point and forgets the numbers.
    click(onScreen(40, 60));
    QVERIFY(!bar()->isVisible());
    QCOMPARE(pointCount(), std::size_t(2));
    QVERIFY(std::abs(point(1).x() - 40.0) < 5.0);
}

void TestPenWindow::theBarFitsANarrowView()
{
    m_window->resize(1024, 640);
    QTRY_COMPARE(m_window->width(), 1024);
    takePen();
    click(onScreen(0, 60));
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
        click(onScreen(corner.x(), corner.y()));
    QAction *undo = m_window->findChild<QAction *>(QStringLiteral("edit.undo"));
    QVERIFY(undo->isEnabled());
    keyClick(Qt::Key_Backspace);
    QCOMPARE(pointCount(), std::size_t(2));
    keyClick(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(pointCount(), std::size_t(3));
    keyClick(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(pointCount(), std::size_t(2));
    keyClick(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(pointCount(), std::size_t(3));
    QCOMPARE(session().history()->count(), 0);
    keyClick(Qt::Key_Escape);
    QVERIFY(!undo->isEnabled());
}

/// The pen borrows digits from the views, and gives them back.
void TestPenWindow::digitsTurnTheViewWithoutThePen()
{
    const Camera before = interaction().camera();
    takePen();
    keyClick(Qt::Key_3);
    QVERIFY(bar()->isVisible());
    QCOMPARE(interaction().targetCamera().orientation.angularDistance(before.orientation), 0.0);
    keyClick(Qt::Key_Escape);
    keyClick(Qt::Key_Escape);
    keyClick(Qt::Key_3);
    QVERIFY(!bar()->isVisible());
    QVERIFY(interaction().targetCamera().orientation.angularDistance(before.orientation) > 1.0);
}

void TestPenWindow::aParallelPlaneHasItsDistance()
{
    aRectangleByClicks();
    m_window->bench().run(QStringLiteral("edit.selectAll"));
    m_window->bench().run(QStringLiteral("section.planeParallel"));
    QVERIFY(bar()->isVisible());
    QVERIFY(field("canvasDistance")->isVisible());
    QVERIFY(!field("canvasX")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    type(QStringLiteral("31"));
    QVERIFY(field("canvasDistance")->hasFocus());
    QCOMPARE(interaction().numbers().front().value, 31.0);
    keyClick(Qt::Key_Return);
    QVERIFY(m_view->hasFocus());
    QVERIFY(bar()->isVisible()); // it can be changed until something is drawn
    keyClick(Qt::Key_Escape);
    QVERIFY(!interaction().tool());
    QVERIFY(!bar()->isVisible());
}

void TestPenWindow::snapIsKept()
{
    QVERIFY(interaction().settings().snaps);
    keyClick(Qt::Key_Q);
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
        click(onScreen(corner.x(), corner.y()));
    move(onScreen(-20, 90));
    QTest::qWait(1500); // the analysis of the preview, and the picture in full
    const int before = m_view->paintCount();
    QTest::qWait(300);
    QCOMPARE(m_view->paintCount(), before);
}

int main(int argc, char *argv[])
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    QSurfaceFormat::setDefaultFormat(format);
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom));
    QApplication application(argc, argv);
    QApplication::setStyle(new FieldStyle);
    TestPenWindow test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_pen_window.moc"
