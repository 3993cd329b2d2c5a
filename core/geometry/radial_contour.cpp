#include "core/geometry/radial_contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// An arc of more is made of several cubics.
constexpr double kMostOfOneArc = 0.5 * std::numbers::pi + 1e-9;

Vec2 at(const Vec2 &centre, double radius, double angle)
{
    return centre + radius * Vec2(std::cos(angle), std::sin(angle));
}

/// Counter-clockwise, to − from above 0.
void appendArc(std::vector<CubicBezier> &chain, const Vec2 &centre, double radius, double from,
               double to)
{
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / kMostOfOneArc)));
    const double step = (to - from) / pieces;
    const double handle = 4.0 / 3.0 * std::tan(0.25 * step) * radius;
    for (int i = 0; i < pieces; ++i) {
        const double a = from + i * step, b = a + step;
        const Vec2 p = at(centre, radius, a), q = at(centre, radius, b);
        chain.push_back({p, p + handle * Vec2(-std::sin(a), std::cos(a)),
                         q - handle * Vec2(-std::sin(b), std::cos(b)), q});
    }
}

Contour closed(std::vector<CubicBezier> chain)
{
    return Contour::ofSegments(chain);
}

} // namespace

Contour circleContour(const Vec2 &centre, double radius)
{
    std::vector<CubicBezier> chain;
    appendArc(chain, centre, radius, 0.0, kTurn);
    return closed(std::move(chain));
}

Contour starContour(const Vec2 &centre, double outer, double inner, int count, double phase)
{
    Polygon polygon;
    const double half = 0.5 * kTurn / count;
    for (int i = 0; i < count; ++i) {
        polygon.push_back(at(centre, outer, phase + 2 * i * half));
        polygon.push_back(at(centre, inner, phase + (2 * i + 1) * half));
    }
    return Contour::ofPolygon(polygon);
}

Contour gearContour(const Vec2 &centre, double outer, double inner, int count, double phase,
                    ToothShape tooth)
{
    const double sector = kTurn / count;
    std::vector<CubicBezier> chain;
    if (tooth == ToothShape::Round) {
        // From top to gap and back, handles along the circles.
        for (int i = 0; i < 2 * count; ++i) {
            const double a = phase + 0.5 * i * sector, b = a + 0.5 * sector;
            const double ra = i % 2 == 0 ? outer : inner, rb = i % 2 == 0 ? inner : outer;
            const double reach = 0.5 * std::tan(0.5 * sector);
            const Vec2 p = at(centre, ra, a), q = at(centre, rb, b);
            chain.push_back({p, p + reach * ra * Vec2(-std::sin(a), std::cos(a)),
                             q - reach * rb * Vec2(-std::sin(b), std::cos(b)), q});
        }
        return closed(std::move(chain));
    }
    const double top = (tooth == ToothShape::Square ? 0.25 : 1.0 / 6.0) * sector;  // half of it
    const double foot = (tooth == ToothShape::Square ? 0.25 : 1.0 / 3.0) * sector; // likewise
    for (int i = 0; i < count; ++i) {
        const double middle = phase + i * sector;
        appendArc(chain, centre, outer, middle - top, middle + top);
        chain.push_back(CubicBezier::line(chain.back().p3, at(centre, inner, middle + foot)));
        appendArc(chain, centre, inner, middle + foot, middle + sector - foot);
        chain.push_back(
            CubicBezier::line(chain.back().p3, at(centre, outer, middle + sector - top)));
    }
    return closed(std::move(chain));
}

std::vector<Contour> ringOfCircles(const Vec2 &centre, double outer, double inner, int count,
                                   double phase)
{
    const double ring = 0.5 * (outer + inner);
    const double share = count > 1 ? 2.0 * ring * std::sin(0.5 * kTurn / count) : 2.0 * ring;
    const double radius = std::min(0.5 * std::abs(outer - inner), 0.4 * share);
    std::vector<Contour> circles;
    for (int i = 0; i < count && radius > 0.0; ++i)
        circles.push_back(circleContour(at(centre, ring, phase + kTurn * i / count), radius));
    return circles;
}

} // namespace fff
