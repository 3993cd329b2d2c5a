#include "core/stroke/meant_line.h"

#include "core/stroke/calmed_line.h"
#include "core/stroke/filled_line.h"

#include <algorithm>

namespace fff {

namespace {

/// Samples back from a new one that are another place for it: the last one may have moved.
constexpr std::size_t kChanging = kCalmLookAround + 1;
constexpr std::size_t kOpen = kChanging + kFillLookAround + 1;

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
    if (m_followed > kOpen)
        m_settled.follow(m_points, m_places[m_followed - kOpen]);
}

void MeantLine::clear()
{
    *this = MeantLine(m_options);
}

} // namespace fff
