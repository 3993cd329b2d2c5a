#include "ui/bench/touch_input.h"

#include "ui/bench/workbench.h"

#include <QGuiApplication>
#include <QLineF>
#include <QStyleHints>

#include <cmath>
#include <numbers>

namespace fff::ui {

namespace {

constexpr double kStill = 10.0;    // px that a finger moves without meaning it
constexpr double kMistake = 40.0;  // px: a drag so short was begun by the first of two fingers
constexpr quint64 kPenNear = 1000; // ms after its last event that a pen is near

Vec2 toVec(const QPointF &p)
{
    return {p.x(), p.y()};
}

int fingersDown(const QTouchEvent &event)
{
    int count = 0;
    for (const QEventPoint &point : event.points())
        count += point.state() != QEventPoint::Released ? 1 : 0;
    return count;
}

} // namespace

TouchInput::TouchInput(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    m_hold.setSingleShot(true);
    m_hold.setInterval(QGuiApplication::styleHints()->mousePressAndHoldInterval());
    connect(&m_hold, &QTimer::timeout, this, [this] {
        if (m_state != State::Waiting)
            return;
        m_state = State::Over;
        Q_EMIT menuWanted(m_press.toPoint());
    });
}

void TouchInput::send(PointerEvent::Type type, const QPointF &place, quint64 time)
{
    PointerEvent event;
    event.type = type;
    event.position = toVec(place);
    event.pointer = Pointer::Finger;
    if (type == PointerEvent::Type::Press || type == PointerEvent::Type::Release)
        event.button = Button::Left;
    event.time = m_bench.clock().observe(time);
    m_bench.handle(event);
}

void TouchInput::handle(QTouchEvent *event)
{
    event->accept();
    const bool isPenNear = m_penTime && event->timestamp() < *m_penTime + kPenNear;
    if (isPenNear && m_state == State::None)
        return;
    if (event->type() == QEvent::TouchCancel) {
        if (m_state == State::Dragging) {
            m_bench.escape();
            send(PointerEvent::Type::Release, m_press, event->timestamp());
        }
        m_hold.stop();
        m_state = State::None;
        return;
    }
    const int fingers = fingersDown(*event);
    if (fingers == 0) {
        end(*event);
        return;
    }
    if (m_state == State::None)
        begin(*event);
    else if (fingers >= 2 && (m_state == State::Waiting || m_state == State::Dragging))
        beginTwo(*event);
    else if (m_state == State::Two && fingers == 2)
        two(*event);
    else if (m_state == State::Two)
        m_state = State::Over; // the one that stays draws nothing
    else
        one(*event);
}

void TouchInput::begin(const QTouchEvent &event)
{
    if (fingersDown(event) >= 2) {
        m_state = State::Waiting;
        beginTwo(event);
        return;
    }
    m_press = event.points().front().position();
    m_pressTime = event.timestamp();
    m_state = State::Waiting;
    m_hold.start();
}

void TouchInput::one(const QTouchEvent &event)
{
    const QPointF at = event.points().front().position();
    if (m_state == State::Waiting && QLineF(m_press, at).length() > kStill) {
        m_hold.stop();
        m_state = State::Dragging;
        send(PointerEvent::Type::Move, m_press, m_pressTime);
        send(PointerEvent::Type::Press, m_press, m_pressTime);
    }
    if (m_state == State::Dragging)
        send(PointerEvent::Type::Move, at, event.timestamp());
}

TouchInput::Pair TouchInput::pairOf(const QTouchEvent &event)
{
    std::vector<Vec2> places;
    for (const QEventPoint &point : event.points())
        if (point.state() != QEventPoint::Released)
            places.push_back(toVec(point.position()));
    const Vec2 way = places[1] - places[0];
    return {0.5 * (places[0] + places[1]), way.norm(), std::atan2(way.y(), way.x())};
}

void TouchInput::beginTwo(const QTouchEvent &event)
{
    m_hold.stop();
    if (m_state == State::Dragging) {
        const QPointF at = event.points().front().position();
        const Overlay &overlay = m_bench.interaction().overlay();
        const bool isDrawing = overlay.find<sign::Slit>() || overlay.find<sign::Stroke>();
        if (isDrawing && QLineF(m_press, at).length() > kMistake)
            return; // a palm, or a thumb: the stroke goes on
        if (m_bench.interaction().hasGesture())
            m_bench.escape();
        send(PointerEvent::Type::Release, at, event.timestamp());
    }
    m_state = State::Two;
    m_pair = pairOf(event);
}

/// The picture stays under both fingers as far as a turntable can.
void TouchInput::two(const QTouchEvent &event)
{
    const Pair now = pairOf(event);
    const auto told = [&](PointerEvent::Type type) {
        PointerEvent moved;
        moved.type = type;
        moved.position = m_pair.middle;
        moved.pointer = Pointer::Finger;
        moved.time = m_bench.clock().observe(event.timestamp());
        return moved;
    };
    PointerEvent pushed = told(PointerEvent::Type::Scroll);
    pushed.scroll = now.middle - m_pair.middle;
    if (!pushed.scroll.isZero())
        m_bench.handle(pushed);
    PointerEvent zoomed = told(PointerEvent::Type::Zoom);
    zoomed.position = now.middle;
    zoomed.zoomFactor = m_pair.distance > 1.0 ? now.distance / m_pair.distance : 1.0;
    if (zoomed.zoomFactor > 0.0 && zoomed.zoomFactor != 1.0)
        m_bench.handle(zoomed);
    PointerEvent turned = told(PointerEvent::Type::Twist);
    turned.position = now.middle;
    turned.angle = std::remainder(now.angle - m_pair.angle, 2.0 * std::numbers::pi);
    if (turned.angle != 0.0)
        m_bench.handle(turned);
    m_pair = now;
}

void TouchInput::end(const QTouchEvent &event)
{
    m_hold.stop();
    const QPointF at = event.points().isEmpty() ? m_press : event.points().front().position();
    if (m_state == State::Waiting) { // a tap
        send(PointerEvent::Type::Move, m_press, m_pressTime);
        send(PointerEvent::Type::Press, m_press, m_pressTime);
        send(PointerEvent::Type::Release, m_press, event.timestamp());
    } else if (m_state == State::Dragging) {
        send(PointerEvent::Type::Move, at, event.timestamp());
        send(PointerEvent::Type::Release, at, event.timestamp());
    }
    // No finger hovers.
    PointerEvent left;
    left.type = PointerEvent::Type::Leave;
    left.time = m_bench.clock().now();
    m_bench.handle(left);
    m_state = State::None;
}

} // namespace fff::ui
