// Prisms of two solids of which one moves, and the axes that can separate them. Internal to
// assembly.
#pragma once

#include "core/assembly/solid.h"

#include <array>
#include <vector>

namespace fff {

/// Leaves of `way` where the extent of a, moved on by `speed` each mm, and that of b share more
/// than `depth`. False when nothing is left.
inline bool keepShared(const Extent &a, const Extent &b, double speed, double depth, Travel &way)
{
    // a.max + t speed > b.min + depth  and  a.min + t speed < b.max − depth
    const double low = b.min + depth - a.max, high = b.max - depth - a.min;
    if (speed == 0.0)
        return low < 0.0 && high > 0.0;
    const double first = low / speed, second = high / speed;
    way.from = std::max(way.from, std::min(first, second));
    way.to = std::min(way.to, std::max(first, second));
    // A product of negative depths can turn the two around; then there is nothing.
    return low < high && way.from < way.to;
}

inline Extent extentOf(const std::array<Vec3, 3> &triangle, const Vec3 &axis)
{
    const double a = axis.dot(triangle[0]), b = axis.dot(triangle[1]), c = axis.dot(triangle[2]);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

inline Extent wider(const Extent &extent, double by)
{
    return {extent.min - by, extent.max + by};
}

/// What all prisms of a solid have in common.
struct Plate
{
    Vec3 normal = Vec3::UnitZ();
    double half = 0.0; // of the thickness, mm

    /// By how much a prism reaches beyond its triangle along an axis, to both sides.
    double more(const Vec3 &axis) const { return half * std::abs(axis.dot(normal)); }
    Extent extent(const std::array<Vec3, 3> &corners, const Vec3 &axis) const
    {
        return wider(extentOf(corners, axis), more(axis));
    }
};

/// A prism of one of the two, with what it takes up along the axes that each of its pairs asks
/// about.
struct PairedPrism
{
    std::array<Vec3, 3> corners; // world, mm
    int seen = -1;               // where that is kept; −1: nobody has asked

    Vec3 edge(std::size_t i) const { return corners[(i + 1) % 3] - corners[i]; }
};

/// A prism of each of two solids, as their triangles.
struct PrismIndices
{
    std::size_t mover = 0, other = 0;

    PrismIndices swapped() const { return {other, mover}; }
};

/// Two plates of which the first one moves along a direction. An axis that belongs to one prism is
/// worked out once, for all of its pairs: most pairs are told apart by one of those.
///
/// Source  separating axes of convex polytopes (C. Ericson 2005, Real-Time Collision Detection,
///         5.5.8). All 22 of two prisms count; in which order they are looked at does not matter.
class PrismPairs
{
public:
    PrismPairs(const Plate &mover, const Plate &other, const Vec3 &direction);

    const Plate &mover() const { return m_mover; }
    const Plate &other() const { return m_other; }

    /// Leaves of `way` where both share more than depth. False when nothing is left.
    bool keepMeeting(PairedPrism &mover, PairedPrism &other, double depth, Travel &way);
    /// The least that one would have to move to come free of the other, mm, as they are.
    double depthOf(PairedPrism &mover, PairedPrism &other);

private:
    struct Axis
    {
        Vec3 along;
        double speed = 0.0; // of the mover along it, each mm of its way
    };
    /// What a prism takes up.
    struct Seen
    {
        struct Edge
        {
            Axis axis; // square to an edge of it and one of the normals
            Extent extent;
            double moreOfMate = 0.0; // Plate::more() of the others
        };
        std::array<Extent, 3> common;
        std::array<Edge, 6> edges;
        int edgeCount = -1; // −1: nobody has asked
    };

    Axis axisAlong(const Vec3 &along) const { return {along, along.dot(m_direction)}; }
    int see(PairedPrism &prism, const Plate &plate);
    const Seen &withEdges(const PairedPrism &prism, const Plate &plate, const Plate &mate);
    /// Calls look(extent of the mover, extent of the other, speed) for each axis until it answers
    /// false.
    template <typename Look>
    bool forEachAxis(PairedPrism &mover, PairedPrism &other, const Look &look);

    Plate m_mover, m_other;
    Vec3 m_direction;
    std::array<Axis, 3> m_common; // both normals, and square to these
    std::size_t m_commonCount = 2;
    std::vector<Seen> m_seen;
};

} // namespace fff
