#include "core/geometry/sampled_line.h"

#include "core/base/tolerances.h"
#include "core/geometry/bezier.h"
#include "core/geometry/simplified_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

/// Reaches between samples that are left without further ones.
constexpr double kLongestGap = 2.0;
/// Of a tolerance, that the line on which distances are measured may be off the samples.
constexpr double kMeasuringError = 1.0;
/// Tolerances of the line that a sample stands for in any case, also where the hand halts.
constexpr double kLeastWeight = 1e-3;
/// Of a tolerance, that samples may be off the parabola that says where the line passes.
constexpr double kParabolaError = 0.7;
/// Tolerances that a joint may be off its sample.
constexpr double kJointOffset = 0.9;
/// Reaches over which the parabola is laid, from the least to the most.
constexpr std::array kParabolaReaches{1.0, 2.0, 3.0};
/// Samples that a parabola is laid through at most.
constexpr std::size_t kParabolaSamples = 48;

} // namespace

Vec2 SampledLine::unit(const Vec2 &way)
{
    const double length = way.norm();
    return length > 0.0 ? Vec2(way / length) : Vec2::Zero();
}

std::vector<Vec2> SampledLine::usable(const std::vector<Vec2> &samples)
{
    std::vector<Vec2> points;
    points.reserve(samples.size());
    for (const Vec2 &p : samples) {
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kMaxCoordinate)
            continue;
        if (points.empty() || (p - points.back()).norm() > kClipGrid)
            points.push_back(p);
    }
    return points;
}

SampledLine::SampledLine(const std::vector<Vec2> &samples, double tolerance, double reach)
    : m_tolerance(tolerance), m_reach(reach)
{
    fillGaps(usable(samples));
    if (m_points.size() < 2)
        return;
    measure();
    sum();
}

void SampledLine::fillGaps(const std::vector<Vec2> &drawn)
{
    m_points.reserve(drawn.size());
    m_drawn.reserve(drawn.size());
    for (const Vec2 &p : drawn) {
        if (!m_points.empty()) {
            const Vec2 from = m_points.back();
            const double pieces = std::min(std::ceil((p - from).norm() / (kLongestGap * m_reach)),
                                           double(CubicBezier::kMaxChords));
            for (double i = 1.0; i < pieces; ++i)
                m_points.push_back(from + (p - from) * (i / pieces));
        }
        m_drawn.push_back(m_points.size());
        m_points.push_back(p);
    }
}

std::size_t SampledLine::drawnBefore(std::size_t i) const
{
    const auto after = std::upper_bound(m_drawn.begin(), m_drawn.end(), i);
    return static_cast<std::size_t>(after - m_drawn.begin()) - 1;
}

void SampledLine::measure()
{
    m_vertices = simplified(m_points, kMeasuringError * m_tolerance);
    m_along.assign(m_points.size(), 0.0);
    for (std::size_t k = 0; k + 1 < m_vertices.size(); ++k) {
        const std::size_t from = m_vertices[k], to = m_vertices[k + 1];
        const Vec2 chord = m_points[to] - m_points[from];
        const double length = chord.norm();
        m_along[to] = m_along[from] + length;
        for (std::size_t i = from + 1; i < to; ++i) {
            // A hand that comes back to the very point has not got anywhere.
            const double foot =
                length > 0.0 ? chord.dot(m_points[i] - m_points[from]) / length : 0.0;
            m_along[i] = std::clamp(m_along[from] + foot, m_along[i - 1], m_along[to]);
        }
    }
    m_weight.resize(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i)
        m_weight[i] =
            kLeastWeight * m_tolerance +
            0.5 * (m_along[std::min(i + 1, m_points.size() - 1)] - m_along[i > 0 ? i - 1 : 0]);
}

void SampledLine::sum()
{
    m_sums.resize(m_points.size() + 1);
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const double w = m_weight[i], s = m_along[i];
        const Vec2 p = m_points[i] - m_points.front();
        Sums &next = m_sums[i + 1];
        next = m_sums[i];
        next.w += w;
        next.s += w * s;
        next.ss += w * s * s;
        next.p += w * p;
        next.sp += w * s * p;
    }
}

std::size_t SampledLine::indexAt(double along) const
{
    const auto at = std::lower_bound(m_along.begin(), m_along.end(), along);
    return std::min(static_cast<std::size_t>(at - m_along.begin()), size() - 1);
}

/// Of the straight line through the samples [from, to] by least squares.
Vec2 SampledLine::directionBetween(std::size_t from, std::size_t to) const
{
    const Sums &a = m_sums[from], &b = m_sums[to + 1];
    const double w = b.w - a.w, s = b.s - a.s;
    const double spread = (b.ss - a.ss) - s * s / w;
    const Vec2 slope = (b.sp - a.sp) - (s / w) * (b.p - a.p);
    if (to - from >= 2 && spread > 0.0 && slope.norm() > 0.0)
        return unit(slope);
    return unit(m_points[to] - m_points[from]);
}

/// Least squares over the samples [from, to], each counting for the line it stands for.
SampledLine::Parabola SampledLine::parabola(std::size_t at, std::size_t from, std::size_t to,
                                            bool isThroughPoint) const
{
    const std::size_t step = (to - from) / kParabolaSamples + 1;
    std::array<double, 5> m{}; // moments of s
    std::array<Vec2, 3> r{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    const Vec2 &base = m_points[at];
    const double scale = 1.0 / m_reach;
    for (std::size_t i = from; i <= to; i += step) {
        const double s = (m_along[i] - m_along[at]) * scale;
        const double w = m_weight[i];
        const Vec2 p = m_points[i] - base;
        double power = w;
        for (std::size_t k = 0; k < 5; ++k, power *= s) {
            m[k] += power;
            if (k < 3)
                r[k] += power * p;
        }
    }
    Parabola result;
    Vec2 bend = Vec2::Zero(), slope = Vec2::Zero(), offset = Vec2::Zero();
    // Two or three unknowns; a matrix without a parabola in it gives a straight line.
    const auto straight = [&] { slope = m[2] > 0.0 ? Vec2(r[1] / m[2]) : Vec2::Zero(); };
    if (isThroughPoint) {
        const double determinant = m[2] * m[4] - m[3] * m[3];
        if (determinant > kSingular * m[2] * m[4]) {
            slope = (m[4] * r[1] - m[3] * r[2]) / determinant;
            bend = (m[2] * r[2] - m[3] * r[1]) / determinant;
        } else {
            straight();
        }
    } else {
        Eigen::Matrix3d matrix;
        matrix << m[0], m[1], m[2], m[1], m[2], m[3], m[2], m[3], m[4];
        const double determinant = matrix.determinant();
        if (determinant > kSingular * m[0] * m[2] * m[4]) {
            Eigen::Matrix<double, 3, 2> right;
            right << r[0].transpose(), r[1].transpose(), r[2].transpose();
            const Eigen::Matrix<double, 3, 2> x = matrix.inverse() * right;
            offset = x.row(0).transpose();
            slope = x.row(1).transpose();
            bend = x.row(2).transpose();
        } else {
            straight();
        }
    }
    result.position = base + offset;
    result.slope = slope;
    result.bend = bend;
    for (std::size_t i = from; i <= to; i += step) {
        const double s = (m_along[i] - m_along[at]) * scale;
        const Vec2 off = offset + s * slope + s * s * bend - (m_points[i] - base);
        result.largestError = std::max(result.largestError, off.squaredNorm());
    }
    result.largestError = std::sqrt(result.largestError);
    return result;
}

CurveEnd SampledLine::joint(std::size_t at, std::size_t from, std::size_t to, bool isEnd) const
{
    CurveEnd result{m_points[at], unit(m_points[to] - m_points[from])};
    for (std::size_t k = 0; k < kParabolaReaches.size(); ++k) {
        const double reach = kParabolaReaches[k] * m_reach;
        const std::size_t first = std::max(indexAt(m_along[at] - reach), from);
        std::size_t last = std::min(indexAt(m_along[at] + reach), to);
        if (last > at && m_along[last] > m_along[at] + reach)
            --last;
        last = std::max(last, std::min(at + 1, to));
        const Parabola fit = parabola(at, std::min(first, at > from ? at - 1 : from), last, isEnd);
        const Vec2 direction = unit(fit.slope);
        if (k > 0 && fit.largestError > kParabolaError * m_tolerance)
            break;
        if (direction.isZero())
            continue;
        result.direction = direction;
        const Vec2 off = fit.position - m_points[at];
        const double limit = kJointOffset * m_tolerance;
        if (!isEnd)
            result.position =
                m_points[at] + off * std::min(1.0, limit / std::max(off.norm(), limit));
    }
    if (result.direction.isZero())
        result.direction = Vec2::UnitX();
    return result;
}

CurveEnd SampledLine::smoothJoint(std::size_t at, std::size_t from, std::size_t to) const
{
    return joint(at, from, to, false);
}

CurveEnd SampledLine::startJoint(std::size_t from, std::size_t to) const
{
    return joint(from, from, to, true);
}

CurveEnd SampledLine::endJoint(std::size_t from, std::size_t to) const
{
    return joint(to, from, to, true);
}

} // namespace fff
