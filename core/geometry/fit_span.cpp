#include "core/geometry/fit_span.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Samples that say how long the handles are.
constexpr std::size_t kFewSamples = 24;
constexpr int kSteps = 6;
/// Steps that do not bring the error down to this part of it lead nowhere.
constexpr double kProgress = 0.9;
/// An error of so many tolerances after the first step will not come down to one.
constexpr double kHopeless = 8.0;
/// Least and largest length of a handle, as parts of the stretch's.
constexpr double kShortestHandle = 0.02, kLongestHandle = 0.8;
/// Of the normal matrix, what is added to its diagonal: where both directions lie along the
/// samples, the lengths are free and stay.
constexpr double kDamping = 1e-4;
/// And so much more, in mm², so that nothing is divided by zero where all slopes are zero.
constexpr double kLeastDamping = 1e-12;
/// Rounding that the tolerance is to hold in spite of, as a part of it.
constexpr double kMargin = 1e-6;
/// Places looked at between the feet of two neighbours; as many as make half a tolerance each.
constexpr int kMostChecks = 14;
/// Halvings of the handles of a short piece.
constexpr int kHalvings = 8;

/// A cubic as polynomials of its parameter, in plain numbers: what takes the time is here.
struct Polynomial
{
    double ax, bx, cx, dx, ay, by, cy, dy;

    explicit Polynomial(const CubicBezier &s)
        : ax(s.p3.x() - s.p0.x() + 3.0 * (s.p1.x() - s.p2.x())),
          bx(3.0 * (s.p0.x() - 2.0 * s.p1.x() + s.p2.x())), cx(3.0 * (s.p1.x() - s.p0.x())),
          dx(s.p0.x()), ay(s.p3.y() - s.p0.y() + 3.0 * (s.p1.y() - s.p2.y())),
          by(3.0 * (s.p0.y() - 2.0 * s.p1.y() + s.p2.y())), cy(3.0 * (s.p1.y() - s.p0.y())),
          dy(s.p0.y())
    {
    }

    double x(double u) const { return ((ax * u + bx) * u + cx) * u + dx; }
    double y(double u) const { return ((ay * u + by) * u + cy) * u + dy; }
    double slopeX(double u) const { return (3.0 * ax * u + 2.0 * bx) * u + cx; }
    double slopeY(double u) const { return (3.0 * ay * u + 2.0 * by) * u + cy; }

    /// One Newton step towards the foot of a point.
    double nearerFoot(double u, double px, double py) const
    {
        const double ox = x(u) - px, oy = y(u) - py, sx = slopeX(u), sy = slopeY(u);
        const double f = ox * sx + oy * sy;
        const double slope =
            sx * sx + sy * sy + ox * (6.0 * ax * u + 2.0 * bx) + oy * (6.0 * ay * u + 2.0 * by);
        if (!(slope > 0.0))
            return u;
        return std::clamp(u - f / slope, 0.0, 1.0);
    }
};

double turnOf(const CubicBezier &s)
{
    return turnBetween(s.p1 - s.p0, s.p2 - s.p1) + turnBetween(s.p2 - s.p1, s.p3 - s.p2);
}

CubicBezier withHandles(const CurveEnd &start, const CurveEnd &end, double first, double second)
{
    return {start.position, start.position + first * start.direction,
            end.position - second * end.direction, end.position};
}

} // namespace

SpanFitter::SpanFitter(const SampledLine &line, double tolerance)
    : m_line(line), m_limit(tolerance * (1.0 - kMargin))
{
}

void SpanFitter::chooseSamples(std::size_t from, std::size_t to)
{
    m_feet.clear();
    const double length = m_line.lengthBetween(from, to);
    const auto add = [&](std::size_t i) {
        // A hand that slips back gets on by nothing: its samples are spread by their number.
        m_feet.push_back({i, length > 0.0 ? m_line.lengthBetween(from, i) / length
                                          : static_cast<double>(i - from) /
                                                static_cast<double>(to - from)});
    };
    if (to - from <= kFewSamples) {
        for (std::size_t i = from + 1; i < to; ++i)
            add(i);
        return;
    }
    for (std::size_t k = 0; k < kFewSamples; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / kFewSamples;
        const std::size_t i = m_line.indexAt(m_line.along(from) + share * length);
        if (i > from && i < to && (m_feet.empty() || i > m_feet.back().sample))
            add(i);
    }
}

bool SpanFitter::isWithin(const CubicBezier &curve, std::size_t from, std::size_t to) const
{
    const Polynomial p(curve);
    const double limit = m_limit * m_limit;
    const double perLimit = 2.0 * m_line.lengthBetween(from, to) / m_limit;
    std::size_t knot = 0; // of the feet, the next one
    double s0 = m_line.along(from), u0 = 0.0;
    double s1 = m_feet.empty() ? m_line.along(to) : m_line.along(m_feet.front().sample);
    double u1 = m_feet.empty() ? 1.0 : m_feet.front().u;
    double before = 0.0; // parameter of the sample before
    for (std::size_t i = from; i < to; ++i, ++m_lookedAt) {
        // The foot of the next sample, starting between those that are known.
        double u = 1.0;
        const Vec2 &a = m_line.point(i), &b = m_line.point(i + 1);
        if (i + 1 < to) {
            const double s = m_line.along(i + 1);
            while (s > s1 && knot < m_feet.size()) {
                s0 = s1;
                u0 = u1;
                ++knot;
                s1 = knot < m_feet.size() ? m_line.along(m_feet[knot].sample) : m_line.along(to);
                u1 = knot < m_feet.size() ? m_feet[knot].u : 1.0;
            }
            u = s1 > s0 ? u0 + (u1 - u0) * (s - s0) / (s1 - s0) : u1;
            u = p.nearerFoot(p.nearerFoot(u, b.x(), b.y()), b.x(), b.y());
            const double ox = p.x(u) - b.x(), oy = p.y(u) - b.y();
            if (ox * ox + oy * oy > limit)
                return false;
        }
        // The curve between the two feet, from the straight way between the samples.
        const double wx = b.x() - a.x(), wy = b.y() - a.y();
        const double inverse = 1.0 / (wx * wx + wy * wy);
        const int checks =
            2 + std::min(static_cast<int>(std::abs(u - before) * perLimit), kMostChecks);
        for (int k = 1; k <= checks; ++k) {
            const double middle = before + k * (u - before) / (checks + 1);
            const double mx = p.x(middle) - a.x(), my = p.y(middle) - a.y();
            const double along = std::clamp((mx * wx + my * wy) * inverse, 0.0, 1.0);
            const double dx = mx - along * wx, dy = my - along * wy;
            if (dx * dx + dy * dy > limit)
                return false;
        }
        before = u;
    }
    return true;
}

std::optional<CubicBezier> SpanFitter::fit(std::size_t from, std::size_t to, const CurveEnd &start,
                                           const CurveEnd &end)
{
    return fit(from, to, start, end, true);
}

std::optional<CubicBezier> SpanFitter::best(std::size_t from, std::size_t to, const CurveEnd &start,
                                            const CurveEnd &end)
{
    return fit(from, to, start, end, false);
}

std::optional<CubicBezier> SpanFitter::fit(std::size_t from, std::size_t to, const CurveEnd &start,
                                           const CurveEnd &end, bool isFirstEnough)
{
    const double length = m_line.lengthBetween(from, to);
    if (!(length > 0.0))
        return {};
    chooseSamples(from, to);
    const double shortest = kShortestHandle * length, longest = kLongestHandle * length;
    const Vec2 &out = start.direction;
    const Vec2 in = -end.direction;
    double first = length / 3.0, second = length / 3.0;
    double errorBefore = std::numeric_limits<double>::infinity();
    std::optional<CubicBezier> found;
    for (int step = 0;; ++step) {
        const CubicBezier curve = withHandles(start, end, first, second);
        const Polynomial p(curve);
        m_lookedAt += m_feet.size();
        double j00 = 0.0, j01 = 0.0, j11 = 0.0, r0 = 0.0, r1 = 0.0, error = 0.0;
        for (Foot &foot : m_feet) {
            const Vec2 &sample = m_line.point(foot.sample);
            const double u = foot.u = p.nearerFoot(foot.u, sample.x(), sample.y());
            const double v = 1.0 - u;
            const double ox = p.x(u) - sample.x(), oy = p.y(u) - sample.y();
            error = std::max(error, ox * ox + oy * oy);
            const double sx = p.slopeX(u), sy = p.slopeY(u);
            const double speed = sx * sx + sy * sy;
            if (!(speed > 0.0))
                continue;
            // Across the curve: the parameter is free along it.
            const double across = (ox * -sy + oy * sx);
            const double a = 3.0 * u * v * v * (out.x() * -sy + out.y() * sx);
            const double b = 3.0 * u * u * v * (in.x() * -sy + in.y() * sx);
            const double weight = 1.0 / speed;
            j00 += weight * a * a;
            j01 += weight * a * b;
            j11 += weight * b * b;
            r0 += weight * a * across;
            r1 += weight * b * across;
        }
        error = std::sqrt(error);
        if (found && error > kProgress * errorBefore)
            return found;
        if (error <= m_limit && turnOf(curve) <= kLargestTurn && isWithin(curve, from, to)) {
            if (isFirstEnough)
                return curve;
            found = curve;
        }
        if (step == kSteps || (step > 0 && error > kHopeless * m_limit) ||
            (step > 1 && error > kProgress * errorBefore))
            return found;
        errorBefore = error;
        const double damping = kDamping * (j00 + j11) + kLeastDamping;
        j00 += damping;
        j11 += damping;
        const double determinant = j00 * j11 - j01 * j01;
        first = std::clamp(first - (j11 * r0 - j01 * r1) / determinant, shortest, longest);
        second = std::clamp(second - (j00 * r1 - j01 * r0) / determinant, shortest, longest);
    }
}

std::optional<CubicBezier> SpanFitter::shortPiece(std::size_t from, std::size_t to,
                                                  const CurveEnd &start, const CurveEnd &end)
{
    double handle = (end.position - start.position).norm() / 3.0;
    chooseSamples(from, to);
    for (int i = 0; i < kHalvings; ++i, handle *= 0.5) {
        const CubicBezier curve = withHandles(start, end, handle, handle);
        if (turnOf(curve) > kLargestTurn)
            return {};
        if (isWithin(curve, from, to))
            return curve;
    }
    return {};
}

CubicBezier SpanFitter::shortestPiece(std::size_t from, std::size_t to, const CurveEnd &start,
                                      const CurveEnd &end)
{
    if (const auto curve = shortPiece(from, to, start, end))
        return *curve;
    const double handle = std::ldexp((end.position - start.position).norm() / 3.0, -kHalvings);
    return withHandles(start, end, handle, handle);
}

} // namespace fff
