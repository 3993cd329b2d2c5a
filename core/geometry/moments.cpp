#include "core/geometry/moments.h"

#include <array>

namespace fff {

namespace {
// Gauss-Legendre, 6 points on [0,1]: exact to degree 11, which is that of x²y·x' of a cubic.
constexpr std::array<double, 6> kNodes = {0.033765242898423975, 0.16939530676686776,
                                          0.38069040695840156,  0.61930959304159844,
                                          0.83060469323313224,  0.96623475710157603};
constexpr std::array<double, 6> kWeights = {0.085662246189585178, 0.18038078652406930,
                                            0.23395696728634552,  0.23395696728634552,
                                            0.18038078652406930,  0.085662246189585178};

/// Handles that are off the thirds of the chord by no more than this share of it are rounding.
constexpr double kLineRounding = 1e-14;

/// Evenly along its chord: then the integrals are short.
bool isEvenLine(const CubicBezier &curve)
{
    const Vec2 chord = curve.p3 - curve.p0;
    const double slack = kLineRounding * (chord.cwiseAbs().sum() + curve.p0.cwiseAbs().sum());
    return (3.0 * (curve.p1 - curve.p0) - chord).cwiseAbs().maxCoeff() <= slack &&
           (3.0 * (curve.p3 - curve.p2) - chord).cwiseAbs().maxCoeff() <= slack;
}

/// What one point of the rule adds: at `p`, where the curve moves by `d`.
void add(const Vec2 &p, const Vec2 &d, double w, Moments &m)
{
    m.area += w * 0.5 * (p.x() * d.y() - p.y() * d.x());
    m.first.x() += w * 0.5 * p.x() * p.x() * d.y();
    m.first.y() -= w * 0.5 * p.y() * p.y() * d.x();
    m.xx += w * p.x() * p.x() * p.x() * d.y() / 3.0;
    m.yy -= w * p.y() * p.y() * p.y() * d.x() / 3.0;
    m.xy += w * 0.5 * p.x() * p.x() * p.y() * d.y();
}

/// What a line from a to b adds: the same integrals, in closed form.
void addLine(const Vec2 &a, const Vec2 &b, Moments &m)
{
    const Vec2 d = b - a, aa = a.cwiseProduct(a), ab = a.cwiseProduct(b), bb = b.cwiseProduct(b);
    m.area += 0.5 * cross(a, b);
    m.first.x() += d.y() * (aa.x() + ab.x() + bb.x()) / 6.0;
    m.first.y() -= d.x() * (aa.y() + ab.y() + bb.y()) / 6.0;
    m.xx += d.y() * (a.x() + b.x()) * (aa.x() + bb.x()) / 12.0;
    m.yy -= d.x() * (a.y() + b.y()) * (aa.y() + bb.y()) / 12.0;
    m.xy += d.y() *
            (a.y() * (3.0 * aa.x() + 2.0 * ab.x() + bb.x()) +
             b.y() * (aa.x() + 2.0 * ab.x() + 3.0 * bb.x())) /
            24.0;
}
} // namespace

Moments &Moments::operator+=(const Moments &other)
{
    area += other.area;
    first += other.first;
    xx += other.xx;
    xy += other.xy;
    yy += other.yy;
    return *this;
}

Moments moments(const Contour &contour)
{
    Moments m;
    if (contour.segmentCount() == 0)
        return m;
    // About the first point, so that a small contour far from the origin loses no digits.
    const Vec2 base = contour.points().front();
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        if (isEvenLine(curve)) {
            addLine(curve.p0 - base, curve.p3 - base, m);
            continue;
        }
        for (std::size_t k = 0; k < kNodes.size(); ++k)
            add(curve.at(kNodes[k]) - base, curve.derivative(kNodes[k]), kWeights[k], m);
    }
    Moments shifted = m;
    shifted.first = m.first + m.area * base;
    shifted.xx = m.xx + 2.0 * base.x() * m.first.x() + m.area * base.x() * base.x();
    shifted.yy = m.yy + 2.0 * base.y() * m.first.y() + m.area * base.y() * base.y();
    shifted.xy =
        m.xy + base.x() * m.first.y() + base.y() * m.first.x() + m.area * base.x() * base.y();
    return shifted;
}

} // namespace fff
