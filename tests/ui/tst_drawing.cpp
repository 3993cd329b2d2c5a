// Drawing in the window with real mouse and key events: what a stroke shows while it is drawn,
// holes, redrawing, the keys that change a stroke, undo by key and by the history.
// First: Qt 6.4's moc fails on standard headers that it meets before one of Qt's.
#include <QTest>

#include "core/interaction/contour_words.h"
#include "core/interaction/stroke_words.h"
#include "core/interaction/tool.h"
#include "core/model/edit_words.h"
#include "tests/test_program.h"
#include "tests/told.h"
#include "tests/ui/view_hand.h"
#include "tests/ui/window_program.h"
#include "ui/docks/drawing_page.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QMouseEvent>
#include <QUndoView>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::ui;

class TestDrawing : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void aSecondAcrossTheFirst();
    void whatWasMeantIsOffered();
    void offerIsClicked();
    void aSlitIsMovedInBeforeItsOutlineBegins();
    void shiftKeepsOneSide();
    void propertiesTellWhatIsDrawn();
    void aHole();
    void aHoleBesideIsRefused();
    void aNewContour();
    void theGroundCutsFlat();
    void undoByKeyAndByHistory();
    void aGroupByRubberBand();
    void escapeLaysTheToolDown();
    void aStepShowsWhatItTookAway();
    void aLostButtonEndsTheStroke();
    void aDialogEndsTheStroke();
    void theViewChangesItsSize();
    void thePenTellsWhatItChanges();

private:
    /// Nearly a circle, a little further than once round.
    void drawRound()
    {
        std::vector<QPoint> round;
        for (int i = 0; i <= 40; ++i) {
            const double a = 2.0 * std::numbers::pi * i / 39.0;
            round.push_back(middle() +
                            QPoint(qRound(130.0 * std::cos(a)), qRound(124.0 * std::sin(a))));
        }
        drag(round);
    }

    QString text(const char *name)
    {
        const auto *label = m_window->findChild<QLabel *>(QLatin1String(name));
        return label ? label->text() : QString();
    }
    void drawOneSide();
    void drawOpenOval();
    void box(const QPoint &from, const QPoint &to);
};

/// Out of the dead zone to the right, round and back to it.
void TestDrawing::drawOneSide()
{
    const QPoint start = m_cursor;
    for (const QPoint &way :
         {QPoint(60, -40), QPoint(130, 20), QPoint(130, 120), QPoint(60, 190)}) {
        const QPoint from = m_cursor;
        for (int i = 1; i <= 8; ++i)
            move(from + (start + way - from) * i / 8);
    }
}

/// In the front view, with the button still held.
void TestDrawing::drawOpenOval()
{
    const auto at = [&](int i) {
        const double angle = radians(9.0 * i);
        return middle() + QPoint(static_cast<int>(150 * std::cos(angle)),
                                 static_cast<int>(-110 * std::sin(angle)));
    };
    move(at(0));
    press(at(0));
    for (int i = 1; i < 38; ++i)
        move(at(i));
    QTRY_VERIFY(bench().interaction().overlay().find<sign::Stroke>());
}

/// Four strokes in one go, from corner to corner.
void TestDrawing::box(const QPoint &from, const QPoint &to)
{
    const QPoint corners[] = {
        from, {to.x(), from.y()}, to, {from.x(), to.y()}, from + QPoint(0, 6)};
    move(from);
    press(from);
    QPoint at = from;
    for (const QPoint &corner : corners) {
        for (int i = 1; i <= 10; ++i)
            move(at + (corner - at) * i / 10);
        at = corner;
    }
    release(at);
}

void TestDrawing::aSecondAcrossTheFirst()
{
    drawFirst();
    drawSecond();
    QCOMPARE(count(), std::size_t(2));
    const Section &section = *session().committed().section(1);
    QVERIFY(section.parent);
    QVERIFY(std::abs(section.frame.normal().dot(first().frame.normal())) < 1e-9);
    QTRY_COMPARE(session().analysis().assembly.joints.size(), std::size_t(1));
}

// Wrong: the key that the words at the slit name does nothing until the outline has begun.
void TestDrawing::aSlitIsMovedInBeforeItsOutlineBegins()
{
    box(middle() + QPoint(-150, -60), middle() + QPoint(150, 60));
    QCOMPARE(count(), std::size_t(1));
    const QPoint from = middle() + QPoint(-147, 20);
    move(from);
    press(from, {}, 1000);
    for (int i = 1; i <= 10; ++i)
        move(from - QPoint(0, 10 * i));
    QTRY_VERIFY(interaction().hasOffer());
    QVERIFY(!interaction().overlay().find<sign::Stroke>());
    const auto isMovedIn = [this] {
        const sign::Slit *slit = interaction().overlay().find<sign::Slit>();
        return slit && interaction()
                               .camera()
                               .toScreen(slit->from, Vec2(m_view->width(), m_view->height()))
                               .x() > middle().x() - 145.0;
    };
    QVERIFY(!isMovedIn());
    key(Qt::Key_B);
    QVERIFY(isMovedIn());
    key(Qt::Key_B);
    QVERIFY(!isMovedIn());
    key(Qt::Key_Escape);
    release(m_cursor);
    QCOMPARE(count(), std::size_t(1));
}

/// A circle by hand, a key, and one step back.
void TestDrawing::whatWasMeantIsOffered()
{
    drawRound();
    QCOMPARE(count(), std::size_t(1));
    QVERIFY(interaction().hasOffer());
    QVERIFY(first().figures.empty());
    key(Qt::Key_B);
    QCOMPARE(first().figures.size(), std::size_t(1));
    QVERIFY(!interaction().hasOffer());
    key(Qt::Key_B); // nothing is offered any more
    QCOMPARE(steps(), 2);
    key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(first().figures.empty());
    QCOMPARE(count(), std::size_t(1));
}

/// A click on the words takes it, too; one beside them does without it.
void TestDrawing::offerIsClicked()
{
    drawRound();
    QVERIFY(interaction().hasOffer());
    QTest::qWait(50); // it is painted
    const QPoint words = middle() + QPoint(0, 124 + 20);
    // Inside its frame, above the words: light, and filled while the cursor is on it.
    const auto ground = [this, words] {
        return m_view->grabFramebuffer().pixelColor(words - QPoint(0, 9));
    };
    const QColor before = ground();
    QVERIFY(before.lightness() > 240);
    QTest::mouseMove(m_view, words);
    QTRY_COMPARE(m_view->cursor().shape(), Qt::PointingHandCursor);
    QTRY_VERIFY(ground().lightness() < 120);
    QTest::mouseMove(m_view, words + QPoint(0, 60));
    QTRY_COMPARE(ground(), before);
    QTest::mouseMove(m_view, words);
    QTRY_COMPARE(m_view->cursor().shape(), Qt::PointingHandCursor);
    QTest::mouseClick(m_view, Qt::LeftButton, {}, words);
    QCOMPARE(first().figures.size(), std::size_t(1));
    QVERIFY(!interaction().hasOffer() && !interaction().hasGesture());
    QCOMPARE(steps(), 2);
    key(Qt::Key_Z, Qt::ControlModifier);
    key(Qt::Key_Z, Qt::ControlModifier);
    drawRound();
    QVERIFY(interaction().hasOffer());
    QTest::qWait(50);
    QTest::mouseClick(m_view, Qt::LeftButton, {}, middle() + QPoint(0, 124 + 90));
    QVERIFY(!interaction().hasOffer());
    QVERIFY(first().figures.empty());
}

/// What would be wrong: the copied half stays although Shift is held, or comes only with the next
/// move of the mouse.
void TestDrawing::shiftKeepsOneSide()
{
    drawFirst();
    pullSlit();
    drawOneSide();
    QTRY_VERIFY(interaction().overlay().find<sign::Stroke>());
    QTRY_VERIFY(interaction().overlay().find<sign::Stroke>()->isMirrored);
    QCOMPARE(interaction().hint().words.text, hints::kReleaseToMirror);
    const double both = session().model().document.sections.back()->shape->area();
    QTest::keyPress(m_window->windowHandle(), Qt::Key_Shift, Qt::NoModifier, 5);
    QTRY_VERIFY(!interaction().overlay().find<sign::Stroke>()->isMirrored);
    QVERIFY(session().model().document.sections.back()->shape->area() < 0.7 * both);
    QTest::keyRelease(m_window->windowHandle(), Qt::Key_Shift, Qt::ShiftModifier, 5);
    QTRY_VERIFY(interaction().overlay().find<sign::Stroke>()->isMirrored);
    release(m_cursor);
    QTRY_COMPARE(count(), std::size_t(2));
    QVERIFY(std::abs(session().committed().section(1)->shape->area() - both) < 1e-9);
}

void TestDrawing::propertiesTellWhatIsDrawn()
{
    drawFirst();
    const auto *page = m_window->findChild<DrawingPage *>();
    QVERIFY(page && !page->isVisible());
    pullSlit();
    QTRY_VERIFY(page->isVisible());
    QCOMPARE(text("drawnParent"), QStringLiteral("Section 1"));
    QCOMPARE(text("drawnSize"), QStringLiteral("–"));
    drawOneSide();
    QTRY_VERIFY(text("drawnSize").contains(u'×'));
    QTRY_VERIFY(text("drawnSymmetry").contains(QStringLiteral("Mirrored.")));
    QTRY_VERIFY(text("drawnOwnSlit").contains(QStringLiteral("opens")));
    key(Qt::Key_Escape);
    QTRY_VERIFY(!page->isVisible());
    release(m_cursor);
    QCOMPARE(count(), std::size_t(1));
}

void TestDrawing::aHole()
{
    drawFirst();
    click(middle());
    QTRY_COMPARE(interaction().selection().size(), std::size_t(1));
    const double whole = first().shape->area();
    key(Qt::Key_O);
    QTRY_VERIFY(interaction().tool());
    const auto *action = m_window->findChild<QAction *>(QStringLiteral("section.addHole"));
    QTRY_VERIFY(action->isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    box(middle() + QPoint(-40, -30), middle() + QPoint(40, 30));
    QTRY_COMPARE(first().shape->holes().size(), std::size_t(1));
    QVERIFY(first().shape->area() < whole);
    QVERIFY(!interaction().tool());
    QTRY_VERIFY(!action->isChecked());
    QCOMPARE(session().history()->undoText(), QStringLiteral("Draw a hole in Section 1"));
}

void TestDrawing::aHoleBesideIsRefused()
{
    drawFirst();
    click(middle());
    key(Qt::Key_O);
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    box(middle() + QPoint(-60, 180), middle() + QPoint(60, 240));
    QTRY_COMPARE(interaction().hint().words.text, hints::kHoleOutside);
    QVERIFY(interaction().hint().isRefusal);
    QVERIFY(first().shape->holes().empty());
    QVERIFY(interaction().tool()); // once more
}

void TestDrawing::aNewContour()
{
    drawFirst();
    click(middle());
    const SectionId id = first().id;
    key(Qt::Key_R);
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    box(middle() + QPoint(-100, -80), middle() + QPoint(100, 80));
    QTRY_COMPARE(session().history()->undoText(), QStringLiteral("Redraw Section 1"));
    QCOMPARE(count(), std::size_t(1));
    QVERIFY(first().id == id);
    QVERIFY(first().shape->contour().segmentCount() <= 5);
}

void TestDrawing::theGroundCutsFlat()
{
    const QPoint ground = onScreen(Vec3::Zero());
    box(ground + QPoint(-80, -150), ground + QPoint(80, 30));
    QTRY_COMPARE(count(), std::size_t(1));
    QCOMPARE(interaction().hint().words.text, hints::kCutAtGround);
    const Box3 bounds = worldBounds(*first().shape, first().frame);
    QVERIFY(std::abs(bounds.min.y()) < 1e-9);
    key(Qt::Key_G); // off
    QTRY_VERIFY(!settings().isOn(DrawingSwitch::Ground));
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(count(), std::size_t(0));
    box(ground + QPoint(-80, -150), ground + QPoint(80, 30));
    QTRY_COMPARE(count(), std::size_t(1));
    QVERIFY(worldBounds(*first().shape, first().frame).min.y() < -1.0);
}

void TestDrawing::undoByKeyAndByHistory()
{
    drawFirst();
    drawSecond();
    const SectionPointer second = session().committed().section(1);
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(count(), std::size_t(1));
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(count(), std::size_t(2));
    QVERIFY(session().committed().section(1) == second); // the very object
    auto *list = m_window->findChild<QUndoView *>(QStringLiteral("historyList"));
    QVERIFY(list);
    list->setCurrentIndex(list->model()->index(0, 0)); // back to the beginning
    QTRY_COMPARE(count(), std::size_t(0));
    list->setCurrentIndex(list->model()->index(2, 0));
    QTRY_COMPARE(count(), std::size_t(2));
    QVERIFY(session().committed().section(1) == second);
}

void TestDrawing::aGroupByRubberBand()
{
    drawFirst();
    drawSecond();
    key(Qt::Key_1);
    QTRY_VERIFY_WITH_TIMEOUT(!interaction().isAnimating(), 5000);
    const QPoint from(20, 80), to(m_view->width() - 130, m_view->height() - 20);
    move(from);
    press(from, Qt::ShiftModifier);
    for (int i = 1; i <= 10; ++i)
        QTest::mouseEvent(QTest::MouseMove, m_window->windowHandle(), Qt::NoButton,
                          Qt::ShiftModifier,
                          m_view->mapTo(m_window.get(), from + (to - from) * i / 10), 5);
    release(to, Qt::ShiftModifier);
    QTRY_COMPARE(interaction().selection().size(), std::size_t(2));
    QVERIFY(!interaction().overlay().find<sign::Band>());
}

void TestDrawing::escapeLaysTheToolDown()
{
    drawFirst();
    click(middle());
    key(Qt::Key_R);
    QTRY_VERIFY(interaction().tool());
    key(Qt::Key_Escape);
    QTRY_VERIFY(!interaction().tool());
    QCOMPARE(interaction().selection().size(), std::size_t(1)); // one step back only
    QCOMPARE(steps(), 1);
}

void TestDrawing::aStepShowsWhatItTookAway()
{
    drawFirst();
    const SectionPointer gone = session().committed().section(0);
    click(middle());
    key(Qt::Key_Delete);
    QTRY_COMPARE(count(), std::size_t(0));
    auto *list = m_window->findChild<QUndoView *>(QStringLiteral("historyList"));
    Q_EMIT list->entered(list->model()->index(2, 0)); // as the cursor does
    QCOMPARE(bench().ghosts(), std::vector{gone});
    Q_EMIT list->viewportEntered();
    QVERIFY(bench().ghosts().empty());
}

/// What would be wrong: a window that never heard of the release goes on drawing with a mouse whose
/// buttons are up, and what was drawn is lost with the next press.
void TestDrawing::aLostButtonEndsTheStroke()
{
    drawOpenOval();
    const QPoint far = middle() + QPoint(-300, 200);
    QMouseEvent hover(QEvent::MouseMove, far, m_view->mapToGlobal(far), Qt::NoButton, Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(m_view, &hover);
    QTRY_COMPARE(count(), std::size_t(1));
    QVERIFY(!bench().interaction().hasGesture());
    // As it was, without the way to where the mouse is now.
    QVERIFY(first().shape->bounds().size().x() <
            310.0 * bench().interaction().camera().millimetresPerPixel);
    release(m_cursor);
    QCOMPARE(count(), std::size_t(1));
}

/// What would be wrong: behind a dialog the stroke waits for a release that the dialog gets.
void TestDrawing::aDialogEndsTheStroke()
{
    drawOpenOval();
    QDialog dialog(m_window.get());
    dialog.open();
    QTRY_COMPARE(count(), std::size_t(1));
    QVERIFY(!bench().interaction().hasGesture());
    dialog.close();
    release(m_cursor);
    QCOMPARE(count(), std::size_t(1));
}

/// What would be wrong: the view keeps its middle while one draws, so that the line jumps by half
/// of what the view grew.
void TestDrawing::theViewChangesItsSize()
{
    drawOpenOval();
    const auto last = [&] {
        const sign::Stroke &stroke = *bench().interaction().overlay().find<sign::Stroke>();
        return stroke.canvas.toWorld(stroke.samples.back());
    };
    const QSize before = m_view->size();
    const Vec3 there = last();
    m_window->resize(m_window->size() - QSize(160, 120));
    QTRY_COMPARE(m_view->size(), before - QSize(160, 120));
    QVERIFY(bench().interaction().overlay().find<sign::Stroke>());
    QVERIFY((onScreen(there) - m_cursor).manhattanLength() <= 1);
    move(m_cursor + QPoint(1, 0));
    const double pixel = bench().interaction().camera().millimetresPerPixel;
    QTRY_VERIFY((last() - there).norm() > 0.5 * pixel);
    QVERIFY((last() - there).norm() < 1.5 * pixel);
    release(m_cursor);
    QTRY_COMPARE(count(), std::size_t(1));
}

/// What would be wrong: it speaks of a new section while a hole is set point by point.
void TestDrawing::thePenTellsWhatItChanges()
{
    drawFirst();
    bench().select({session().committed().ref(0)});
    bench().run(QStringLiteral("section.pen"));
    bench().run(QStringLiteral("section.addHole"));
    QTRY_VERIFY(!bench().interaction().isAnimating());
    click(middle() + QPoint(-30, 20));
    click(middle() + QPoint(30, 20));
    const auto *page = m_window->findChild<DrawingPage *>();
    QTRY_VERIFY(page->isVisible());
    QTRY_COMPARE(text("drawnKind"), QStringLiteral("A hole, while you draw it"));
}

FFF_TEST_WITH(TestDrawing, runInWindowProgram<TestDrawing>)
#include "tst_drawing.moc"
