// Pens and fingers over the view of a real window. If one of these fails, somebody with a tablet
// cannot draw, or draws with the ball of the hand.
#include <QTest> // first: moc cannot read some of the standard library before it

#include <QApplication>

#include "core/model/point_edits.h"
#include "tests/test_program.h"
#include "tests/ui/view_hand.h"

#include <QPointingDevice>
#include <QTabletEvent>

using namespace fff;
using namespace fff::ui;

class TestPensAndFingers : public QObject, private ViewHand
{
    Q_OBJECT

private Q_SLOTS:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void aPenDraws();
    void theEraserTakesPointsAway();
    void aPenHovers();
    void aFingerDraws();
    void aTapSelects();
    void aFingerHeldStillAsksForTheMenu();
    void twoFingersMoveAndZoom();
    void twoFingersTurn();
    void theSecondFingerTakesTheStrokeBack();
    void aPalmBesideThePenDrawsNothing();

private:
    void pen(QEvent::Type type, const QPointF &at,
             QPointingDevice::PointerType kind = QPointingDevice::PointerType::Pen)
    {
        static const QPointingDevice tip(QStringLiteral("pen"), 1, QInputDevice::DeviceType::Stylus,
                                         QPointingDevice::PointerType::Pen,
                                         QInputDevice::Capability::Position, 1, 1);
        static const QPointingDevice end(
            QStringLiteral("eraser"), 2, QInputDevice::DeviceType::Stylus,
            QPointingDevice::PointerType::Eraser, QInputDevice::Capability::Position, 1, 1);
        const bool isDown = type == QEvent::TabletPress;
        m_isDown = isDown || (m_isDown && type != QEvent::TabletRelease);
        QTabletEvent event(type, kind == QPointingDevice::PointerType::Pen ? &tip : &end, at,
                           m_view->mapToGlobal(at), 0.5, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                           Qt::NoModifier,
                           type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           m_isDown ? Qt::LeftButton : Qt::NoButton);
        event.setTimestamp(m_time += 8);
        QCoreApplication::sendEvent(m_view, &event);
        QCoreApplication::processEvents();
    }
    static QPointingDevice *device()
    {
        static QPointingDevice *screen = QTest::createTouchDevice();
        return screen;
    }
    /// Fingers at these places, one after the other of the same number.
    void touch(const std::vector<std::vector<QPoint>> &frames)
    {
        auto *device = this->device();
        std::size_t down = m_last.size();
        for (const std::vector<QPoint> &fingers : frames) {
            auto sequence = QTest::touchEvent(m_window->windowHandle(), device, false);
            for (std::size_t i = 0; i < fingers.size(); ++i) {
                const QPoint at = m_view->mapTo(m_window.get(), fingers[i]);
                if (i < down)
                    sequence.move(static_cast<int>(i), at);
                else
                    sequence.press(static_cast<int>(i), at);
            }
            sequence.commit();
            down = fingers.size();
            m_last = fingers;
            QTest::qWait(5);
        }
    }
    void lift()
    {
        auto *device = this->device();
        auto sequence = QTest::touchEvent(m_window->windowHandle(), device, false);
        for (std::size_t i = 0; i < m_last.size(); ++i)
            sequence.release(static_cast<int>(i), m_view->mapTo(m_window.get(), m_last[i]));
        sequence.commit();
        m_last.clear();
        QTest::qWait(5);
    }
    std::vector<QPoint> oval() const
    {
        std::vector<QPoint> points;
        for (int i = 0; i <= 40; ++i) {
            const double angle = 2.0 * M_PI * i / 40.0;
            points.push_back(middle() +
                             QPoint(int(150 * std::cos(angle)), int(-90 * std::sin(angle))));
        }
        return points;
    }

    bool m_isDown = false;
    quint64 m_time = 1000;
    std::vector<QPoint> m_last;
};

void TestPensAndFingers::aPenDraws()
{
    const std::vector<QPoint> line = oval();
    pen(QEvent::TabletMove, line.front());
    pen(QEvent::TabletPress, line.front());
    for (const QPoint &p : line)
        pen(QEvent::TabletMove, p);
    pen(QEvent::TabletRelease, line.back());
    QCOMPARE(count(), std::size_t(1));
}

// Wrong: the other end of the pen would draw.
void TestPensAndFingers::theEraserTakesPointsAway()
{
    drawFirst();
    bench().select({first().ref()});
    const int before = first().shape->contour().segmentCount();
    QVERIFY(before > 3);
    const QPoint at = onScreen(first().frame.toWorld(first().shape->contour().points()[3]));
    const auto eraser = QPointingDevice::PointerType::Eraser;
    pen(QEvent::TabletMove, at, eraser);
    QCOMPARE(first().shape->contour().segmentCount(), before);
    pen(QEvent::TabletPress, at, eraser);
    pen(QEvent::TabletRelease, at, eraser);
    QCOMPARE(first().shape->contour().segmentCount(), before - 1);
    QCOMPARE(count(), std::size_t(1));
}

void TestPensAndFingers::aPenHovers()
{
    drawFirst();
    pen(QEvent::TabletMove, onScreen(first().frame.toWorld(first().shape->centroid())));
    QTRY_COMPARE(interaction().hovered().section, 0);
}

void TestPensAndFingers::aFingerDraws()
{
    std::vector<std::vector<QPoint>> frames;
    for (const QPoint &p : oval())
        frames.push_back({p});
    touch(frames);
    lift();
    QCOMPARE(count(), std::size_t(1));
    QCOMPARE(steps(), 1);
}

void TestPensAndFingers::aTapSelects()
{
    drawFirst();
    bench().select({});
    touch({{onScreen(first().frame.toWorld(first().shape->centroid()))}});
    lift();
    QCOMPARE(interaction().selection().size(), std::size_t(1));
}

void TestPensAndFingers::aFingerHeldStillAsksForTheMenu()
{
    drawFirst();
    bool isAsked = false;
    connect(m_view, &Viewport::menuWanted, this, [&isAsked] { isAsked = true; });
    // A menu takes over until it is closed.
    QTimer closing;
    connect(&closing, &QTimer::timeout, this, [] {
        if (QWidget *menu = QApplication::activePopupWidget())
            menu->close();
    });
    closing.start(50);
    touch({{onScreen(first().frame.toWorld(first().shape->centroid()))}});
    QTRY_VERIFY(isAsked);
    lift();
    QCOMPARE(count(), std::size_t(1));
}

void TestPensAndFingers::twoFingersMoveAndZoom()
{
    drawFirst();
    const Camera before = interaction().camera();
    const QPoint a = middle() + QPoint(-60, 0), b = middle() + QPoint(60, 0);
    touch({{a, b},
           {a + QPoint(-30, 20), b + QPoint(30, 20)},
           {a + QPoint(-60, 40), b + QPoint(60, 40)}});
    lift();
    const Camera after = interaction().camera();
    QVERIFY(std::abs(before.millimetresPerPixel / after.millimetresPerPixel - 2.0) < 0.05);
    QVERIFY(after.target.y() > before.target.y()); // what is seen went down with the fingers
    QCOMPARE(count(), std::size_t(1));
    QVERIFY(after.orientation.isApprox(before.orientation));
}

void TestPensAndFingers::twoFingersTurn()
{
    drawFirst();
    const Camera before = interaction().camera();
    const QPoint m = middle();
    touch({{m + QPoint(-80, 0), m + QPoint(80, 0)},
           {m + QPoint(-57, -57), m + QPoint(57, 57)},
           {m + QPoint(0, -80), m + QPoint(0, 80)}});
    lift();
    const double turned = interaction().camera().orientation.angularDistance(before.orientation);
    QVERIFY(std::abs(turned - 0.5 * M_PI) < 0.1);
}

// Wrong: everybody who zooms with two fingers would draw a line first.
void TestPensAndFingers::theSecondFingerTakesTheStrokeBack()
{
    const QPoint m = middle();
    touch({{m}, {m + QPoint(15, 0)}, {m + QPoint(20, 0)}});
    touch({{m + QPoint(20, 0)}, {m + QPoint(20, 0), m + QPoint(120, 0)}});
    touch({{m + QPoint(20, 0), m + QPoint(120, 0)}, {m, m + QPoint(140, 0)}});
    lift();
    QCOMPARE(count(), std::size_t(0));
    QCOMPARE(steps(), 0);
    QVERIFY(!interaction().hasGesture());
}

void TestPensAndFingers::aPalmBesideThePenDrawsNothing()
{
    const QPoint m = middle();
    // Touches have the clock of the window system.
    QElapsedTimer clock;
    clock.start();
    m_time = static_cast<quint64>(clock.msecsSinceReference());
    pen(QEvent::TabletMove, m);
    pen(QEvent::TabletPress, m);
    std::vector<std::vector<QPoint>> frames;
    for (const QPoint &p : oval())
        frames.push_back({p + QPoint(0, 120)});
    touch(frames);
    lift();
    pen(QEvent::TabletRelease, m);
    QCOMPARE(count(), std::size_t(0));
}

FFF_TEST_WITH(TestPensAndFingers, fff::testing::runWithin<TestPensAndFingers, QApplication>)
#include "tst_pens_and_fingers.moc"
