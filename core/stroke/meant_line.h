// The line that a hand means by its samples, and what of its fit is settled.
#pragma once

#include "core/geometry/settled_fit.h"

#include <cstddef>
#include <vector>

namespace fff {

/// Without noise (calmed_line.h), and with the bends between few samples (filled_line.h); where
/// there is neither, the samples themselves. Follows samples as they come: what lies
/// far enough back does not change any more, and is settled as by SettledFit. A function of the
/// samples alone, however often it is followed. O(1) for each, besides settling.
class MeantLine
{
public:
    /// options: of the fit that is settled
    explicit MeantLine(const FitOptions &options);

    /// All but the last of the samples are those of the call before (or of one before a clear()),
    /// and further ones. All have to be looked at (SampledLine::usable).
    void follow(const std::vector<Vec2> &samples);
    void clear();

    /// No two equal in a row; the first is the first sample but for noise, and the last the last.
    const std::vector<Vec2> &points() const { return m_points; }
    /// Where a sample is among the points; their number for one that is not there yet.
    std::size_t placeOf(std::size_t sample) const
    {
        return sample < m_places.size() ? m_places[sample] : m_points.size();
    }
    /// The angle that is a corner of it (FitOptions): a larger one where much of it is guessed, as
    /// noise or bends between samples are.
    double cornerAngle() const;
    /// Of the points.
    const SettledFit &settled() const { return m_settled; }

private:
    FitOptions m_options;
    std::size_t m_followed = 0; // samples
    std::vector<Vec2> m_calmed; // as many
    std::size_t m_moved = 0;    // of them those that are not the samples, among the first m_counted
    std::size_t m_counted = 0;
    std::vector<Vec2> m_points;
    std::vector<std::size_t> m_places; // of the samples among the points
    SettledFit m_settled;
};

} // namespace fff
