// Where a trembling hand means to be.
#pragma once

#include "core/geometry/vector.h"

#include <array>
#include <cstddef>

namespace fff {

/// Of a hand that goes to and fro on a spot, the mean of what it has just drawn; of every other
/// hand the sample as it is. What a thousand samples a second tell of a tremor is no line that
/// anybody wants: followed, it is a scribble.
///
/// A window of at least kFewest samples is a tremble where it lies on a spot of a few tolerances
/// and
///   - its way is many times the size of that; or
///   - goes back at every third sample or more often: no corner does that, however sharp.
/// The longest such window counts, one sample longer than the last at most, so that the mean goes
/// forward as the hand does; and one shorter at least while it still lies on the spot, so that the
/// line does not jump. Depends on nothing but the samples. O(kMost) each.
class SteadyHand
{
public:
    static constexpr std::size_t kFewest = 8, kMost = 192;

    /// tolerance: of the fit, mm
    explicit SteadyHand(double tolerance) : m_tolerance(tolerance) {}

    /// The sample has to be finite.
    Vec2 follow(const Vec2 &sample);
    /// With its last sample the hand has turned out to tremble from its first one on: what was
    /// followed until then is no part of the line.
    bool beginsAnew() const { return m_beginsAnew; }

private:
    std::size_t trembling() const;
    bool hasJustBegun() const;
    const Vec2 &back(std::size_t k) const { return m_recent[(m_count - 1 - k) % kMost]; }

    double m_tolerance; // mm
    std::array<Vec2, kMost> m_recent;
    std::size_t m_count = 0;  // samples so far
    std::size_t m_window = 0; // samples of the mean, 0 where the hand does not tremble
    bool m_beginsAnew = false;
};

} // namespace fff
