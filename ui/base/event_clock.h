// The clock that events carry, carried on between them: what animates by it replays exactly.
#pragma once

#include <QElapsedTimer>

#include <algorithm>

namespace fff::ui {

class EventClock
{
public:
    EventClock() { m_since.start(); }

    /// An event came with this time stamp. Never backwards: now() may have gone past it.
    double observe(quint64 timestamp)
    {
        m_last = std::max(static_cast<double>(timestamp), m_shown);
        m_since.restart();
        return m_shown = m_last;
    }

    /// ms
    double now()
    {
        return m_shown = std::max(m_shown, m_last + static_cast<double>(m_since.elapsed()));
    }

private:
    double m_last = 0.0;  // of the newest event
    double m_shown = 0.0; // newest time that anyone was told
    QElapsedTimer m_since;
};

} // namespace fff::ui
