// The boundary of a region, for questions about a few places of it: each costs the work of its
// surroundings, not of the whole boundary.
#pragma once

#include "core/geometry/box_runs.h"
#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// A ring as a line sees it that goes through a point along a unit vector: of runs of edges that
/// lie more than `reach` mm beside it, on one side, the first and the last vertex are left, edges
/// that come nearer are there as they were.
struct ThinnedRing
{
    Polygon points;
    std::vector<int> indices; // of the points in the ring, ascending
};

/// Copies nothing: the polygon outlives it and stays where it is.
class PolygonTree
{
public:
    explicit PolygonTree(const Polygon &polygon);

    /// The same as locate(point, polygon).
    Side locate(const Vec2 &point) const;

    const Polygon &polygon() const { return *m_polygon; }
    /// All of it lies more than `reach` mm beside the line, on one side.
    bool isBeside(const Vec2 &point, const Vec2 &direction, double reach) const;
    /// What the line comes near to.
    ThinnedRing thinned(const Vec2 &point, const Vec2 &direction, double reach) const;

    /// Calls visit(a, b) for the edges that come into the box, and for some near it, in the order
    /// of the polygon.
    template <class Visit>
    void visitNear(const Box2 &box, Visit visit) const
    {
        m_edges.any([&](const Box2 &run) { return run.intersects(box); },
                    [&](std::size_t edge) {
                        visit(beginOf(edge), (*m_polygon)[edge]);
                        return false;
                    });
    }

private:
    /// Where an edge begins; it ends at the point of its own index.
    const Vec2 &beginOf(std::size_t edge) const
    {
        return (*m_polygon)[(edge > 0 ? edge : m_polygon->size()) - 1];
    }

    const Polygon *m_polygon;
    BoxRuns m_edges;
};

/// The same over all rings of a region, whose holes lie inside and apart.
class RegionTree
{
public:
    explicit RegionTree(const Region &region);

    /// The same as locate(point, region).
    Side locate(const Vec2 &point) const;

    /// The outer ring, then the holes.
    const std::vector<PolygonTree> &rings() const { return m_rings; }

    template <class Visit>
    void visitNear(const Box2 &box, Visit visit) const
    {
        for (const PolygonTree &ring : m_rings)
            ring.visitNear(box, visit);
    }

private:
    std::vector<PolygonTree> m_rings;
};

} // namespace fff
