#include "core/interaction/steps_player.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kRounding = 1e-9; // of a step

} // namespace

void StepsPlayer::play(double now)
{
    if (m_time >= m_stepCount - kRounding)
        m_time = 0.0;
    m_motion = m_stepCount > 0 ? Motion::Playing : Motion::None;
    m_from = m_time;
    m_start = now;
    advance(now);
}

void StepsPlayer::jumpTo(double time)
{
    m_motion = Motion::None;
    m_time = std::clamp(time, 0.0, double(m_stepCount));
}

void StepsPlayer::next(double now)
{
    goTo(std::floor((m_motion == Motion::Going ? m_goal : m_time) + kRounding) + 1.0, now);
}

void StepsPlayer::previous(double now)
{
    goTo(std::ceil((m_motion == Motion::Going ? m_goal : m_time) - kRounding) - 1.0, now);
}

void StepsPlayer::goTo(double goal, double now)
{
    goal = std::clamp(goal, 0.0, double(m_stepCount));
    if (m_jumps || goal == m_time) {
        jumpTo(goal);
        return;
    }
    m_motion = Motion::Going;
    m_from = m_time;
    m_goal = goal;
    m_start = now;
}

void StepsPlayer::advance(double now)
{
    const double since = std::max(0.0, now - m_start);
    if (m_motion == Motion::Playing) {
        const double steps = since / kStepTime;
        const double time =
            m_jumps ? std::floor(m_from + kRounding) + 1.0 + std::floor(steps) : m_from + steps;
        m_time = std::min(time, double(m_stepCount));
        if (m_time >= m_stepCount)
            m_motion = Motion::None;
    } else if (m_motion == Motion::Going) {
        const double share = std::min(1.0, since / kGoTime);
        m_time = share < 1.0 ? m_from + share * (m_goal - m_from) : m_goal;
        if (share >= 1.0)
            m_motion = Motion::None;
    }
}

} // namespace fff
