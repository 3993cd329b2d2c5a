#include "core/interaction/pick.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fff {

namespace {

struct Span
{
    double from = 0.0, to = std::numeric_limits<double>::infinity(); // mm along a ray

    bool isEmpty() const { return !(from <= to); }
};

/// Cuts the span down to where low <= start + s * slope <= high.
void clip(Span &span, double start, double slope, double low, double high)
{
    if (slope == 0.0) {
        if (start < low || start > high)
            span.to = -std::numeric_limits<double>::infinity();
        return;
    }
    const double a = (low - start) / slope, b = (high - start) / slope;
    span.from = std::max(span.from, std::min(a, b));
    span.to = std::min(span.to, std::max(a, b));
}

Span spanInBox(const Ray &ray, const Box3 &box, double margin)
{
    Span span;
    for (int axis = 0; axis < 3; ++axis)
        clip(span, ray.origin[axis], ray.direction[axis], box.min[axis] - margin,
             box.max[axis] + margin);
    return span;
}

/// Smallest parameter at which the way from a to b meets an edge of the polygon.
std::optional<double> firstCrossing(const Vec2 &a, const Vec2 &b, const Polygon &polygon)
{
    std::optional<double> first;
    const Vec2 way = b - a;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vec2 edge = polygon[i] - polygon[j];
        const double denominator = cross(way, edge);
        if (denominator == 0.0)
            continue;
        const Vec2 offset = polygon[j] - a;
        const double s = cross(offset, edge) / denominator;
        const double t = cross(offset, way) / denominator;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0 && (!first || s < *first))
            first = s;
    }
    return first;
}

/// Where the ray enters the slab of the section's region, or nothing.
///
/// Inside the slab the ray's foot on the mid-plane runs along a segment, a point when seen from the
/// front, long when seen from the side: the slab is met where that segment first is in the region.
std::optional<Hit> hitSlab(const Section &section, double thickness, const Ray &ray,
                           const std::optional<ClipPlane> &open)
{
    const double half = 0.5 * thickness;
    Span span = spanInBox(ray, worldBounds(*section.shape, section.frame), half);
    if (open && !span.isEmpty())
        clip(span, open->height(ray.origin), open->normal.dot(ray.direction),
             -std::numeric_limits<double>::infinity(), 0.0);
    if (span.isEmpty())
        return {};
    const double slope = section.frame.normal().dot(ray.direction);
    const double height = section.frame.height(ray.origin);
    clip(span, height, slope, -half, half);
    if (span.isEmpty())
        return {};

    const Region &region = section.shape->region();
    const auto footAt = [&](double s) {
        return section.frame.toLocal(ray.origin + s * ray.direction);
    };
    const Vec2 entry = footAt(span.from), exit = footAt(span.to);
    double met = 0.0;
    if (locate(entry, region) == Side::Outside) {
        std::optional<double> first = firstCrossing(entry, exit, region.outer);
        for (const Polygon &hole : region.holes) {
            const std::optional<double> wall = firstCrossing(entry, exit, hole);
            if (wall && (!first || *wall < *first))
                first = wall;
        }
        if (!first)
            return {};
        met = *first;
    }

    Hit hit;
    hit.distance = span.from + met * (span.to - span.from);
    hit.local = entry + met * (exit - entry);
    // On a face the point is where the ray meets the mid-plane, so that it lies under the cursor;
    // on a side wall that may be outside, and the wall's own foot stands for it.
    if (slope != 0.0) {
        const Vec2 middle = footAt(-height / slope);
        if (locate(middle, region) != Side::Outside)
            hit.local = middle;
    }
    hit.point = section.frame.toWorld(hit.local);
    return hit;
}

} // namespace

std::vector<Hit> pick(const Model &model, const Ray &ray, const ViewState &view)
{
    const bool picksAll = view.picksAll();
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        if (!picksAll && !view.isPicked(model.ref(i)))
            continue;
        std::optional<Hit> hit =
            hitSlab(*model.section(i), model.stockOf(i).thickness, ray, view.clip);
        if (!hit)
            continue;
        hit->section = static_cast<int>(i);
        hits.push_back(*hit);
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const Hit &a, const Hit &b) { return a.distance < b.distance; });
    return hits;
}

std::optional<SectionRef> sectionUnder(const Model &model, const Ray &ray, const ViewState &view)
{
    const std::vector<Hit> hits = pick(model, ray, view);
    return hits.empty() ? std::nullopt
                        : std::optional(model.ref(static_cast<std::size_t>(hits.front().section)));
}

std::optional<Vec2> pointOnPlane(const Camera &camera, const Vec2 &viewport, const Frame &plane,
                                 const Vec2 &screen)
{
    // From the target's depth rather than from the eye: fewer digits are lost.
    const Vec3 start = camera.pointAt(screen, viewport);
    const Vec3 direction = -camera.towardsEye(start, viewport);
    const double slope = plane.normal().dot(direction);
    if (std::abs(slope) < std::sin(kMinDrawAngle))
        return {};
    const Vec3 point = start - (plane.height(start) / slope) * direction;
    if (camera.isPerspective() && camera.forward().dot(point - camera.eye(viewport)) <= 0.0)
        return {};
    return plane.toLocal(point);
}

} // namespace fff
