// Points taken out of a contour: what was between their neighbours becomes one segment.
#include "core/geometry/contour_points.h"

#include <algorithm>
#include <optional>

namespace fff {

namespace {

using Chain = std::vector<CubicBezier>;

constexpr int kSamples = 16; // a segment
// Handles, in lengths of what is replaced.
constexpr double kShortest = 0.01, kLongest = 2.0;
constexpr int kImprovements = 8; // of the parameters; each brings the curve nearer to the samples

Vec2 directionFrom(const CubicBezier &s)
{
    for (const Vec2 &p : {s.p1, s.p2, s.p3})
        if ((p - s.p0).norm() > kNoHandle)
            return (p - s.p0).normalized();
    return Vec2::Zero();
}

/// How long each segment is in the parameter of the whole, if the chain was one curve that points
/// were put into: handles at a joint are as these lengths. None where a handle is missing.
std::optional<std::vector<double>> sharesByHandles(const Chain &chain)
{
    std::vector<double> shares{1.0};
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const double in = (chain[i - 1].p3 - chain[i - 1].p2).norm();
        const double out = (chain[i].p1 - chain[i].p0).norm();
        if (in <= kNoHandle || out <= kNoHandle)
            return std::nullopt;
        shares.push_back(shares.back() * out / in);
    }
    return shares;
}

double lengthOf(const CubicBezier &s)
{
    double length = 0.0;
    for (int k = 0; k < kSamples; ++k)
        length += (s.at((k + 1.0) / kSamples) - s.at(static_cast<double>(k) / kSamples)).norm();
    return length;
}

struct Samples
{
    std::vector<Vec2> points; // n, without the ends
    std::vector<double> at;   // n parameters
};

Samples sampled(const Chain &chain, const std::vector<double> &shares)
{
    double whole = 0.0;
    for (const double share : shares)
        whole += share;
    Samples samples;
    double start = 0.0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        for (int k = i == 0 ? 1 : 0; k < kSamples; ++k) {
            const double t = static_cast<double>(k) / kSamples;
            samples.points.push_back(chain[i].at(t));
            samples.at.push_back((start + t * shares[i]) / whole);
        }
        start += shares[i];
    }
    return samples;
}

/// Where one segment shall start and end, and how.
struct Ends
{
    Vec2 from, to;
    Vec2 tangent, endTangent; // unit, both to the inside
    double least, leastLast;  // lengths of the handles, mm
};

/// Handle lengths by least squares (Schneider, page 620); nothing where there are none.
std::optional<CubicBezier> fitted(const Samples &samples, const Ends &ends)
{
    const auto &[from, to, tangent, endTangent, least, leastLast] = ends;
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0;
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
        const double t = samples.at[i], s = 1.0 - t;
        const double b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t;
        const Vec2 a0 = b1 * tangent, a1 = b2 * endTangent;
        const Vec2 rest = samples.points[i] - (s * s * s + b1) * from - (t * t * t + b2) * to;
        c00 += a0.dot(a0);
        c01 += a0.dot(a1);
        c11 += a1.dot(a1);
        x0 += a0.dot(rest);
        x1 += a1.dot(rest);
    }
    constexpr double kSingular = 1e-12; // of the diagonal's product
    const double determinant = c00 * c11 - c01 * c01;
    if (!(determinant > kSingular * c00 * c11))
        return std::nullopt;
    double first = (x0 * c11 - x1 * c01) / determinant;
    double last = (c00 * x1 - c01 * x0) / determinant;
    // One that would be too short, or look the other way, is as short as may be, and the other one
    // makes the best of it.
    if (first < least) {
        first = least;
        last = (x1 - c01 * first) / c11;
    } else if (last < leastLast) {
        last = leastLast;
        first = (x0 - c01 * last) / c00;
    }
    if (first < least || last < leastLast)
        return std::nullopt;
    return CubicBezier{from, from + first * tangent, to + last * endTangent, to};
}

/// One step of Newton's towards the nearest place, for every sample.
void improve(const CubicBezier &curve, Samples &samples)
{
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
        const double t = samples.at[i];
        const Vec2 off = curve.at(t) - samples.points[i];
        const Vec2 first = curve.derivative(t), second = curve.secondDerivative(t);
        const double slope = first.dot(first) + off.dot(second);
        if (slope > 0.0)
            samples.at[i] = std::clamp(t - off.dot(first) / slope, 0.0, 1.0);
    }
}

double errorOf(const CubicBezier &curve, const Samples &samples)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < samples.points.size(); ++i)
        worst = std::max(worst, (curve.at(samples.at[i]) - samples.points[i]).norm());
    return worst;
}

CubicBezier oneFor(const Chain &chain)
{
    if (std::all_of(chain.begin(), chain.end(), isLine))
        return CubicBezier::line(chain.front().p0, chain.back().p3);
    std::vector<double> lengths;
    double whole = 0.0;
    for (const CubicBezier &segment : chain) {
        lengths.push_back(lengthOf(segment));
        whole += lengths.back();
    }
    // A handle that is there stays one, or a smooth neighbour would become a corner.
    const auto least = [&](const CubicBezier &s) {
        return (s.p1 - s.p0).norm() > kNoHandle ? kShortest * whole : 0.0;
    };
    const CubicBezier last = chain.back().reversed();
    const Ends ends{
        chain.front().p0,     last.p0,    directionFrom(chain.front()), directionFrom(last),
        least(chain.front()), least(last)};
    // Where no fit is any good: handles of a third of the way, as for a flat curve.
    const double third = whole / 3.0;
    CubicBezier best{ends.from, ends.from + third * ends.tangent, ends.to + third * ends.endTangent,
                     ends.to};
    double bestError = std::numeric_limits<double>::infinity();
    const auto attempt = [&](const std::vector<double> &shares) {
        Samples samples = sampled(chain, shares);
        for (int i = 0; i < kImprovements; ++i) {
            const auto curve = fitted(samples, ends);
            if (!curve || (curve->p1 - ends.from).norm() > kLongest * whole ||
                (curve->p2 - ends.to).norm() > kLongest * whole)
                return;
            if (const double error = errorOf(*curve, samples); error < bestError) {
                bestError = error;
                best = *curve;
            }
            improve(*curve, samples);
        }
    };
    if (const auto shares = sharesByHandles(chain))
        attempt(*shares);
    attempt(lengths);
    return best;
}

} // namespace

Result<Contour> withoutPoints(const Contour &contour, std::span<const int> indices)
{
    std::vector<int> kept;
    for (int i = 0; i < contour.segmentCount(); ++i)
        if (std::find(indices.begin(), indices.end(), i) == indices.end())
            kept.push_back(i);
    if (static_cast<int>(kept.size()) < kFewestSegments)
        return failure(ErrorCode::TooFewPoints);
    std::vector<CubicBezier> segments;
    segments.reserve(kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const int end = k + 1 < kept.size() ? kept[k + 1] : kept.front() + contour.segmentCount();
        Chain chain;
        for (int i = kept[k]; i < end; ++i)
            chain.push_back(contour.segment(i % contour.segmentCount()));
        segments.push_back(chain.size() == 1 ? chain.front() : oneFor(chain));
    }
    return Contour::fromSegments(segments);
}

} // namespace fff
