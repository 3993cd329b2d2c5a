#include "core/skin/skin_curve.h"
#include "core/skin/skin_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// Share of a curve whose chord is its direction at the end.
constexpr double kEndShare = 0.08;

/// The chord in which a share lies, and where in it.
struct Place
{
    std::size_t chord = 0;
    double share = 0.0;
};

Place placeOn(const std::vector<double> &at, double share)
{
    const auto after = std::upper_bound(at.begin() + 1, at.end() - 1, share);
    const auto chord = static_cast<std::size_t>(after - at.begin()) - 1;
    const double span = at[chord + 1] - at[chord];
    return {chord, span > 0.0 ? std::clamp((share - at[chord]) / span, 0.0, 1.0) : 0.0};
}

} // namespace

double SkinCurve::length() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        sum += (points[i + 1] - points[i]).norm();
    return sum;
}

Vec3 SkinCurve::pointAt(double share) const
{
    if (isPoint())
        return points.front();
    const Place p = placeOn(at, share);
    return points[p.chord] + p.share * (points[p.chord + 1] - points[p.chord]);
}

Vec3 SkinCurve::normalAt(double share) const
{
    if (isPoint())
        return normals.front();
    const Place p = placeOn(at, share);
    const Vec3 mixed = (1.0 - p.share) * normals[p.chord] + p.share * normals[p.chord + 1];
    return mixed.norm() > kSkinNoNormal ? mixed.normalized() : normals[p.chord];
}

Vec3 SkinCurve::startDirection() const
{
    return (pointAt(kEndShare) - points.front()).normalized();
}

SkinCurve SkinCurve::reversed() const
{
    SkinCurve other = *this;
    std::reverse(other.vertices.begin(), other.vertices.end());
    std::reverse(other.points.begin(), other.points.end());
    std::reverse(other.normals.begin(), other.normals.end());
    std::reverse(other.outwards.begin(), other.outwards.end());
    std::reverse(other.at.begin(), other.at.end());
    for (double &share : other.at)
        share = 1.0 - share;
    return other;
}

SkinCurve SkinCurve::part(std::size_t first, std::size_t last) const
{
    const auto cut = [&](const auto &list) {
        const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
        return std::decay_t<decltype(list)>(begin,
                                            begin + static_cast<std::ptrdiff_t>(last - first + 1));
    };
    SkinCurve piece{cut(vertices), cut(points), cut(normals), {}, {}};
    measure(piece);
    return piece;
}

std::size_t SkinCurve::middle() const
{
    const auto nearest = std::min_element(at.begin() + 1, at.end() - 1, [](double a, double b) {
        return std::abs(a - 0.5) < std::abs(b - 0.5);
    });
    return static_cast<std::size_t>(nearest - at.begin());
}

void measure(SkinCurve &curve)
{
    curve.at = {0.0};
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
        curve.at.push_back(curve.at.back() + (curve.points[i + 1] - curve.points[i]).norm());
    const double length = curve.at.back();
    for (double &share : curve.at)
        share = length > 0.0 ? share / length : 0.0;
    if (curve.at.size() > 1)
        curve.at.back() = 1.0;
}

/// An arc of angle a over a chord c has the Bézier handle c / (3 cos² (a / 4)); a Hermite
/// derivative is three of these. Beyond a half circle it stays as it is there.
double arcSpeed(double angle)
{
    const double quarter = std::cos(0.25 * std::min(std::abs(angle), std::numbers::pi));
    return 1.0 / (quarter * quarter);
}

SkinCurve bridge(GrowingMesh &mesh, std::uint32_t from, const Vec3 &startWay,
                 const Vec3 &startNormal, std::uint32_t to, const Vec3 &endWay,
                 const Vec3 &endNormal, int chords)
{
    const Vec3 a = mesh.points[from], b = mesh.points[to];
    const double angle = std::acos(std::clamp(startWay.dot(endWay), -1.0, 1.0));
    const double speed = arcSpeed(angle) * (b - a).norm();
    SkinCurve curve;
    for (int i = 0; i <= chords; ++i) {
        const double t = static_cast<double>(i) / chords, s = 1.0 - t;
        const Vec3 point = s * s * (1.0 + 2.0 * t) * a + t * t * (3.0 - 2.0 * t) * b +
                           speed * (t * s * s * startWay - t * t * s * endWay);
        curve.points.push_back(i == 0 ? a : i == chords ? b : point);
        curve.vertices.push_back(i == 0 ? from : i == chords ? to : mesh.add(point));
        const Vec3 mixed = s * startNormal + t * endNormal;
        curve.normals.push_back(mixed.norm() > kSkinNoNormal ? mixed.normalized() : startNormal);
    }
    measure(curve);
    return curve;
}

} // namespace fff
