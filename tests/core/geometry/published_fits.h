// Three published ways to fit cubics to a stroke, written from their papers, for comparison: how
// many segments a good fit needs. Slow; they hold the tolerance at the samples only, which is less
// than ours promises.
#pragma once

#include "core/geometry/bezier.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace fff::test {

using Samples = std::vector<Vec2>;

inline Vec2 unitOf(const Vec2 &way)
{
    const double length = way.norm();
    return length > 0.0 ? Vec2(way / length) : Vec2(1.0, 0.0);
}

/// What all three work on: samples between corners, gaps filled, some way apart, with directions.
struct Stretches
{
    std::vector<Samples> lines;
};

/// Corners where the line turns by more than 0.6 over a reach on both sides, the sharpest of a run.
/// Samples are at least half a step apart and at most one.
inline Stretches cutAtCorners(const Samples &samples, double reach, double step)
{
    Samples line;
    for (const Vec2 &p : samples) {
        if (line.empty()) {
            line.push_back(p);
            continue;
        }
        const Vec2 from = line.back();
        const double gap = (p - from).norm();
        if (gap < 0.5 * step)
            continue;
        const int pieces = static_cast<int>(std::ceil(gap / step));
        for (int i = 1; i <= pieces; ++i)
            line.push_back(from + (p - from) * (double(i) / pieces));
    }
    const auto at = [&](std::size_t i, double distance) {
        std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i), way = distance > 0.0 ? 1 : -1;
        while (k + way >= 0 && k + way < std::ptrdiff_t(line.size()) &&
               (line[std::size_t(k)] - line[i]).norm() < std::abs(distance))
            k += way;
        return line[std::size_t(k)];
    };
    Stretches result;
    std::size_t start = 0;
    const auto turnAt = [&](std::size_t i) {
        const Vec2 in = unitOf(line[i] - at(i, -reach)), out = unitOf(at(i, reach) - line[i]);
        return std::abs(std::atan2(cross(in, out), in.dot(out)));
    };
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
        const double turn = turnAt(i);
        if (turn < 0.6 || (line[i] - line[start]).norm() < 0.5 * reach ||
            (line[i] - line.back()).norm() < 0.5 * reach)
            continue;
        bool isSharpest = true;
        for (std::size_t k = i > 8 ? i - 8 : 1; k < std::min(i + 9, line.size() - 1); ++k)
            if (k != i && (line[k] - line[i]).norm() < reach &&
                (turnAt(k) > turn || (turnAt(k) == turn && k < i)))
                isSharpest = false;
        if (!isSharpest)
            continue;
        result.lines.emplace_back(line.begin() + std::ptrdiff_t(start),
                                  line.begin() + std::ptrdiff_t(i) + 1);
        start = i;
    }
    result.lines.emplace_back(line.begin() + std::ptrdiff_t(start), line.end());
    return result;
}

inline double squaredDistance(const CubicBezier &curve, double t, const Vec2 &p)
{
    return (curve.at(t) - p).squaredNorm();
}

inline std::vector<double> chordParameters(const Samples &line, std::size_t from, std::size_t to)
{
    std::vector<double> u{0.0};
    for (std::size_t i = from + 1; i <= to; ++i)
        u.push_back(u.back() + (line[i] - line[i - 1]).norm());
    for (double &value : u)
        value /= u.back() > 0.0 ? u.back() : 1.0;
    return u;
}

/// Schneider's equation 3: the handles by least squares, a third of the chord where they come out
/// useless.
inline CubicBezier leastSquares(const Samples &line, std::size_t from, std::size_t to,
                                const std::vector<double> &u, const Vec2 &out, const Vec2 &in)
{
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0;
    const Vec2 &p0 = line[from], &p3 = line[to];
    for (std::size_t i = from; i <= to; ++i) {
        const double t = u[i - from], s = 1.0 - t;
        const Vec2 a0 = 3.0 * t * s * s * out, a1 = 3.0 * t * t * s * in;
        const Vec2 rest = line[i] - s * s * (s + 3.0 * t) * p0 - t * t * (t + 3.0 * s) * p3;
        c00 += a0.dot(a0);
        c01 += a0.dot(a1);
        c11 += a1.dot(a1);
        x0 += a0.dot(rest);
        x1 += a1.dot(rest);
    }
    const double determinant = c00 * c11 - c01 * c01;
    double first = (x0 * c11 - x1 * c01) / determinant;
    double second = (c00 * x1 - c01 * x0) / determinant;
    const double chord = (p3 - p0).norm();
    if (!(first > 1e-6 * chord && second > 1e-6 * chord && first < 5.0 * chord + 1.0 &&
          second < 5.0 * chord + 1.0))
        first = second = chord / 3.0;
    return {p0, p0 + first * out, p3 + second * in, p3};
}

inline void reparametrise(const Samples &line, std::size_t from, const CubicBezier &curve,
                          std::vector<double> &u)
{
    for (std::size_t i = 1; i + 1 < u.size(); ++i) {
        const Vec2 off = curve.at(u[i]) - line[from + i];
        const Vec2 d1 = curve.derivative(u[i]), d2 = curve.secondDerivative(u[i]);
        const double slope = d1.dot(d1) + off.dot(d2);
        if (slope > 0.0)
            u[i] = std::clamp(u[i] - off.dot(d1) / slope, 0.0, 1.0);
    }
}

/// Largest distance (squared) of samples from the curve at their parameters, and which one.
inline std::pair<double, std::size_t> largestError(const Samples &line, std::size_t from,
                                                   const CubicBezier &curve,
                                                   const std::vector<double> &u)
{
    std::pair<double, std::size_t> worst{0.0, from + u.size() / 2};
    for (std::size_t i = 1; i + 1 < u.size(); ++i) {
        const double error = squaredDistance(curve, u[i], line[from + i]);
        if (error > worst.first)
            worst = {error, from + i};
    }
    return worst;
}

/// Direction at a sample over some neighbours on the sides asked for.
inline Vec2 directionAt(const Samples &line, std::size_t i, double reach, bool before, bool after)
{
    std::size_t a = i, b = i;
    while (before && a > 0 && (line[a] - line[i]).norm() < reach)
        --a;
    while (after && b + 1 < line.size() && (line[b] - line[i]).norm() < reach)
        ++b;
    if (a == b)
        return {1.0, 0.0};
    return unitOf(line[b] - line[a]);
}

/// P. Schneider 1990, An Algorithm for Automatically Fitting Digitized Curves, Graphics Gems.
class SchneiderFit
{
public:
    SchneiderFit(double tolerance, double reach) : m_error(tolerance * tolerance), m_reach(reach) {}

    std::vector<CubicBezier> fit(const Stretches &stretches)
    {
        for (const Samples &line : stretches.lines)
            fit(line, 0, line.size() - 1, directionAt(line, 0, m_reach, false, true),
                -directionAt(line, line.size() - 1, m_reach, true, false));
        return m_chain;
    }

private:
    void fit(const Samples &line, std::size_t from, std::size_t to, const Vec2 &out, const Vec2 &in)
    {
        if (to - from == 1) {
            const double handle = (line[to] - line[from]).norm() / 3.0;
            m_chain.push_back(
                {line[from], line[from] + handle * out, line[to] + handle * in, line[to]});
            return;
        }
        std::vector<double> u = chordParameters(line, from, to);
        CubicBezier curve = leastSquares(line, from, to, u, out, in);
        auto [error, split] = largestError(line, from, curve, u);
        for (int i = 0; i < 4 && error > m_error && error < 16.0 * m_error; ++i) {
            reparametrise(line, from, curve, u);
            curve = leastSquares(line, from, to, u, out, in);
            std::tie(error, split) = largestError(line, from, curve, u);
        }
        if (error <= m_error) {
            m_chain.push_back(curve);
            return;
        }
        const Vec2 direction = directionAt(line, split, m_reach, true, true);
        fit(line, from, split, out, -direction);
        fit(line, split, to, direction, in);
    }

    double m_error, m_reach;
    std::vector<CubicBezier> m_chain;
};

/// M. Plass, M. Stone 1983, Curve-fitting with piecewise parametric cubics, SIGGRAPH: directions
/// first, then the fewest segments (of those the least error) over all pairs of knots.
class PlassStoneFit
{
public:
    PlassStoneFit(double tolerance, double reach) : m_error(tolerance * tolerance), m_reach(reach)
    {
    }

    std::vector<CubicBezier> fit(const Stretches &stretches)
    {
        std::vector<CubicBezier> chain;
        for (const Samples &line : stretches.lines)
            fit(line, chain);
        return chain;
    }

private:
    static constexpr std::size_t kKnots = 40; // of a stretch

    void fit(const Samples &line, std::vector<CubicBezier> &chain) const
    {
        std::vector<std::size_t> knots;
        const std::size_t last = line.size() - 1;
        const std::size_t count = std::min(last, std::max(kKnots, last / 12));
        for (std::size_t k = 0; k <= count; ++k)
            knots.push_back(k * last / count);
        struct Best
        {
            int segments = 1 << 20;
            double error = 0.0;
            std::size_t before = 0;
            CubicBezier curve;
        };
        std::vector<Best> best(knots.size());
        best[0].segments = 0;
        for (std::size_t j = 1; j < knots.size(); ++j) {
            int failures = 0;
            for (std::size_t i = j; i-- > 0 && failures < 3;) {
                const bool isNext = i + 1 == j;
                const std::size_t from = knots[i], to = knots[j];
                const Vec2 out = directionAt(line, from, m_reach, from > 0, true);
                const Vec2 in = -directionAt(line, to, m_reach, true, to < last);
                std::vector<double> u = chordParameters(line, from, to);
                CubicBezier curve = leastSquares(line, from, to, u, out, in);
                double error = largestError(line, from, curve, u).first;
                for (int k = 0; k < 4 && error > m_error && error < 36.0 * m_error; ++k) {
                    reparametrise(line, from, curve, u);
                    curve = leastSquares(line, from, to, u, out, in);
                    error = largestError(line, from, curve, u).first;
                }
                if (error > m_error && !isNext) {
                    ++failures;
                    continue;
                }
                failures = 0;
                const int segments = best[i].segments + 1;
                if (segments < best[j].segments ||
                    (segments == best[j].segments && best[i].error + error < best[j].error))
                    best[j] = {segments, best[i].error + error, i, curve};
            }
        }
        std::vector<CubicBezier> found;
        for (std::size_t j = knots.size() - 1; j > 0; j = best[j].before)
            found.push_back(best[j].curve);
        chain.insert(chain.end(), found.rbegin(), found.rend());
    }

    double m_error, m_reach;
};

/// R. Levien 2009, From Spiral to Spline (thesis, UC Berkeley), chapter 9, and 2021, Fitting cubic
/// Bézier curves: of the cubics with the directions at the ends and the area under the chord given,
/// the one whose first moment is that of the line, too. What does not fit is halved.
class LevienFit
{
public:
    LevienFit(double tolerance, double reach) : m_error(tolerance * tolerance), m_reach(reach) {}

    std::vector<CubicBezier> fit(const Stretches &stretches)
    {
        for (const Samples &line : stretches.lines)
            fit(line, 0, line.size() - 1);
        return m_chain;
    }

private:
    /// Area and moment about the start, chord from (0, 0) to (1, 0).
    static std::pair<double, double> areaAndMoment(const Samples &unitLine)
    {
        double area = 0.0, moment = 0.0;
        for (std::size_t i = 0; i + 1 < unitLine.size(); ++i) {
            const Vec2 &a = unitLine[i], &b = unitLine[i + 1];
            const double dx = b.x() - a.x();
            area += 0.5 * (a.y() + b.y()) * dx;
            moment += dx * (a.y() * (2.0 * a.x() + b.x()) + b.y() * (a.x() + 2.0 * b.x())) / 6.0;
        }
        return {area, moment};
    }

    void fit(const Samples &line, std::size_t from, std::size_t to)
    {
        const Vec2 p0 = line[from], p3 = line[to];
        const Vec2 out = directionAt(line, from, m_reach, from > 0, true);
        const Vec2 in = directionAt(line, to, m_reach, true, to + 1 < line.size());
        const Vec2 chord = p3 - p0;
        const double length = chord.norm();
        if (to - from == 1) {
            m_chain.push_back({p0, p0 + length / 3.0 * out, p3 - length / 3.0 * in, p3});
            return;
        }
        if (const auto curve = length > 0.0 ? best(line, from, to, out, in) : std::nullopt) {
            m_chain.push_back(*curve);
            return;
        }
        const std::size_t middle = (from + to) / 2;
        fit(line, from, middle);
        fit(line, middle, to);
    }

    std::optional<CubicBezier> best(const Samples &line, std::size_t from, std::size_t to,
                                    const Vec2 &out, const Vec2 &in) const
    {
        const Vec2 p0 = line[from], p3 = line[to];
        const Vec2 x = (p3 - p0) / (p3 - p0).squaredNorm(), y = perpendicular(x);
        Samples unit;
        for (std::size_t i = from; i <= to; ++i)
            unit.emplace_back(x.dot(line[i] - p0), y.dot(line[i] - p0));
        const auto unitMoments = areaAndMoment(unit);
        const double area = unitMoments.first, moment = unitMoments.second;
        const double length = (p3 - p0).norm();
        const Vec2 a(x.dot(out) * length, y.dot(out) * length);
        const Vec2 b(x.dot(in) * length, y.dot(in) * length);
        // For each length of the first handle the area gives the second: of those whose moment is
        // right, and beside them where it comes nearest, the one with the least error.
        const auto cubic = [&](double first, double second) {
            return CubicBezier{{0.0, 0.0}, first * a, Vec2(1.0, 0.0) - second * b, {1.0, 0.0}};
        };
        const auto areaOf = [&](const CubicBezier &s) {
            // ∫ y dx of a cubic from (0, 0) to (1, 0).
            return (6.0 * cross(s.p1, s.p0) + 3.0 * cross(s.p2, s.p0) + 3.0 * cross(s.p2, s.p1) +
                    3.0 * cross(s.p3, s.p1) + 6.0 * cross(s.p3, s.p2)) /
                   20.0;
        };
        const auto momentOf = [&](const CubicBezier &s) {
            double sum = 0.0;
            constexpr std::array<double, 3> nodes{0.0, 0.5384693101056831, 0.9061798459386640};
            constexpr std::array<double, 3> weights{0.5688888888888889, 0.4786286704993665,
                                                    0.2369268850561891};
            for (std::size_t k = 0; k < 3; ++k)
                for (const double sign : {1.0, -1.0}) {
                    const double t = 0.5 + 0.5 * sign * nodes[k];
                    const Vec2 p = s.at(t), d = s.derivative(t);
                    sum += (k == 0 ? 0.25 : 0.5) * weights[k] * p.x() * p.y() * d.x();
                }
            return sum;
        };
        std::optional<CubicBezier> found;
        double least = m_error;
        const auto second = [&](double first) -> std::optional<double> {
            // The area is linear in the second handle.
            const double at0 = areaOf(cubic(first, 0.0)), at1 = areaOf(cubic(first, 1.0));
            const double value = (area - at0) / (at1 - at0);
            if (!(value >= 0.0 && value < 2.0))
                return {};
            return value;
        };
        const auto consider = [&](double first) {
            const auto other = second(first);
            if (!other)
                return;
            const CubicBezier s = cubic(first, *other);
            const auto place = [&](const Vec2 &q) {
                return Vec2(p0 + q.x() * (p3 - p0) + q.y() * perpendicular(Vec2(p3 - p0)));
            };
            const CubicBezier curve{p0, place(s.p1), place(s.p2), p3};
            double error = 0.0;
            std::vector<double> u = chordParameters(line, from, to);
            for (int k = 0; k < 6; ++k)
                reparametrise(line, from, curve, u);
            error = largestError(line, from, curve, u).first;
            if (error <= least) {
                least = error;
                found = curve;
            }
        };
        constexpr int kSteps = 48;
        double before = std::numeric_limits<double>::quiet_NaN();
        for (int i = 1; i <= kSteps; ++i) {
            const double first = 1.2 * i / kSteps;
            const auto other = second(first);
            const double off = other ? momentOf(cubic(first, *other)) - moment
                                     : std::numeric_limits<double>::quiet_NaN();
            if (off * before <= 0.0) {
                double low = first - 1.2 / kSteps, high = first;
                for (int k = 0; k < 12; ++k) {
                    const double middle = 0.5 * (low + high);
                    const auto o = second(middle);
                    const double value = o ? momentOf(cubic(middle, *o)) - moment : off;
                    (value * before <= 0.0 ? high : low) = middle;
                }
                consider(0.5 * (low + high));
            }
            before = off;
        }
        if (!found)
            consider(1.0 / 3.0);
        return found;
    }

    double m_error, m_reach;
    std::vector<CubicBezier> m_chain;
};

} // namespace fff::test
