// Whether two parts are in each other, by other means than the product's: along straight lines in
// both slabs, by plain arithmetic on the outlines as they are cut. No triangles, no separating
// axes, no slits.
#pragma once

#include "core/analysis/assembly_plan.h"

#include <algorithm>
#include <cmath>

namespace fff::test {

/// What is cut for a part: its outline, extruded by the thickness.
struct CutPlate
{
    const Region *region; // of the analysis, which outlives it
    Frame frame;
    double half; // of the thickness, mm
    Box2 box;    // of the outline

    std::vector<double> crossings(const Vec2 &point, const Vec2 &direction) const
    {
        std::vector<double> at;
        const auto add = [&](const Polygon &ring) {
            const Vec2 across(-direction.y(), direction.x());
            double before = across.dot(ring.back() - point);
            for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
                const double here = across.dot(ring[i] - point);
                if ((here > 0.0) != (before > 0.0)) {
                    const double share = before / (before - here);
                    at.push_back(direction.dot(ring[k] + share * (ring[i] - ring[k]) - point));
                }
                before = here;
            }
        };
        add(region->outer);
        for (const Polygon &hole : region->holes)
            add(hole);
        std::sort(at.begin(), at.end());
        return at;
    }
};

inline std::vector<CutPlate> platesOf(const Bodies &bodies)
{
    std::vector<CutPlate> plates;
    for (const Body &body : bodies) {
        const Region &region = body.outline().region;
        plates.push_back({&region, body.frame(), 0.5 * body.thickness(), bounds(region.outer)});
    }
    return plates;
}

/// The longest stretch that both outlines have on a line, given as its point and direction in each.
inline double sharedOn(const CutPlate &a, const Vec2 &pointA, const Vec2 &directionA,
                       const CutPlate &b, const Vec2 &pointB, const Vec2 &directionB)
{
    const std::vector<double> inA = a.crossings(pointA, directionA);
    if (inA.empty())
        return 0.0;
    const std::vector<double> inB = b.crossings(pointB, directionB);
    double longest = 0.0;
    for (std::size_t i = 0, k = 0; i + 1 < inA.size() && k + 1 < inB.size();) {
        longest = std::max(longest, std::min(inA[i + 1], inB[k + 1]) - std::max(inA[i], inB[k]));
        (inA[i + 1] < inB[k + 1] ? i : k) += 2;
    }
    return longest;
}

/// How long a stretch of some line lies in both, when b is moved: of lines `inset` mm below both
/// faces of each slab and between. What is less deep than twice the inset is not found. mm
inline double sharedLength(const CutPlate &a, const CutPlate &b, const Vec3 &by, double inset)
{
    Frame frameB = b.frame;
    frameB.origin += by;
    const Vec3 na = a.frame.normal(), nb = frameB.normal(), axis = na.cross(nb);
    const double sine = axis.norm();
    if (sine < 1e-6) { // parallel: one outline seen in the other's plane
        if (std::abs(a.frame.height(frameB.origin)) >= a.half + b.half - 2.0 * inset)
            return 0.0;
        // A line through each height between two corners of either outline.
        std::vector<double> heights;
        for (const CutPlate *plate : {&a, &b})
            for (const Vec2 &corner : plate->region->outer)
                heights.push_back(plate == &a ? corner.y()
                                              : a.frame.toLocal(frameB.toWorld(corner)).y());
        std::sort(heights.begin(), heights.end());
        const Vec2 inB = frameB.directionToLocal(a.frame.x);
        double longest = 0.0;
        for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
            if (heights[i + 1] - heights[i] <= 2.0 * inset)
                continue;
            const Vec2 point(0.0, 0.5 * (heights[i] + heights[i + 1]));
            longest = std::max(longest, sharedOn(a, point, Vec2::UnitX(), b,
                                                 frameB.toLocal(a.frame.toWorld(point)), inB));
        }
        return longest;
    }
    const Vec3 direction = axis / sine;
    const Vec2 inA = a.frame.directionToLocal(direction), inB = frameB.directionToLocal(direction);
    const double cosine = na.dot(nb);
    double longest = 0.0;
    for (const double shareA : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        for (const double shareB : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            // On the plane at height u above a's, and at height v above b's.
            const double u = shareA * (a.half - inset), v = shareB * (b.half - inset);
            const double ra = na.dot(a.frame.origin) + u, rb = nb.dot(frameB.origin) + v;
            const Vec3 point = ((ra - cosine * rb) * na + (rb - cosine * ra) * nb) / (sine * sine);
            longest = std::max(
                longest, sharedOn(a, a.frame.toLocal(point), inA, b, frameB.toLocal(point), inB));
        }
    }
    return longest;
}

/// Of the space that a plate takes up, when it is moved.
inline Box3 spaceOf(const CutPlate &plate, const Vec3 &by)
{
    Box3 box;
    for (const double x : {plate.box.min.x(), plate.box.max.x()})
        for (const double y : {plate.box.min.y(), plate.box.max.y()})
            for (const double z : {-plate.half, plate.half})
                box.extend(Vec3(plate.frame.toWorld(Vec2(x, y)) + z * plate.frame.normal() + by));
    return box;
}

/// Whether b, moved by `by`, is in a deeper than some micrometres.
inline bool areInEachOther(const CutPlate &a, const CutPlate &b, const Vec3 &by = Vec3::Zero(),
                           double inset = 0.5e-3)
{
    return spaceOf(a, Vec3::Zero()).intersects(spaceOf(b, by)) &&
           sharedLength(a, b, by, inset) > 2.0 * inset;
}

} // namespace fff::test
