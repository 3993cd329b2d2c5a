#include "core/interaction/hand_in_turn.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// One step longer than this after a pause is what a busy machine left of a fast move, no rest; px.
constexpr double kFirstStep = 24.0;

/// How far a way strays from the line through its start and its farthest point, px.
double strayed(const std::vector<HandInTurn::Sample> &way)
{
    const Vec2 &start = way.front().place;
    const auto isNearer = [&](const HandInTurn::Sample &a, const HandInTurn::Sample &b) {
        return (a.place - start).squaredNorm() < (b.place - start).squaredNorm();
    };
    const Vec2 line = std::max_element(way.begin(), way.end(), isNearer)->place - start;
    const double length = line.norm();
    if (length <= 0.0)
        return 0.0;
    double most = 0.0;
    for (const HandInTurn::Sample &sample : way)
        most = std::max(most, std::abs(cross(line, sample.place - start)) / length);
    return most;
}

} // namespace

HandInTurn::HandInTurn(const Sample &leaving, double slip)
    : m_slip(slip), m_way{leaving}, m_still(leaving)
{
}

void HandInTurn::follow(const Sample &sample)
{
    const Vec2 before = m_way.back().place;
    const double step = (sample.place - before).norm();
    if (sample.time - m_still.time >= kRest && step <= kFirstStep) {
        m_way = {{sample.time, before}};
        m_length = 0.0;
        m_still = m_way.front();
    }
    if ((sample.place - m_still.place).norm() > kStill)
        m_still = sample;
    m_way.push_back(sample);
    m_length += step;
}

bool HandInTurn::isFast(double time, double haste) const
{
    return m_length >= haste * (time - m_way.front().time);
}

bool HandInTurn::isDrawing() const
{
    const double time = m_way.back().time;
    if (isFast(time, kHasteInBend) && strayed(m_way) > m_slip)
        return true;
    return isFast(time, kHaste) &&
           (m_way.back().place - m_way.front().place).norm() > kFar * m_slip;
}

bool HandInTurn::isUnderWay(double time) const
{
    return isFast(time, kHaste) && time - m_still.time < kRest &&
           (m_way.back().place - m_way.front().place).norm() > m_slip;
}

} // namespace fff
