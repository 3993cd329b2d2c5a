#include "core/geometry/arc_length.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

/// How far two estimates of a piece may differ, as a share of its length.
constexpr double kLengthShare = 1e-11;
constexpr int kMostHalvings = 24; // of a piece: a cusp is never met exactly

/// ∫ |derivative| from t0 to t1 with seven points.
double gaussLength(const CubicBezier &curve, double t0, double t1)
{
    // Abscissae and weights on [−1, 1]; M. Abramowitz, I. Stegun 1964, table 25.4.
    constexpr std::array<std::pair<double, double>, 4> kRule{
        {{0.0, 0.417959183673469},
         {0.405845151377397, 0.381830050505119},
         {0.741531185599394, 0.279705391489277},
         {0.949107912342759, 0.129484966168870}}};
    const double middle = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
    double sum = kRule[0].second * curve.derivative(middle).norm();
    for (std::size_t i = 1; i < kRule.size(); ++i) {
        const auto &[place, weight] = kRule[i];
        sum += weight * (curve.derivative(middle - half * place).norm() +
                         curve.derivative(middle + half * place).norm());
    }
    return half * sum;
}

double pieceLength(const CubicBezier &curve, double t0, double t1, double whole, int depth)
{
    const double middle = 0.5 * (t0 + t1);
    const double left = gaussLength(curve, t0, middle), right = gaussLength(curve, middle, t1);
    if (depth >= kMostHalvings || std::abs(left + right - whole) <= kLengthShare * (left + right))
        return left + right;
    return pieceLength(curve, t0, middle, left, depth + 1) +
           pieceLength(curve, middle, t1, right, depth + 1);
}

double lengthTo(const CubicBezier &curve, double t)
{
    return t <= 0.0 ? 0.0 : pieceLength(curve, 0.0, t, gaussLength(curve, 0.0, t), 0);
}

/// The parameter after so much of the curve, of which `total` is all: Newton's steps, kept between
/// bounds that close in.
double parameterAfter(const CubicBezier &curve, double length, double total)
{
    constexpr int kMostSteps = 60;
    double low = 0.0, high = 1.0;
    double t = total > 0.0 ? std::clamp(length / total, 0.0, 1.0) : 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
        const double off = lengthTo(curve, t) - length;
        if (std::abs(off) <= kLengthShare * std::max(total, 1.0))
            break;
        (off > 0.0 ? high : low) = t;
        const double speed = curve.derivative(t).norm();
        const double next = speed > 0.0 ? t - off / speed : low;
        t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
}

} // namespace

ArcLength::ArcLength(Contour contour) : m_contour(std::move(contour))
{
    m_starts.push_back(0.0);
    for (int i = 0; i < m_contour.segmentCount(); ++i) {
        m_lengths.push_back(lengthTo(m_contour.segment(i), 1.0));
        m_starts.push_back(m_starts.back() + m_lengths.back());
    }
}

double ArcLength::of(const CurvePoint &place) const
{
    return m_starts[static_cast<std::size_t>(place.segment)] +
           lengthTo(m_contour.segment(place.segment), place.t);
}

CurvePoint ArcLength::at(double length) const
{
    if (!(total() > 0.0))
        return {};
    double rest = std::fmod(length, total());
    if (rest < 0.0)
        rest += total();
    const auto next = std::upper_bound(m_starts.begin() + 1, m_starts.end() - 1, rest);
    const auto segment = static_cast<std::size_t>(next - m_starts.begin()) - 1;
    const double own = m_starts[segment + 1] - m_starts[segment];
    const int index = static_cast<int>(segment);
    return {index, parameterAfter(m_contour.segment(index), rest - m_starts[segment], own)};
}

CurvePoint ArcLength::after(const CurvePoint &from, double length) const
{
    if (!(total() > 0.0))
        return from;
    const auto count = m_lengths.size();
    auto segment = static_cast<std::size_t>(from.segment);
    // From the segment's start.
    double rest = lengthTo(m_contour.segment(from.segment), from.t) + std::fmod(length, total());
    while (rest < 0.0) {
        segment = (segment + count - 1) % count;
        rest += m_lengths[segment];
    }
    while (rest >= m_lengths[segment]) {
        rest -= m_lengths[segment];
        segment = (segment + 1) % count;
    }
    const int index = static_cast<int>(segment);
    return {index, parameterAfter(m_contour.segment(index), rest, m_lengths[segment])};
}

Vec2 positionAt(const Contour &contour, const CurvePoint &place)
{
    return contour.segment(place.segment).at(place.t);
}

Vec2 directionAt(const Contour &contour, const CurvePoint &place)
{
    const int count = contour.segmentCount();
    // The end of a segment is the start of the next one.
    CurvePoint here = place.t >= 1.0 ? CurvePoint{(place.segment + 1) % count, 0.0} : place;
    for (int step = 0; step < count; ++step) {
        const CubicBezier curve = contour.segment(here.segment);
        const Vec2 derivative = curve.derivative(here.t);
        if (derivative.norm() > 0.0)
            return derivative.normalized();
        const CubicBezier ahead = curve.piece(here.t, 1.0);
        for (const Vec2 &to : {ahead.p2, ahead.p3})
            if (const Vec2 way = to - ahead.p0; way.norm() > 0.0)
                return way.normalized();
        here = {(here.segment + 1) % count, 0.0}; // a segment that is a point
    }
    return Vec2::UnitX();
}

} // namespace fff
