// What fingers do over the view:
//
//     one finger    as the mouse: a tap is a click, a drag a drag; held still, it asks for the menu
//     two fingers   move, zoom and turn the view, all at once
//
// A press is held back until it is clear what the finger wants, so that a second finger never finds
// half a stroke. What was begun by mistake when it comes is taken back. While a pen is near,
// fingers are the hand that holds it, and are passed over.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/interaction/pointer_event.h"

#include <QTimer>
#include <QTouchEvent>

#include <optional>

namespace fff::ui {

class Workbench;

class TouchInput : public QObject
{
    Q_OBJECT
public:
    /// The workbench outlives it.
    TouchInput(Workbench &bench, QObject *parent);

    void handle(QTouchEvent *event);
    /// A pen does something at this time, ms.
    void penIsNear(quint64 time) { m_penTime = time; }

Q_SIGNALS:
    void menuWanted(const QPoint &inView);

private:
    enum class State {
        None,
        Waiting,  // one finger, of which nothing is known yet
        Dragging, // one finger that is the mouse
        Two,
        Over // nothing more until all are lifted
    };
    /// Where two fingers are: the middle between them, how far apart, in which direction.
    struct Pair
    {
        Vec2 middle = Vec2::Zero();
        double distance = 0.0, angle = 0.0;
    };

    void begin(const QTouchEvent &event);
    void one(const QTouchEvent &event);
    void beginTwo(const QTouchEvent &event);
    void two(const QTouchEvent &event);
    void end(const QTouchEvent &event);
    void send(PointerEvent::Type type, const QPointF &place, quint64 time);
    static Pair pairOf(const QTouchEvent &event);

    Workbench &m_bench;
    State m_state = State::None;
    QPointF m_press;         // where the first finger came down
    quint64 m_pressTime = 0; // ms
    Pair m_pair;
    std::optional<quint64> m_penTime;
    QTimer m_hold; // until the menu is asked for
};

} // namespace fff::ui
