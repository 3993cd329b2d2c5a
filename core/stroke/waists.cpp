#include "core/stroke/waists.h"

#include <algorithm>
#include <iterator>

namespace fff {

namespace {

/// Tolerances: what is as low is a waist, if it goes no farther under the axis than a hand trembles
/// and is no longer than that.
constexpr double kWaistHeight = 2.0, kUnderWaist = 2.5, kLongestWaist = 30.0;

} // namespace

std::vector<Vec2> withWaists(std::vector<Vec2> line, double tolerance, double largest)
{
    const double low = kWaistHeight * tolerance;
    const double high = std::max(kWaistPart * largest, low);
    const auto isPart = [&](const Vec2 &p) { return p.y() > high; };
    auto waist = std::find_if(line.begin(), line.end(), isPart);
    while (waist != line.end()) {
        const auto isLow = [&](const Vec2 &p) { return p.y() < low; };
        const auto begin = std::find_if(waist, line.end(), isLow);
        const auto next = std::find_if(begin, line.end(), isPart);
        if (next == line.end())
            break;
        const auto end =
            std::find_if(std::make_reverse_iterator(next), std::make_reverse_iterator(begin), isLow)
                .base();
        const auto [left, right] = std::minmax_element(
            begin, end, [](const Vec2 &a, const Vec2 &b) { return a.x() < b.x(); });
        const auto deepest = std::min_element(
            begin, end, [](const Vec2 &a, const Vec2 &b) { return a.y() < b.y(); });
        if (begin != end && deepest->y() >= -kUnderWaist * tolerance &&
            right->x() - left->x() <= kLongestWaist * tolerance)
            std::for_each(begin, end, [&](Vec2 &p) { p.y() = std::max(p.y(), low); });
        waist = next;
    }
    return line;
}

} // namespace fff
