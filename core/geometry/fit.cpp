#include "core/geometry/fit.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Newton steps that may pull the parameters of one segment before it is split (Schneider: 4).
constexpr int kReparametrisations = 6;
/// Splitting is surer than reparametrising when the error is this many tolerances (Schneider
/// compares squared errors with a factor of 4; over long smooth strokes more is worth trying).
constexpr double kWorthIterating = 6.0;
/// A handle shorter than this part of the chord comes from a badly conditioned system (Schneider).
constexpr double kShortestHandle = 1e-6;
/// A handle longer than this part of the line's length overshoots.
constexpr double kLongestHandle = 1.0;

/// The closing piece's handles are halved so often at most to take a loop out of it.
constexpr int kHandleHalvings = 8;

/// The samples without repetitions, gaps filled, with their arc length. n each.
struct Line
{
    std::vector<Vec2> points;
    std::vector<double> length; // mm along the line, from the first point

    std::size_t size() const { return points.size(); }
    double lengthBetween(std::size_t a, std::size_t b) const { return length[b] - length[a]; }

    void add(const Vec2 &p)
    {
        length.push_back(points.empty() ? 0.0 : length.back() + (p - points.back()).norm());
        points.push_back(p);
    }
};

Line prepare(const std::vector<Vec2> &samples, double longestGap)
{
    Line line;
    for (const Vec2 &p : samples) {
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kMaxCoordinate)
            continue;
        if (line.points.empty()) {
            line.add(p);
            continue;
        }
        const Vec2 from = line.points.back();
        const double gap = (p - from).norm();
        if (gap <= kClipGrid)
            continue;
        const double pieces =
            std::min(std::ceil(gap / longestGap), double(CubicBezier::kMaxChords));
        for (double i = 1.0; i < pieces; ++i)
            line.add(from + (p - from) * (i / pieces));
        line.add(p);
    }
    return line;
}

double distanceToSegment(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    const Vec2 way = b - a;
    const double u = std::clamp(way.dot(p - a) / way.squaredNorm(), 0.0, 1.0);
    return (a + u * way - p).norm();
}

/// The point of the line at an arc length, between `from` and `to`.
Vec2 pointAt(const Line &line, std::size_t from, std::size_t to, double length)
{
    const auto begin = line.length.begin();
    const auto first = begin + static_cast<std::ptrdiff_t>(from);
    const auto last = begin + static_cast<std::ptrdiff_t>(to);
    const auto after = std::upper_bound(first, last, length);
    const auto i = static_cast<std::size_t>(after - begin);
    if (i == from)
        return line.points[from];
    const double step = line.length[i] - line.length[i - 1];
    const double u = std::clamp((length - line.length[i - 1]) / step, 0.0, 1.0);
    return line.points[i - 1] + u * (line.points[i] - line.points[i - 1]);
}

/// Unit direction from point i towards what lies `reach` along the line from it, within
/// [from, to]; backwards when reach is negative.
Vec2 directionOver(const Line &line, std::size_t from, std::size_t to, std::size_t i, double reach)
{
    const double target = std::clamp(line.length[i] + reach, line.length[from], line.length[to]);
    const Vec2 way = pointAt(line, from, to, target) - line.points[i];
    if (way.norm() > kClipGrid)
        return way.normalized();
    // The line comes back to the point just there: the nearest neighbour says where it goes.
    const std::size_t neighbour = reach > 0.0 ? std::min(i + 1, to) : std::max(i, from + 1) - 1;
    return (line.points[neighbour] - line.points[i]).normalized();
}

/// How much the line turns at point i, over `reach` on both sides. 0 … π.
double turnAt(const Line &line, std::size_t i, double reach)
{
    const Vec2 in = -directionOver(line, 0, line.size() - 1, i, -reach);
    const Vec2 out = directionOver(line, 0, line.size() - 1, i, reach);
    return std::abs(std::atan2(cross(in, out), in.dot(out)));
}

/// Indices of the corners, with the first and the last point. Of several candidates within a reach
/// the sharpest is one.
std::vector<std::size_t> findCorners(const Line &line, const FitOptions &options)
{
    const double reach = options.reach * options.tolerance;
    const std::size_t last = line.size() - 1;
    std::vector<std::size_t> corners{0};
    std::size_t best = 0; // of a reach; 0 for none, that is a corner already
    double bestTurn = 0.0;
    for (std::size_t i = 1; i < last; ++i) {
        if (best > 0 && line.lengthBetween(best, i) > reach) {
            corners.push_back(best);
            best = 0;
        }
        // So near to an end there is too little line to tell a corner from a shaky hand.
        if (line.length[i] < 0.5 * reach || line.lengthBetween(i, last) < 0.5 * reach)
            continue;
        const double turn = turnAt(line, i, reach);
        if (turn > options.cornerAngle && (best == 0 || turn > bestTurn)) {
            best = i;
            bestTurn = turn;
        }
    }
    if (best > 0)
        corners.push_back(best);
    corners.push_back(last);
    return corners;
}

/// Fits one stretch of the line between two corners.
class PieceFitter
{
public:
    PieceFitter(const Line &line, const FitOptions &options, std::vector<CubicBezier> &chain)
        : m_line(line), m_options(options), m_reach(options.reach * options.tolerance),
          m_chain(chain)
    {
    }

    void fit(std::size_t from, std::size_t to)
    {
        m_from = from;
        m_to = to;
        Vec2 out = directionOver(m_line, from, to, from, m_reach);
        Vec2 in = directionOver(m_line, from, to, to, -m_reach);
        if (from == 0 && m_options.startDirection)
            out = *m_options.startDirection;
        if (to + 1 == m_line.size() && m_options.endDirection)
            in = -*m_options.endDirection;
        fit(from, to, out, in);
    }

private:
    struct Error
    {
        double distance = 0.0; // mm
        std::size_t at = 0;    // index of the point to split at
    };

    void fit(std::size_t from, std::size_t to, const Vec2 &out, const Vec2 &in);
    CubicBezier solve(std::size_t from, std::size_t to, const Vec2 &out, const Vec2 &in) const;
    CubicBezier plain(std::size_t from, std::size_t to, const Vec2 &out, const Vec2 &in) const;
    Error largestError(std::size_t from, std::size_t to, const CubicBezier &curve) const;
    void reparametrise(const CubicBezier &curve);
    Vec2 splitDirection(std::size_t at) const;

    const Line &m_line;
    const FitOptions &m_options;
    const double m_reach;
    std::vector<CubicBezier> &m_chain;
    std::size_t m_from = 0, m_to = 0; // the stretch between two corners
    std::size_t m_first = 0;          // that m_parameters[0] belongs to
    std::vector<double> m_parameters; // of the points in work
};

void PieceFitter::fit(std::size_t from, std::size_t to, const Vec2 &out, const Vec2 &in)
{
    if (to - from == 1) {
        m_chain.push_back(plain(from, to, out, in));
        return;
    }
    m_first = from;
    m_parameters.resize(to - from + 1);
    for (std::size_t i = from; i <= to; ++i)
        m_parameters[i - from] = m_line.lengthBetween(from, i) / m_line.lengthBetween(from, to);

    CubicBezier curve = solve(from, to, out, in);
    Error error = largestError(from, to, curve);
    for (int i = 0; i < kReparametrisations && error.distance > m_options.tolerance &&
                    error.distance < kWorthIterating * m_options.tolerance;
         ++i) {
        reparametrise(curve);
        curve = solve(from, to, out, in);
        error = largestError(from, to, curve);
    }
    if (error.distance <= m_options.tolerance) {
        m_chain.push_back(curve);
        return;
    }
    const Vec2 direction = splitDirection(error.at);
    fit(from, error.at, out, -direction);
    fit(error.at, to, direction, in);
}

/// Least squares for the lengths of the two handles (Schneider, equation 3, by Cramer's rule).
CubicBezier PieceFitter::solve(std::size_t from, std::size_t to, const Vec2 &out,
                               const Vec2 &in) const
{
    const Vec2 &p0 = m_line.points[from], &p3 = m_line.points[to];
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0;
    for (std::size_t i = from; i <= to; ++i) {
        const double u = m_parameters[i - m_first], v = 1.0 - u;
        const double b0 = v * v * v, b1 = 3.0 * u * v * v, b2 = 3.0 * u * u * v, b3 = u * u * u;
        const Vec2 a0 = b1 * out, a1 = b2 * in;
        const Vec2 rest = m_line.points[i] - (b0 + b1) * p0 - (b2 + b3) * p3;
        c00 += a0.dot(a0);
        c01 += a0.dot(a1);
        c11 += a1.dot(a1);
        x0 += a0.dot(rest);
        x1 += a1.dot(rest);
    }
    const double determinant = c00 * c11 - c01 * c01;
    const double chord = (p3 - p0).norm();
    const double shortest = kShortestHandle * chord;
    const double longest = kLongestHandle * m_line.lengthBetween(from, to);
    const double alpha0 = (x0 * c11 - x1 * c01) / determinant;
    const double alpha1 = (c00 * x1 - c01 * x0) / determinant;
    const auto isUsable = [&](double alpha) { return alpha > shortest && alpha < longest; };
    // The comparison is false for what a vanishing determinant makes of them, too.
    if (!(isUsable(alpha0) && isUsable(alpha1)))
        return plain(from, to, out, in);
    return {p0, p0 + alpha0 * out, p3 + alpha1 * in, p3};
}

/// Handles of a third of the chord (the rule of Wu and Barsky in Schneider).
CubicBezier PieceFitter::plain(std::size_t from, std::size_t to, const Vec2 &out,
                               const Vec2 &in) const
{
    const Vec2 &p0 = m_line.points[from], &p3 = m_line.points[to];
    const double handle = (p3 - p0).norm() / 3.0;
    return {p0, p0 + handle * out, p3 + handle * in, p3};
}

PieceFitter::Error PieceFitter::largestError(std::size_t from, std::size_t to,
                                             const CubicBezier &curve) const
{
    // Where nothing is off, the middle is as good as any.
    Error error{0.0, (from + to) / 2};
    const auto take = [&](double distance, std::size_t at) {
        if (distance > error.distance)
            error = {distance, std::clamp(at, from + 1, to - 1)};
    };
    for (std::size_t i = from; i < to; ++i) {
        const double u = m_parameters[i - m_first], next = m_parameters[i + 1 - m_first];
        if (i > from)
            take((curve.at(u) - m_line.points[i]).norm(), i);
        take(distanceToSegment(curve.at(0.5 * (u + next)), m_line.points[i], m_line.points[i + 1]),
             i);
    }
    return error;
}

/// One Newton step for each parameter towards the foot of its point on the curve, kept in order.
void PieceFitter::reparametrise(const CubicBezier &curve)
{
    for (std::size_t k = 1; k + 1 < m_parameters.size(); ++k) {
        double &u = m_parameters[k];
        const Vec2 off = curve.at(u) - m_line.points[m_first + k];
        const Vec2 d1 = curve.derivative(u), d2 = curve.secondDerivative(u);
        const double slope = d1.dot(d1) + off.dot(d2);
        if (slope > 0.0)
            u -= off.dot(d1) / slope;
        u = std::clamp(u, m_parameters[k - 1], 1.0);
    }
}

/// Direction of the line through a point between two corners, over a reach on both sides.
Vec2 PieceFitter::splitDirection(std::size_t at) const
{
    const Vec2 before = directionOver(m_line, m_from, m_to, at, -m_reach);
    const Vec2 after = directionOver(m_line, m_from, m_to, at, m_reach);
    const Vec2 through = after - before;
    // A line that goes back on itself has no direction there: it turns.
    return through.norm() > kClipGrid ? Vec2(through.normalized()) : perpendicular(after);
}

/// Whether the cubic a t³ + b t² + c t + p0 passes a point twice: a (t² + ts + s²) + b (t + s) + c
/// = 0 for two parameters s < t within 0 … 1. Two linear equations give t + s and t² + ts + s².
bool crossesItself(const CubicBezier &curve)
{
    const Vec2 a = curve.p3 - 3.0 * curve.p2 + 3.0 * curve.p1 - curve.p0;
    const Vec2 b = 3.0 * (curve.p2 - 2.0 * curve.p1 + curve.p0);
    const Vec2 c = 3.0 * (curve.p1 - curve.p0);
    const double determinant = cross(a, b);
    const double sum = -cross(a, c) / determinant;
    const double squares = cross(b, c) / determinant;
    const double product = sum * sum - squares;
    const double discriminant = sum * sum - 4.0 * product;
    // False as well for the infinities of a vanishing determinant: a parabola does not cross
    // itself.
    return discriminant > 0.0 && sum - std::sqrt(discriminant) >= 0.0 &&
           sum + std::sqrt(discriminant) <= 2.0;
}

/// Direction of the first of `points` that is away from `from`.
Vec2 directionTo(const Vec2 &from, std::initializer_list<Vec2> points)
{
    for (const Vec2 &p : points) {
        const double distance = (p - from).norm();
        if (distance > 0.0)
            return (p - from) / distance;
    }
    return Vec2::Zero();
}

} // namespace

std::vector<CubicBezier> fitCurve(const std::vector<Vec2> &samples, const FitOptions &options)
{
    const Line line = prepare(samples, options.reach * options.tolerance);
    std::vector<CubicBezier> chain;
    if (line.size() < 2)
        return chain;
    const std::vector<std::size_t> corners = findCorners(line, options);
    PieceFitter fitter(line, options, chain);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        fitter.fit(corners[i], corners[i + 1]);
    return chain;
}

CubicBezier closingSegment(const std::vector<CubicBezier> &chain)
{
    const Vec2 &from = chain.back().p3, &to = chain.front().p0;
    const Vec2 out = endDirection(chain.back()), in = startDirection(chain.front());
    double handle = (to - from).norm() / 3.0;
    CubicBezier closing{from, from + handle * out, to - handle * in, to};
    for (int i = 0; i < kHandleHalvings && crossesItself(closing); ++i) {
        handle *= 0.5;
        closing = {from, from + handle * out, to - handle * in, to};
    }
    return closing;
}

Vec2 startDirection(const CubicBezier &s)
{
    return directionTo(s.p0, {s.p1, s.p2, s.p3});
}

Vec2 endDirection(const CubicBezier &s)
{
    return -directionTo(s.p3, {s.p2, s.p1, s.p0});
}

} // namespace fff
