#include "core/stroke/steady_hand.h"

#include <algorithm>

namespace fff {

namespace {

/// Sizes of a spot in tolerances, and the shortest ways there in sizes of the spot. A wider spot
/// counts where nothing smaller does, and wider still while the hand trembles: a line that goes
/// over between its mean and its samples would jump.
constexpr double kSpot = 4.0, kWay = 3.0;
constexpr double kWideSpot = 5.0, kWidestSpot = 8.0, kJitterWay = 1.3;
/// A step that goes back is one of at least this many tolerances; one in so many makes a tremble,
/// and in twice as many keeps it up.
constexpr double kStepBack = 0.25;
constexpr std::size_t kStepsBack = 3;

} // namespace

Vec2 SteadyHand::follow(const Vec2 &sample)
{
    m_recent[m_count++ % kMost] = sample;
    const bool trembled = m_window > 0;
    m_window = trembling();
    m_beginsAnew = !trembled && m_window > 0 && hasJustBegun();
    if (m_window == 0)
        return sample;
    Vec2 sum = Vec2::Zero();
    for (std::size_t k = 0; k < m_window; ++k)
        sum += back(k);
    return sum / static_cast<double>(m_window);
}

/// All samples lie on the spot where a tremble is looked for.
bool SteadyHand::hasJustBegun() const
{
    if (m_count > 2 * kFewest)
        return false;
    Box2 spot;
    for (std::size_t k = 0; k < m_count; ++k)
        spot.extend(back(k));
    return spot.size().norm() <= kWideSpot * m_tolerance;
}

/// Samples of the window; 0 for none.
std::size_t SteadyHand::trembling() const
{
    const std::size_t most = std::min({m_count, kMost, std::max(m_window + 1, kFewest)});
    const std::size_t oneIn = m_window > 0 ? 2 * kStepsBack : kStepsBack;
    const double widest = m_window > 0 ? kWidestSpot : kWideSpot;
    Box2 spot;
    Vec2 after = Vec2::Zero();
    double way = 0.0;
    std::size_t window = 0, held = 0, stepsBack = 0;
    for (std::size_t k = 0; k < most; ++k) {
        spot.extend(back(k));
        const double size = spot.size().norm() / m_tolerance;
        if (size <= widest && k + 1 < m_window)
            held = k + 1;
        else if (size > (window > 0 ? kSpot : widest))
            break;
        if (k == 0)
            continue;
        const Vec2 step = (back(k - 1) - back(k)) / m_tolerance;
        way += step.norm();
        if (step.dot(after) < 0.0 && step.norm() >= kStepBack)
            ++stepsBack;
        after = step;
        const bool isJitter = oneIn * stepsBack >= k && way >= kJitterWay * size;
        if (k + 1 >= kFewest && way > 0.0 && (isJitter || (size <= kSpot && way >= kWay * size)))
            window = k + 1;
    }
    // It fades, so that the line does not jump; and what looks calm for a few samples is none.
    return std::max(window, held);
}

} // namespace fff
