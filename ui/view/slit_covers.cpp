#include "ui/view/slit_covers.h"

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

/// Cosine of the angle between two planes up to which they stand square to each other.
constexpr double kSquare = 1e-6;
/// Play between wall and guest that is not to be seen into, mm.
constexpr double kNoPlay = 0.01;
/// What lies this near to the border of a stretch is on it, mm.
constexpr double kOnBorder = 2e-3;

/// Ring points as (along, across) of a stretch.
struct Stretch
{
    Vec2 origin, along, across;

    Vec2 at(const Vec2 &p) const { return {along.dot(p - origin), across.dot(p - origin)}; }
};

/// The smallest `along` at which the ring's edges come into the strip, at most `length`.
double firstIntrusion(const Polygon &ring, const Stretch &stretch, double half, double length)
{
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec2 a = stretch.at(ring[i]), b = stretch.at(ring[(i + 1) % ring.size()]);
        if (a.y() > b.y())
            std::swap(a, b);
        if (b.y() <= -half || a.y() >= half || std::min(a.x(), b.x()) >= length ||
            std::max(a.x(), b.x()) <= kOnBorder)
            continue;
        // The part of the edge between the strip's two borders.
        const auto atHeight = [&](double y) { return a + (y - a.y()) / (b.y() - a.y()) * (b - a); };
        const Vec2 low = a.y() < -half ? atHeight(-half) : a;
        const Vec2 high = b.y() > half ? atHeight(half) : b;
        const double least = std::min(low.x(), high.x());
        if (std::max(low.x(), high.x()) > kOnBorder)
            length = std::min(length, std::max(least, 0.0));
    }
    return length;
}

/// How far the parts fill the strip from its beginning on.
double filledLength(const std::vector<CurvedRegion> &parts, const Stretch &stretch, double half,
                    double length)
{
    const Vec2 start = stretch.origin + 2.0 * kOnBorder * stretch.along;
    const bool isInside = std::any_of(parts.begin(), parts.end(), [&](const CurvedRegion &part) {
        return locate(start, part.region) != Side::Outside;
    });
    if (!isInside)
        return 0.0;
    for (const CurvedRegion &part : parts) {
        length = firstIntrusion(part.region.outer, stretch, half, length);
        for (const Polygon &hole : part.region.holes)
            length = firstIntrusion(hole, stretch, half, length);
    }
    return length;
}

} // namespace

SectionCovers slitCovers(const Analysis &analysis, std::size_t section)
{
    SectionCovers covers;
    const Model &model = analysis.model;
    const Frame &host = model.section(section)->frame;
    const double half = 0.5 * model.stockOf(section).thickness - kOnBorder;
    for (const Slit &slit : analysis.assembly.slits[section]) {
        const auto index = static_cast<std::size_t>(slit.guest);
        const Frame &guest = model.section(index)->frame;
        const bool touches = std::abs(host.normal().dot(guest.normal())) < kSquare &&
                             std::abs(slit.width - model.stockOf(index).thickness) < kNoPlay;
        const double length = (slit.mouth - slit.inner).norm();
        if (!touches || !(length > 4.0 * kOnBorder) || !(half > 0.0))
            continue;
        SlitCover cover;
        cover.inner = slit.inner;
        cover.direction = (slit.mouth - slit.inner) / length;
        cover.halfWidth = 0.5 * slit.width;
        const Stretch stretch{guest.toLocal(host.toWorld(slit.inner)),
                              guest.directionToLocal(host.directionToWorld(cover.direction)),
                              guest.directionToLocal(host.normal())};
        const double filled = filledLength(analysis.cuts[index]->parts(), stretch, half, length);
        cover.length = kCoverStep * std::floor(filled / kCoverStep);
        if (cover.length > kNoPlay) {
            covers.covers.push_back(cover);
            covers.guests.push_back(slit.guest);
        }
    }
    return covers;
}

} // namespace fff::ui
