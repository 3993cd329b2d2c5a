// Plays a replay script in the window as if a person did it, at the script's pace: for demos, and
// for tests of the program as a whole. core/session/replay.h has the format.
#pragma once

#include <QObject> // first: moc fails on standard headers that it meets before one of Qt's

#include "core/base/result.h"
#include "core/session/replay_script.h"

#include <QPointF>
#include <QTimer>

class QWidget;

namespace fff::ui {

class Workbench;

/// Positions are scaled about the middle to the size that `view` has. "space" among modifiers is
/// left out: it is a key of its own in a window.
class ScriptPlayer : public QObject
{
    Q_OBJECT
public:
    ScriptPlayer(Workbench &bench, QWidget &view, ReplayScript script, QObject *parent = nullptr);

    void start();

Q_SIGNALS:
    void finished();
    /// An event makes no sense; those before it have happened.
    void failed(const fff::Error &error);

private:
    void advance();
    Result<void> play(const ReplayEvent &event);
    void sendMouse(const ReplayEvent &event);
    void sendWheel(const ReplayEvent &event);
    Result<void> run(const std::string &command, const QString &what,
                     const CommandParameters &parameters = {});
    QPointF inView(const Vec2 &position) const;

    Workbench &m_bench;
    QWidget &m_view;
    ReplayScript m_script;
    QTimer m_timer;
    int m_next = 0;
    double m_time = 0.0; // ms of the script
    Qt::MouseButton m_pressed = Qt::NoButton;
};

} // namespace fff::ui
