#include "core/geometry/sampled_line.h"

#include "core/base/tolerances.h"
#include "core/geometry/bezier.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

/// Reaches between samples that are left without further ones.
constexpr double kLongestGap = 2.0;
/// Of a tolerance, that the line on which distances are measured may be off the samples.
constexpr double kMeasuringError = 1.0;
/// Reaches over which a corner is judged.
constexpr double kCornerReach = 1.5;
/// Of a corner's turn, what has to be seen over half the reach as well: of a bend it is half.
constexpr double kConcentration = 0.65;
/// Of the angle that makes a corner, what the curves that meet there have to turn by themselves.
constexpr double kSharpness = 0.6;
/// Of a tolerance, that samples may be off the parabola that says where the line passes.
constexpr double kParabolaError = 0.7;
/// Reaches over which the parabola is laid, from the least to the most.
constexpr std::array kParabolaReaches{1.0, 2.0, 3.0};
/// Samples that a parabola is laid through at most.
constexpr std::size_t kParabolaSamples = 48;

double turn(const Vec2 &a, const Vec2 &b)
{
    return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

Vec2 unit(const Vec2 &way)
{
    const double length = way.norm();
    return length > 0.0 ? Vec2(way / length) : Vec2::Zero();
}

/// Indices of the samples that a simplified line goes through: every sample in between is within
/// `error` of the chord, as long as the line does not go back by more than twice that.
/// Source  J. Sklansky, V. Gonzalez 1980, Fast polygonal approximation of digitized curves: the
///         chord's direction has to lie in the cone that each sample's disc leaves. O(n).
std::vector<std::size_t> simplified(const std::vector<Vec2> &points, double error)
{
    std::vector<std::size_t> vertices{0};
    std::size_t anchor = 0;
    while (anchor + 1 < points.size()) {
        Vec2 left = Vec2::Zero(), right = Vec2::Zero(); // borders of the cone, once there is one
        bool hasCone = false;
        double furthest = 0.0;
        std::size_t best = anchor + 1, furthestAt = anchor + 1;
        std::size_t i = anchor + 1;
        for (; i < points.size(); ++i) {
            const Vec2 way = points[i] - points[anchor];
            const double distance = way.norm();
            if (distance > furthest) {
                furthest = distance;
                furthestAt = i;
            } else if (distance < furthest - 2.0 * error) {
                best = furthestAt; // it goes back
                break;
            }
            if (hasCone && (cross(right, way) < 0.0 || cross(way, left) < 0.0))
                break;
            best = i;
            if (distance <= error)
                continue;
            const double sine = error / distance, cosine = std::sqrt(1.0 - sine * sine);
            const Vec2 across = perpendicular(way);
            const Vec2 l = cosine * way + sine * across, r = cosine * way - sine * across;
            if (!hasCone || cross(l, left) > 0.0)
                left = l;
            if (!hasCone || cross(right, r) > 0.0)
                right = r;
            hasCone = true;
        }
        if (i == points.size())
            best = points.size() - 1;
        anchor = best;
        vertices.push_back(anchor);
    }
    return vertices;
}

} // namespace

std::vector<Vec2> SampledLine::usable(const std::vector<Vec2> &samples, double reach)
{
    const double longestGap = kLongestGap * reach;
    std::vector<Vec2> points;
    points.reserve(samples.size());
    for (const Vec2 &p : samples) {
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kMaxCoordinate)
            continue;
        if (!points.empty()) {
            const Vec2 from = points.back();
            const double gap = (p - from).norm();
            if (gap <= kClipGrid)
                continue;
            const double pieces =
                std::min(std::ceil(gap / longestGap), double(CubicBezier::kMaxChords));
            for (double i = 1.0; i < pieces; ++i)
                points.push_back(from + (p - from) * (i / pieces));
        }
        points.push_back(p);
    }
    return points;
}

SampledLine::SampledLine(const std::vector<Vec2> &samples, double tolerance, double reach)
    : m_tolerance(tolerance), m_reach(reach), m_points(usable(samples, reach))
{
    if (m_points.size() < 2)
        return;
    measure();
    sum();
}

void SampledLine::measure()
{
    const std::vector<std::size_t> vertices = simplified(m_points, kMeasuringError * m_tolerance);
    m_along.assign(m_points.size(), 0.0);
    for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
        const std::size_t from = vertices[k], to = vertices[k + 1];
        const Vec2 chord = m_points[to] - m_points[from];
        const double length = chord.norm();
        m_along[to] = m_along[from] + length;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double foot = chord.dot(m_points[i] - m_points[from]) / length;
            m_along[i] = std::clamp(m_along[from] + foot, m_along[i - 1], m_along[to]);
        }
    }
    m_weight.resize(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i)
        m_weight[i] =
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

double SampledLine::turnAt(std::size_t at, double reach) const
{
    const std::size_t from = std::min(indexAt(m_along[at] - reach), at > 0 ? at - 1 : 0);
    const std::size_t to = std::max(indexAt(m_along[at] + reach), std::min(at + 1, size() - 1));
    return turn(directionBetween(from, at), directionBetween(at, to));
}

/// The sample near `at` that stands out most from the chord over the reach.
std::size_t SampledLine::sharpest(std::size_t at, double reach) const
{
    const std::size_t from = indexAt(m_along[at] - reach), to = indexAt(m_along[at] + reach);
    const Vec2 chord = unit(m_points[to] - m_points[from]);
    const std::size_t first = indexAt(m_along[at] - 0.5 * reach);
    const std::size_t last = indexAt(m_along[at] + 0.5 * reach);
    const auto distance = [&](std::size_t i) {
        const Vec2 off = m_points[i] - m_points[from];
        return chord.isZero() ? off.norm() : std::abs(cross(chord, off));
    };
    std::size_t best = at;
    for (std::size_t i = std::max<std::size_t>(first, 1); i <= std::min(last, size() - 2); ++i) {
        if (distance(i) > distance(best))
            best = i;
    }
    return best;
}

std::vector<std::size_t> SampledLine::corners(double angle) const
{
    std::vector<std::size_t> result;
    const double reach = kCornerReach * m_reach;
    // So near to an end there is too little line to tell a corner from a shaky hand.
    const double least = 0.5 * m_reach;
    std::size_t best = 0; // of a reach; 0 for none
    double bestTurn = 0.0;
    const auto settle = [&] {
        if (best == 0)
            return;
        const std::size_t corner = sharpest(best, m_reach);
        if ((result.empty() || m_along[corner] > m_along[result.back()]) &&
            turnAt(corner, 0.5 * reach) >= kConcentration * bestTurn)
            result.push_back(corner);
        best = 0;
    };
    for (std::size_t i = 1; i + 1 < size(); ++i) {
        if (best > 0 && lengthBetween(best, i) > m_reach)
            settle();
        if (m_along[i] < least || length() - m_along[i] < least)
            continue;
        const double here = turnAt(i, reach);
        if (here > angle && (best == 0 || here > bestTurn)) {
            best = i;
            bestTurn = here;
        }
    }
    settle();
    // Bends look like corners from afar: what two parabolas that end there say is nearer.
    const std::vector<std::size_t> found = result;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const std::size_t from = kept > 0 ? result[kept - 1] : 0;
        const std::size_t to = k + 1 < found.size() ? found[k + 1] : size() - 1;
        const Joint before = endJoint(from, found[k]), after = startJoint(found[k], to);
        if (turn(before.direction, after.direction) >= kSharpness * angle)
            result[kept++] = found[k];
    }
    result.resize(kept);
    return result;
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
        const double w = m_weight[i] + 1e-3 * m_tolerance;
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
        if (determinant > 1e-9 * m[2] * m[4]) {
            slope = (m[4] * r[1] - m[3] * r[2]) / determinant;
            bend = (m[2] * r[2] - m[3] * r[1]) / determinant;
        } else {
            straight();
        }
    } else {
        Eigen::Matrix3d matrix;
        matrix << m[0], m[1], m[2], m[1], m[2], m[3], m[2], m[3], m[4];
        const double determinant = matrix.determinant();
        if (determinant > 1e-9 * m[0] * m[2] * m[4]) {
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
    for (std::size_t i = from; i <= to; i += step) {
        const double s = (m_along[i] - m_along[at]) * scale;
        const Vec2 off = offset + s * slope + s * s * bend - (m_points[i] - base);
        result.largestError = std::max(result.largestError, off.squaredNorm());
    }
    result.largestError = std::sqrt(result.largestError);
    return result;
}

Joint SampledLine::joint(std::size_t at, std::size_t from, std::size_t to, bool isEnd) const
{
    Joint result{m_points[at], unit(m_points[to] - m_points[from])};
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
        if (!isEnd && (fit.position - m_points[at]).norm() <= kParabolaError * m_tolerance)
            result.position = fit.position;
        else
            result.position = m_points[at];
    }
    if (result.direction.isZero())
        result.direction = Vec2::UnitX();
    return result;
}

Joint SampledLine::smoothJoint(std::size_t at, std::size_t from, std::size_t to) const
{
    return joint(at, from, to, false);
}

Joint SampledLine::startJoint(std::size_t from, std::size_t to) const
{
    return joint(from, from, to, true);
}

Joint SampledLine::endJoint(std::size_t from, std::size_t to) const
{
    return joint(to, from, to, true);
}

bool SampledLine::isStraight(std::size_t from, std::size_t to, double tolerance) const
{
    const Vec2 chord = m_points[to] - m_points[from];
    const double length = chord.norm();
    if (length <= kClipGrid)
        return false;
    const Vec2 way = chord / length;
    double furthest = 0.0;
    for (std::size_t i = from + 1; i < to; ++i) {
        const Vec2 off = m_points[i] - m_points[from];
        const double along = way.dot(off);
        furthest = std::max(furthest, along);
        const Vec2 foot = std::clamp(along, 0.0, length) * way;
        if ((off - foot).norm() > tolerance || along < furthest - tolerance)
            return false;
    }
    return true;
}

} // namespace fff
