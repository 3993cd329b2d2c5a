// How well the next frame is drawn, from how long the last ones took: while the picture moves on a
// slow machine less of it, once it rests all of it. Knows no clock: times in ms come with each
// call.
#pragma once

#include "ui/view/frame_quality.h"

#include <optional>

namespace fff::ui {

class FramePace
{
public:
    /// The quality of a frame that is begun. `moves`: the picture differs from the last one, by
    /// more than its outlines.
    FrameQuality begin(double now, bool moves);
    /// The frame is drawn.
    void end(double now);
    /// When the picture that is shown is to be drawn in full. None: it is.
    std::optional<double> restTime() const;

    static constexpr double kSlowFrame = 30.0; // ms
    static constexpr double kRest = 150.0;     // ms without movement

private:
    FrameQuality m_moving = FrameQuality::Full; // of the next frame that moves
    FrameQuality m_shown = FrameQuality::Full;
    double m_begun = 0.0, m_moved = 0.0; // ms
    bool m_isMoving = false;
};

} // namespace fff::ui
