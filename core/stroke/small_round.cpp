#include "core/stroke/small_round.h"

#include "core/geometry/polygon.h"
#include "core/geometry/round_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// Of the tolerance, what the line is off the ellipse, on the mean and at most.
constexpr double kMeanOff = 0.32, kMostOff = 1.0;
/// Of the extent, what the ends are apart at most; of the longer half axis, the shorter at least.
constexpr double kEndsApart = 0.4, kSlimmest = 0.3;

/// Four segments round, from a place on it, in the direction of the line.
std::vector<CubicBezier> around(const RoundFit &fit, const Vec2 &from, bool isLeft)
{
    const Vec2 x(std::cos(fit.turn), std::sin(fit.turn));
    const Vec2 y = (isLeft ? 1.0 : -1.0) * perpendicular(x);
    const Vec2 off = from - fit.centre;
    const double start = std::atan2(y.dot(off) / fit.minor, x.dot(off) / fit.major);
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    const double handle = 4.0 / 3.0 * std::tan(0.25 * kQuarter);
    const auto at = [&](double angle) -> Vec2 {
        return fit.centre + fit.major * std::cos(angle) * x + fit.minor * std::sin(angle) * y;
    };
    const auto slope = [&](double angle) -> Vec2 {
        return fit.minor * std::cos(angle) * y - fit.major * std::sin(angle) * x;
    };
    std::vector<CubicBezier> loop;
    for (int k = 0; k < 4; ++k) {
        const double a = start + k * kQuarter, b = a + kQuarter;
        loop.push_back({k > 0 ? loop.back().p3 : at(a), at(a) + handle * slope(a),
                        at(b) - handle * slope(b), at(b)});
    }
    loop.back().p3 = loop.front().p0;
    return loop;
}

} // namespace

std::optional<std::vector<CubicBezier>> smallRound(const std::vector<Vec2> &line, double tolerance)
{
    const double extent = line.empty() ? 0.0 : bounds(line).size().maxCoeff();
    if (!(extent > 0.0) || extent >= kSmall * tolerance ||
        (line.back() - line.front()).norm() > kEndsApart * extent)
        return {};
    const std::optional<RoundFit> fit = fitEllipse(line);
    if (!fit || fit->mean > kMeanOff * tolerance || fit->most > kMostOff * tolerance ||
        fit->minor < kSlimmest * fit->major || 2.0 * fit->major > 1.5 * extent)
        return {};
    return around(*fit, line.front(), signedArea(line) > 0.0);
}

} // namespace fff
