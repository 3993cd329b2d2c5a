#include "core/stroke/meant_line.h"

#include "core/stroke/calmed_line.h"
#include "core/stroke/filled_line.h"

#include <algorithm>

namespace fff {

namespace {

/// Samples back from a new one that are another place for it: the last one may have moved.
constexpr std::size_t kChanging = kCalmLookAround + 1;
constexpr std::size_t kOpen = kChanging + kFillLookAround + 1;

/// Part of the samples that are noise, and points to a sample, from which on corners are in doubt;
/// and what still is one then, radians.
constexpr double kGuessed = 0.3, kFilled = 1.5, kNoisyCorner = 0.85, kFilledCorner = 0.7;

std::size_t before(std::size_t count, std::size_t by)
{
    return count > by ? count - by : 0;
}

} // namespace

MeantLine::MeantLine(const FitOptions &options) : m_options(options), m_settled(options) {}

void MeantLine::follow(const std::vector<Vec2> &samples)
{
    calm(samples, m_options.tolerance, before(m_followed, kChanging), m_calmed);
    fill(m_calmed, m_options.tolerance, before(m_followed, kOpen), m_points, m_places);
    m_followed = samples.size();
    // Those that do not change any more.
    for (; m_counted + kOpen < m_followed; ++m_counted)
        m_moved += m_calmed[m_counted] != samples[m_counted] ? 1 : 0;
    if (m_followed > kOpen)
        m_settled.follow(m_points, m_places[m_followed - kOpen]);
}

double MeantLine::cornerAngle() const
{
    const bool isNoisy = kGuessed * static_cast<double>(m_counted) < double(m_moved);
    const bool isFilled = kFilled * static_cast<double>(m_followed) < double(m_points.size());
    const double least = isNoisy ? kNoisyCorner : isFilled ? kFilledCorner : 0.0;
    return std::max(least, m_options.cornerAngle);
}

void MeantLine::clear()
{
    *this = MeantLine(m_options);
}

} // namespace fff
