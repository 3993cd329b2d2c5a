// What mouse, trackpad and keyboard do over the view, as events of the interaction: gathers bursts
// of moves, knows which keys are held, and whose a key is (the tool's, a number's, an arrow).
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/interaction/pointer_event.h"

#include <QNativeGestureEvent>
#include <QSinglePointEvent>
#include <QTimer>

#include <optional>
#include <vector>

class QKeyEvent;
class QTabletEvent;
class QWheelEvent;

namespace fff::ui {

class Workbench;

class ViewInput : public QObject
{
    Q_OBJECT
public:
    /// The workbench outlives it.
    ViewInput(Workbench &bench, QObject *parent);

    void press(QSinglePointEvent *event);
    void move(QSinglePointEvent *event);
    void release(QSinglePointEvent *event);
#if QT_CONFIG(tabletevent)
    /// A pen draws as the mouse does; its other end takes control points away. (Where Qt knows no
    /// pens, they are mice.)
    void tablet(QTabletEvent *event);
#endif
    void wheel(QWheelEvent *event);
    /// Two fingers apart or together zoom, two fingers sideways push the picture. False for other
    /// gestures.
    bool pinch(QNativeGestureEvent *event);
    /// The cursor is over the view no more.
    void leave();
    /// Other buttons than these are let go where they were seen last: the system took them away
    /// without a release, for a dialog that blocks the window or another program's sake.
    void letGo(Qt::MouseButtons stillHeld = Qt::NoButton);
    /// The keys go elsewhere: none is held any more.
    void forgetKeys() { m_isSpaceHeld = false; }

    /// False for a key that nobody here has a use for.
    bool keyPress(QKeyEvent *event);
    bool keyRelease(QKeyEvent *event);
    /// The key is the tool's before it is that of a shortcut.
    bool isBeforeShortcuts(const QKeyEvent *event) const;

    /// Hands over the moves that have been gathered: before anything else happens.
    void flush();

Q_SIGNALS:
    /// This was typed, and begins a number for the tool in the hand.
    void numberBegun(const QString &text);
    /// Enter, and the tool has no use for it.
    void enterPressed();
    /// The right button was pressed and released in one place.
    void menuWanted(const QPoint &inView);

private:
    PointerEvent pointer(PointerEvent::Type type, QSinglePointEvent *event);
    PointerEvent pointer(PointerEvent::Type type, const QPointF &place, Qt::KeyboardModifiers keys,
                         quint64 time) const;
    bool takesNumber(const QKeyEvent *event) const;
    bool takesGuide(const QKeyEvent *event) const;
    bool tellOfModifiers(QKeyEvent *event);
    bool nudge(QKeyEvent *event);
    bool changeMass(QKeyEvent *event);
    void erase(QTabletEvent *event);

    Workbench &m_bench;
    bool m_isSpaceHeld = false;
    Qt::MouseButtons m_held = Qt::NoButton;
    Qt::KeyboardModifiers m_keys;       // of the last event that had a place
    Vec2 m_cursor = Vec2::Zero();       // px, of that event
    std::optional<QPointF> m_menuPress; // of the right button, as long as it stays there
    std::vector<PointerEvent> m_moves;  // of the burst that is coming in
    QTimer m_burst;                     // ends when nothing more is at hand
};

} // namespace fff::ui
