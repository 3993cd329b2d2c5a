#include "ui/view/frame_pace.h"

namespace fff::ui {

namespace {

/// A better picture costs at most so many times as much: a frame that is faster by more leaves
/// room.
constexpr double kBetter = 6.0;

} // namespace

FrameQuality FramePace::begin(double now, bool moves)
{
    m_begun = now;
    m_isMoving = moves;
    if (moves) {
        m_moved = now;
        m_shown = m_moving;
    } else if (now >= m_moved + kRest) {
        m_shown = FrameQuality::Full;
    }
    return m_shown;
}

void FramePace::end(double now)
{
    const double took = now - m_begun;
    if (m_isMoving) {
        if (took > kSlowFrame)
            m_moving = m_moving == FrameQuality::Full ? FrameQuality::Plain : FrameQuality::Coarse;
        else if (took * kBetter < kSlowFrame && m_moving != FrameQuality::Full)
            m_moving = m_moving == FrameQuality::Coarse ? FrameQuality::Plain : FrameQuality::Full;
    } else if (m_shown == FrameQuality::Full && m_moving == FrameQuality::Full &&
               took > kSlowFrame) {
        m_moving = FrameQuality::Plain; // known before anything moves
    }
}

std::optional<double> FramePace::restTime() const
{
    if (m_shown == FrameQuality::Full)
        return {};
    return m_moved + kRest;
}

} // namespace fff::ui
