#include "ui/bench/view_input.h"

#include "core/interaction/tool.h"
#include "ui/bench/workbench.h"

#include <QKeyEvent>
#include <QLineF>
#include <QTabletEvent>
#include <QWheelEvent>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr double kNotchAngle = 120.0; // of QWheelEvent, one notch

Vec2 toVec(const QPointF &p)
{
    return {p.x(), p.y()};
}

Button toButton(Qt::MouseButton button)
{
    switch (button) {
    case Qt::LeftButton:
        return Button::Left;
    case Qt::MiddleButton:
        return Button::Middle;
    case Qt::RightButton:
        return Button::Right;
    default:
        return Button::None;
    }
}

Pointer toPointer(const QPointerEvent *event)
{
    if (event->device()->type() == QInputDevice::DeviceType::TouchScreen)
        return Pointer::Finger;
    const QPointingDevice::PointerType type = event->pointingDevice()->pointerType();
    if (type == QPointingDevice::PointerType::Finger &&
        event->device()->type() != QInputDevice::DeviceType::TouchPad)
        return Pointer::Finger;
    return type == QPointingDevice::PointerType::Pen ? Pointer::Pen : Pointer::Mouse;
}

std::optional<ToolKey> toolKey(const QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return ToolKey::Enter;
    case Qt::Key_Backspace:
        return ToolKey::Backspace;
    default:
        return std::nullopt;
    }
}

/// What a number can begin with, where the tool in the hand takes some.
bool beginsNumber(const QKeyEvent *event)
{
    const auto others = event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (others != Qt::NoModifier || event->text().size() != 1)
        return false;
    const QChar c = event->text().front();
    return c.isDigit() || QStringLiteral("-\u2212.,@").contains(c);
}

} // namespace

ViewInput::ViewInput(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    m_burst.setSingleShot(true);
    m_burst.setInterval(0);
    connect(&m_burst, &QTimer::timeout, this, &ViewInput::flush);
}

void ViewInput::press(QSinglePointEvent *event)
{
    flush();
    m_held |= event->button();
    m_menuPress.reset();
    if (event->button() == Qt::RightButton && m_held == Qt::RightButton &&
        event->modifiers() == Qt::NoModifier)
        m_menuPress = event->position();
    m_bench.handle(pointer(PointerEvent::Type::Press, event));
}

/// A hand's line needs every sample, but what they make needs showing once a frame only: moves are
/// gathered for as long as more of them are at hand.
void ViewInput::move(QSinglePointEvent *event)
{
    letGo(event->buttons());
    const double threshold = m_bench.interaction().settings().dragThreshold;
    if (m_menuPress && QLineF(*m_menuPress, event->position()).length() > threshold)
        m_menuPress.reset();
    m_moves.push_back(pointer(PointerEvent::Type::Move, event));
    if (!m_burst.isActive())
        m_burst.start();
}

void ViewInput::flush()
{
    m_burst.stop();
    std::vector<PointerEvent> moves = std::exchange(m_moves, {});
    for (std::size_t i = 0; i < moves.size(); ++i) {
        moves[i].isFollowed = i + 1 < moves.size();
        m_bench.handle(moves[i]);
    }
}

void ViewInput::release(QSinglePointEvent *event)
{
    m_held &= ~Qt::MouseButtons(event->button());
    flush();
    m_bench.handle(pointer(PointerEvent::Type::Release, event));
    if (event->button() == Qt::RightButton && std::exchange(m_menuPress, std::nullopt))
        Q_EMIT menuWanted(event->position().toPoint());
}

#if QT_CONFIG(tabletevent)
void ViewInput::tablet(QTabletEvent *event)
{
    event->accept();
    if (event->pointerType() == QPointingDevice::PointerType::Eraser)
        erase(event);
    else if (event->type() == QEvent::TabletPress)
        press(event);
    else if (event->type() == QEvent::TabletRelease)
        release(event);
    else
        move(event);
}

/// Every control point that it comes over while it is pressed.
void ViewInput::erase(QTabletEvent *event)
{
    flush();
    PointerEvent moved = pointer(PointerEvent::Type::Move, event);
    moved.pointer = Pointer::Pen;
    m_bench.handle(moved);
    if (event->buttons() != Qt::NoButton)
        m_bench.eraseHoveredPoint();
}
#endif

void ViewInput::letGo(Qt::MouseButtons stillHeld)
{
    const Qt::MouseButtons lost = std::exchange(m_held, m_held & stillHeld) & ~stillHeld;
    if (lost == Qt::NoButton)
        return;
    flush();
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton}) {
        if (!lost.testFlag(button))
            continue;
        PointerEvent release =
            pointer(PointerEvent::Type::Release, QPointF(m_cursor.x(), m_cursor.y()), m_keys,
                    static_cast<quint64>(m_bench.clock().now()));
        release.button = toButton(button);
        m_bench.handle(release);
    }
}

PointerEvent ViewInput::pointer(PointerEvent::Type type, const QPointF &place,
                                Qt::KeyboardModifiers keys, quint64 time) const
{
    PointerEvent pointer;
    pointer.type = type;
    pointer.position = toVec(place);
    pointer.modifiers = {keys.testFlag(Qt::ShiftModifier), keys.testFlag(Qt::ControlModifier),
                         m_isSpaceHeld};
    pointer.time = m_bench.clock().observe(time);
    return pointer;
}

PointerEvent ViewInput::pointer(PointerEvent::Type type, QSinglePointEvent *event)
{
    m_cursor = toVec(event->position());
    m_keys = event->modifiers();
    PointerEvent pointer =
        this->pointer(type, event->position(), event->modifiers(), event->timestamp());
    pointer.button = toButton(event->button());
    pointer.pointer = toPointer(event);
    event->accept();
    return pointer;
}

void ViewInput::wheel(QWheelEvent *event)
{
    flush();
    event->accept();
    // Two fingers on a trackpad push the picture; a wheel, and fingers with Ctrl, zoom.
    const bool isTrackpad = event->device()->type() == QInputDevice::DeviceType::TouchPad ||
                            event->phase() != Qt::NoScrollPhase;
    const bool pushes = isTrackpad && !event->modifiers().testFlag(Qt::ControlModifier);
    PointerEvent moved = pointer(pushes ? PointerEvent::Type::Scroll : PointerEvent::Type::Wheel,
                                 event->position(), event->modifiers(), event->timestamp());
    if (pushes) {
        const QPoint way =
            event->pixelDelta().isNull() ? event->angleDelta() / 2 : event->pixelDelta();
        moved.scroll = Vec2(way.x(), way.y());
        if (!way.isNull())
            m_bench.handle(moved);
        return;
    }
    moved.wheelSteps = event->angleDelta().y() / kNotchAngle;
    if (moved.wheelSteps != 0.0)
        m_bench.handle(moved);
}

/// Two fingers apart or together zoom, two fingers sideways push the picture.
bool ViewInput::pinch(QNativeGestureEvent *event)
{
    const bool zooms = event->gestureType() == Qt::ZoomNativeGesture;
    if (!zooms && event->gestureType() != Qt::PanNativeGesture)
        return false;
    flush();
    PointerEvent moved = pointer(zooms ? PointerEvent::Type::Zoom : PointerEvent::Type::Scroll,
                                 event->position(), event->modifiers(), event->timestamp());
    moved.zoomFactor = std::max(0.1, 1.0 + event->value());
    moved.scroll = toVec(event->delta());
    m_bench.handle(moved);
    event->accept();
    return true;
}

bool ViewInput::takesNumber(const QKeyEvent *event) const
{
    return beginsNumber(event) && !m_bench.interaction().numbers().empty();
}

bool ViewInput::isBeforeShortcuts(const QKeyEvent *event) const
{
    const std::optional<ToolKey> key = toolKey(event);
    return (key && m_bench.wants(*key)) || takesNumber(event) || takesGuide(event);
}

/// While a stroke goes: actions, which are enabled when it is over, do not hear of it.
bool ViewInput::takesGuide(const QKeyEvent *event) const
{
    return toolKey(event) == ToolKey::Enter &&
           (event->modifiers() & ~Qt::KeypadModifier) == Qt::ShiftModifier &&
           m_bench.interaction().hasGuide();
}

bool ViewInput::keyPress(QKeyEvent *event)
{
    flush();
    if (event->key() == Qt::Key_Space) {
        m_isSpaceHeld = true;
        return true;
    }
    if (event->key() == Qt::Key_Escape) {
        m_bench.clock().observe(event->timestamp());
        m_bench.escape();
        return true;
    }
    if (const std::optional<ToolKey> key = toolKey(event); key && m_bench.wants(*key)) {
        m_bench.clock().observe(event->timestamp());
        m_bench.key(*key);
        return true;
    }
    if (takesGuide(event)) {
        m_bench.run(QStringLiteral("section.takeGuide"));
        return true;
    }
    if (takesNumber(event)) {
        Q_EMIT numberBegun(event->text());
        return true;
    }
    if (toolKey(event) == ToolKey::Enter && event->modifiers() == Qt::NoModifier) {
        Q_EMIT enterPressed();
        return true;
    }
    return nudge(event) || changeMass(event) || tellOfModifiers(event);
}

/// Arrow keys move what is selected by 1 mm, finely with Ctrl, coarsely with Shift.
bool ViewInput::nudge(QKeyEvent *event)
{
    Vec2 arrow = Vec2::Zero();
    switch (event->key()) {
    case Qt::Key_Left:
        arrow = -Vec2::UnitX();
        break;
    case Qt::Key_Right:
        arrow = Vec2::UnitX();
        break;
    case Qt::Key_Up:
        arrow = Vec2::UnitY();
        break;
    case Qt::Key_Down:
        arrow = -Vec2::UnitY();
        break;
    default:
        return false;
    }
    const Qt::KeyboardModifiers keys = event->modifiers() & ~Qt::KeypadModifier;
    const double distance = keys == Qt::ControlModifier ? 0.1
                            : keys == Qt::ShiftModifier ? 10.0
                                                        : 1.0;
    if (keys != Qt::NoModifier && distance == 1.0)
        return false; // Alt and the like are someone else's
    m_bench.clock().observe(event->timestamp());
    return m_bench.nudge(arrow, distance);
}

/// + and − make the selected weight heavier and lighter by 10 g; with sections they are for points.
bool ViewInput::changeMass(QKeyEvent *event)
{
    const bool isLighter = event->key() == Qt::Key_Minus;
    if ((!isLighter && event->key() != Qt::Key_Plus) ||
        !m_bench.interaction().selectedLoad().isValid())
        return false;
    m_bench.clock().observe(event->timestamp());
    m_bench.run(isLighter ? QStringLiteral("physics.lighter") : QStringLiteral("physics.heavier"));
    return true;
}

/// A gesture may do something else while Shift or Ctrl is held, also when the mouse rests.
bool ViewInput::tellOfModifiers(QKeyEvent *event)
{
    if ((event->key() != Qt::Key_Shift && event->key() != Qt::Key_Control) || event->isAutoRepeat())
        return false;
    PointerEvent told = pointer(PointerEvent::Type::Modifiers, QPointF(m_cursor.x(), m_cursor.y()),
                                event->modifiers(), event->timestamp());
    // Qt's modifiers of the key itself are those from before it on some platforms.
    (event->key() == Qt::Key_Shift ? told.modifiers.shift : told.modifiers.control) =
        event->type() == QEvent::KeyPress;
    m_bench.handle(told);
    return true;
}

bool ViewInput::keyRelease(QKeyEvent *event)
{
    flush();
    if (event->key() != Qt::Key_Space || event->isAutoRepeat())
        return tellOfModifiers(event);
    m_isSpaceHeld = false;
    return true;
}

void ViewInput::leave()
{
    flush();
    PointerEvent pointer;
    pointer.type = PointerEvent::Type::Leave;
    pointer.time = m_bench.clock().now();
    m_bench.handle(pointer);
}

} // namespace fff::ui
