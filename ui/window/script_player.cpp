#include "ui/window/script_player.h"

#include "ui/bench/workbench.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr double kNotchAngle = 120.0; // of QWheelEvent, one notch

Qt::MouseButton toButton(Button button)
{
    switch (button) {
    case Button::Middle:
        return Qt::MiddleButton;
    case Button::Right:
        return Qt::RightButton;
    case Button::Left:
    case Button::None:
        break;
    }
    return Qt::LeftButton;
}

Qt::KeyboardModifiers toModifiers(const Modifiers &modifiers)
{
    Qt::KeyboardModifiers result;
    result.setFlag(Qt::ShiftModifier, modifiers.shift);
    result.setFlag(Qt::ControlModifier, modifiers.control);
    return result;
}

} // namespace

ScriptPlayer::ScriptPlayer(Workbench &bench, QWidget &view, ReplayScript script, QObject *parent)
    : QObject(parent), m_bench(bench), m_view(view), m_script(std::move(script))
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &ScriptPlayer::advance);
}

void ScriptPlayer::start()
{
    m_timer.start(0);
}

/// One event; the next when it is its time. Started after the event is over, which may take as long
/// as saving does.
void ScriptPlayer::advance()
{
    if (m_next == m_script.count()) {
        Q_EMIT finished();
        return;
    }
    const Result<ReplayEvent> event = m_script.event(m_next);
    const Result<void> played = event ? play(*event) : Result<void>(tl::unexpected(event.error()));
    if (!played) {
        Q_EMIT failed(played.error());
        return;
    }
    ++m_next;
    const double before = m_time;
    if (event->type == ReplayEvent::Type::Wait)
        m_time += event->amount;
    if (m_next < m_script.count()) {
        const Result<ReplayEvent> following = m_script.event(m_next);
        m_time = std::max(m_time,
                          following && following->time ? *following->time : m_time + kReplayStep);
    }
    m_timer.start(static_cast<int>(m_time - before));
}

Result<void> ScriptPlayer::play(const ReplayEvent &event)
{
    switch (event.type) {
    case ReplayEvent::Type::Press:
    case ReplayEvent::Type::Move:
    case ReplayEvent::Type::Release:
        sendMouse(event);
        return {};
    case ReplayEvent::Type::Wheel:
        sendWheel(event);
        return {};
    case ReplayEvent::Type::View:
        if (event.name == QLatin1String("fit"))
            return run("view.fitAll", event.name);
        m_bench.showAll(event.name.toStdString());
        return {};
    case ReplayEvent::Type::Wait:
        return {};
    case ReplayEvent::Type::Command:
        return run(event.name.toStdString(), event.name, event.parameters);
    case ReplayEvent::Type::Key:
        if (event.name == QLatin1String("Escape")) {
            m_bench.escape();
            return {};
        }
        if (const std::optional<ToolKey> key = toolKeyOf(event.name, event.modifiers)) {
            m_bench.key(*key);
            return {};
        }
        return run(commandOfKey(event.name, event.modifiers), event.name);
    }
    return {};
}

void ScriptPlayer::sendMouse(const ReplayEvent &event)
{
    QEvent::Type type = QEvent::MouseMove;
    Qt::MouseButton button = Qt::NoButton;
    if (event.type == ReplayEvent::Type::Press) {
        type = QEvent::MouseButtonPress;
        button = m_pressed = toButton(event.button.value_or(Button::Left));
    } else if (event.type == ReplayEvent::Type::Release) {
        type = QEvent::MouseButtonRelease;
        button = std::exchange(m_pressed, Qt::NoButton);
    }
    const QPointF position = inView(event.position);
    QMouseEvent mouse(type, position, m_view.mapToGlobal(position), button, m_pressed,
                      toModifiers(event.modifiers));
    mouse.setTimestamp(static_cast<quint64>(m_bench.clock().now()));
    QCoreApplication::sendEvent(&m_view, &mouse);
}

void ScriptPlayer::sendWheel(const ReplayEvent &event)
{
    const QPointF position = inView(event.position);
    QWheelEvent wheel(position, m_view.mapToGlobal(position), {},
                      {0, static_cast<int>(event.amount * kNotchAngle)}, m_pressed,
                      toModifiers(event.modifiers), Qt::NoScrollPhase, false);
    wheel.setTimestamp(static_cast<quint64>(m_bench.clock().now()));
    QCoreApplication::sendEvent(&m_view, &wheel);
}

/// As a menu runs it: a command that fails says so in the window.
Result<void> ScriptPlayer::run(const std::string &command, const QString &what,
                               const CommandParameters &parameters)
{
    if (!m_bench.commands().contains(command))
        return ReplayScript::wrong(m_next, what, QStringLiteral("a command"));
    m_bench.run(QString::fromStdString(command), parameters);
    return {};
}

QPointF ScriptPlayer::inView(const Vec2 &position) const
{
    const Vec2 size(m_view.width(), m_view.height());
    const double scale =
        std::min(size.x() / m_script.viewport().x(), size.y() / m_script.viewport().y());
    const Vec2 point = 0.5 * size + scale * (position - 0.5 * m_script.viewport());
    return {point.x(), point.y()};
}

} // namespace fff::ui
