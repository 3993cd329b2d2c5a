#include "core/analysis/findings/neck_growth.h"

#include "core/geometry/arc_length.h"
#include "core/geometry/bulge.h"
#include "core/geometry/contour_points.h"
#include "core/model/point_edits.h"
#include "core/model/symmetric_section.h"

#include <cmath>

namespace fff {

namespace {

/// Beside what is pushed out, in growths and in lengths of the neck: no steeper than 1 : 2.
constexpr double kBlendOfGrowth = 3.0, kBlendOfLength = 0.75;
/// mm: an end of a neck that is so near to a boundary is on it.
constexpr double kOnBoundary = 0.05;

/// An end of a neck that is on a boundary as it was drawn.
struct NeckEnd
{
    int boundary = 0;
    CurvePoint at;
    Vec2 outward = Vec2::UnitX();      // unit, along the neck
    double before = 0.0, behind = 0.0; // mm along the boundary: how far the weak place goes on
};

/// The boundary that a point is on; nothing in a slit's wall.
std::optional<std::pair<int, CurvePoint>> onBoundary(const Shape &shape, const Vec2 &point)
{
    for (int b = 0; b < boundaryCount(shape); ++b)
        if (const NearestPlace nearest = nearestPlace(boundary(shape, b), point);
            nearest.distance < kOnBoundary)
            return std::pair(b, nearest.at);
    return {};
}

/// How far the weak place goes on along the boundary, over ends of weak lines that are no farther
/// apart than it is large.
void spread(NeckEnd &end, const Shape &shape, const WeakNeck &weak)
{
    const ArcLength length(boundary(shape, end.boundary));
    const double middle = length.of(end.at), total = length.total();
    std::vector<double> before, behind;
    for (const auto &line : weak.lines)
        for (const Vec2 &point : {line.first, line.second}) {
            const auto on = onBoundary(shape, point);
            if (!on || on->first != end.boundary)
                continue;
            const double at = std::remainder(length.of(on->second) - middle, total);
            (at < 0.0 ? before : behind).push_back(std::abs(at));
        }
    const auto reachOf = [&](std::vector<double> &places) {
        std::sort(places.begin(), places.end());
        double reach = 0.0;
        for (const double at : places)
            if (at - reach < weak.size())
                reach = at;
        return reach;
    };
    end.before = reachOf(before);
    end.behind = reachOf(behind);
}

std::vector<NeckEnd> endsOf(const Shape &shape, const WeakNeck &weak)
{
    std::vector<NeckEnd> ends;
    const Vec2 along = (weak.to - weak.from).normalized();
    for (const bool isFirst : {true, false})
        if (const auto on = onBoundary(shape, isFirst ? weak.from : weak.to)) {
            ends.push_back({on->first, on->second, isFirst ? Vec2(-along) : along});
            spread(ends.back(), shape, weak);
        }
    return ends;
}

/// A symmetric boundary that is pushed out across its axis is so to both sides alike.
void centre(Bulge &bulge, const ArcLength &length, const MirrorAxis &axis)
{
    const double reach = bulge.flat + bulge.blend, middle = length.of(bulge.middle);
    const auto heightAt = [&](double from) {
        return axis.height(positionAt(length.contour(), length.at(middle + from)));
    };
    double low = -reach, high = reach;
    if (heightAt(low) * heightAt(high) > 0.0)
        return; // all of it on one side
    for (int i = 0; i < 60 && high - low > 0.0; ++i) {
        const double half = 0.5 * (low + high);
        ((heightAt(low) > 0.0) == (heightAt(half) > 0.0) ? low : high) = half;
    }
    const double across = 0.5 * (low + high);
    bulge.middle = length.at(middle + across);
    bulge.flat += std::abs(across);
    bulge.way = bulge.way.dot(axis.direction) * axis.direction;
}

Result<ShapePointer> pushedOut(const ShapePointer &shape, const Section &section,
                               const NeckEnd &end, double growth, double neck)
{
    const ArcLength length(boundary(*shape, end.boundary));
    Bulge bulge{end.at, growth * end.outward, 0.5 * (end.before + end.behind) + 0.25 * neck,
                std::max(kBlendOfGrowth * growth, kBlendOfLength * neck)};
    bulge.middle = length.at(length.of(end.at) + 0.5 * (end.behind - end.before));
    if (const MirrorAxis *axis = symmetryOf(section))
        centre(bulge, length, *axis);
    Result<Contour> contour = bulged(length.contour(), bulge);
    if (!contour)
        return tl::unexpected(contour.error());
    return withBoundary(*shape, end.boundary, *std::move(contour));
}

} // namespace

/// Ends on the same boundary are looked for again once the other one has been pushed out.
std::optional<ShapePointer> grownShape(const Section &section, const WeakNeck &weak,
                                       NeckSides sides, double growth)
{
    ShapePointer shape = section.shape;
    const std::vector<NeckEnd> ends = endsOf(*shape, weak);
    const std::size_t needed = sides == NeckSides::Both ? 2 : 1;
    if (ends.size() < needed || (sides == NeckSides::Last && ends.size() < 2))
        return {};
    std::vector<NeckEnd> chosen = ends;
    if (sides == NeckSides::First)
        chosen = {ends.front()};
    else if (sides == NeckSides::Last)
        chosen = {ends.back()};
    const double each = growth / static_cast<double>(chosen.size());
    for (NeckEnd &end : chosen) {
        const Vec2 place = positionAt(boundary(*section.shape, end.boundary), end.at);
        end.at = nearestPlace(boundary(*shape, end.boundary), place).at;
        Result<ShapePointer> next = pushedOut(shape, section, end, each, weak.size());
        if (!next)
            return {};
        shape = *std::move(next);
    }
    const MirrorAxis *axis = symmetryOf(section);
    if (!axis || isSymmetric(*shape, *axis))
        return shape;
    Result<ShapePointer> same = symmetrised(*section.shape, shape, *axis);
    return same ? std::optional(*std::move(same)) : std::nullopt;
}

} // namespace fff
