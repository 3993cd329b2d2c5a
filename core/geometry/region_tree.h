// The boundary of a region, for questions about a few places of it: each costs the work of its
// surroundings, not of the whole boundary.
#pragma once

#include "core/geometry/box_runs.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
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

/// What lies no more than `reach` mm beside a line that goes through a point along a unit vector.
class LineStrip
{
public:
    LineStrip(const Vec2 &point, const Vec2 &direction, double reach)
        : m_normal(perpendicular(direction)), m_size(0.5 * m_normal.cwiseAbs()),
          m_middle(m_normal.dot(point)), m_reach(reach)
    {
    }

    /// On which side of it (±1) all of a box, or of an edge, is; 0: it may come into the strip.
    int sideOf(const Box2 &box) const
    {
        const double across = 0.5 * m_normal.dot(box.min + box.max) - m_middle;
        if (!(std::abs(across) > m_reach + m_size.dot(box.max - box.min)))
            return 0;
        return across > 0.0 ? 1 : -1;
    }
    int sideOf(const Vec2 &a, const Vec2 &b) const
    {
        const double atA = m_normal.dot(a) - m_middle, atB = m_normal.dot(b) - m_middle;
        return std::min(atA, atB) > m_reach ? 1 : std::max(atA, atB) < -m_reach ? -1 : 0;
    }

private:
    Vec2 m_normal, m_size;
    double m_middle, m_reach;
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

    /// The same for the edges that come into the strip.
    template <class Visit>
    void visitIn(const LineStrip &strip, Visit visit) const
    {
        m_edges.any([&](const Box2 &run) { return strip.sideOf(run) == 0; },
                    [&](std::size_t edge) {
                        if (strip.sideOf(beginOf(edge), (*m_polygon)[edge]) == 0)
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
