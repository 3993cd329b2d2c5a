// Which of many rings lies in which.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/region_tree.h"

#include <memory>
#include <vector>

namespace fff {

/// A contour without crossings, for asking of many others whether they lie in it: each costs the
/// work of its surroundings. On chords of kCutChord, which are snapped to the grid of booleans.
class RingInterior
{
public:
    explicit RingInterior(const Contour &contour);

    /// All of the other one is inside, and nothing of it on the edge. As nesting() in boolean.h.
    bool hasAll(const RingInterior &other) const;
    /// The same, or they meet and most of the other one's corners are inside.
    bool hasMost(const RingInterior &other) const;

private:
    bool isInside(const Vec2 &point) const;
    bool meets(const RingInterior &other) const;

    std::unique_ptr<Polygon> m_corners; // the tree knows where they are
    Box2 m_box;
    PolygonTree m_tree;
};

/// Of each ring the smallest one that it lies in, by its index; -1: it lies in none.
///
/// rings  counter-clockwise, each without crossings, largest first. What lies in another one comes
///        after it. Where two meet, the one lies in the other that has most of its corners there.
///
/// Boxes of the rings are kept in a tree over their four sides, so that those around a ring are
/// found from the smallest on. O(n log n) for drawings in which boxes lie within each other where
/// rings do.
std::vector<int> ringsAround(const std::vector<Contour> &rings);

} // namespace fff
