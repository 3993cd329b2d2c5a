// Where the view of the assembly is in its steps, and how it goes on: by the time that events
// carry.
#pragma once

namespace fff {

/// Time in steps as Playback counts it: 0 … stepCount. Clocks in ms.
class StepsPlayer
{
public:
    /// jumps  nothing moves on the screen (a person wants less motion): it goes from step to step
    explicit StepsPlayer(int stepCount = 0, bool jumps = false)
        : m_stepCount(stepCount), m_jumps(jumps)
    {
    }

    int stepCount() const { return m_stepCount; }
    double time() const { return m_time; }
    /// On to the end, of itself.
    bool isPlaying() const { return m_motion == Motion::Playing; }
    /// advance() has something to do.
    bool isMoving() const { return m_motion != Motion::None; }

    /// From where it is; from the beginning when it is at the end.
    void play(double now);
    void pause() { m_motion = Motion::None; }
    /// At once.
    void jumpTo(double time);
    /// To the end of the next step, or of the one before, counted from where a move under way goes.
    void next(double now);
    void previous(double now);
    void advance(double now);

    /// ms that a step takes when it is played, and when one goes there.
    static constexpr double kStepTime = 1500.0, kGoTime = 900.0;

private:
    enum class Motion { None, Playing, Going };
    void goTo(double goal, double now);

    int m_stepCount;
    bool m_jumps;
    Motion m_motion = Motion::None;
    double m_time = 0.0;
    double m_from = 0.0, m_goal = 0.0; // of the motion
    double m_start = 0.0;              // of it, ms
};

} // namespace fff
