// The boundary of a region, for questions about a few places of it: each costs the work of its
// surroundings, not of the whole boundary.
#pragma once

#include "core/geometry/polygon.h"

#include <algorithm>
#include <vector>

namespace fff {

/// Boxes over runs of edges that follow each other, over runs of such boxes, and so on up to one.
/// Copies nothing: the polygon outlives it and stays where it is.
class PolygonTree
{
public:
    explicit PolygonTree(const Polygon &polygon);

    /// The same as locate(point, polygon).
    Side locate(const Vec2 &point) const;

    /// Calls visit(a, b) for the edges that come into the box, and for some near it, in the order
    /// of the polygon.
    template <class Visit>
    void visitNear(const Box2 &box, Visit visit) const
    {
        const auto meets = [&](const Run &run) {
            return (run.box.min.array() <= box.max.array()).all() &&
                   (run.box.max.array() >= box.min.array()).all();
        };
        walk(meets, visit);
    }

private:
    static constexpr std::size_t kRun = 8; // edges below a box, boxes below a larger one

    /// Edges that follow each other.
    struct Run
    {
        const Box2 &box;
        const Vec2 &begin, &end; // points
    };

    /// To all edges of runs that isWanted.
    template <class IsWanted, class Visit>
    void walk(IsWanted isWanted, Visit visit) const
    {
        if (m_levels.empty())
            return;
        std::size_t span = kRun; // edges below a box
        for (std::size_t level = 1; level < m_levels.size(); ++level)
            span *= kRun;
        walkFrom(m_levels.size() - 1, 0, span, isWanted, visit);
    }

    template <class IsWanted, class Visit>
    void walkFrom(std::size_t level, std::size_t index, std::size_t span, IsWanted &isWanted,
                  Visit &visit) const
    {
        const Polygon &polygon = *m_polygon;
        const std::size_t first = index * span, end = std::min(first + span, polygon.size());
        if (!isWanted(Run{m_levels[level][index], beginOf(first), polygon[end - 1]}))
            return;
        if (level == 0) {
            for (std::size_t i = first; i < end; ++i)
                visit(beginOf(i), polygon[i]);
            return;
        }
        const std::size_t last = std::min((index + 1) * kRun, m_levels[level - 1].size());
        for (std::size_t below = index * kRun; below < last; ++below)
            walkFrom(level - 1, below, span / kRun, isWanted, visit);
    }

    /// Where an edge begins; it ends at the point of its own index.
    const Vec2 &beginOf(std::size_t edge) const
    {
        return (*m_polygon)[(edge > 0 ? edge : m_polygon->size()) - 1];
    }

    const Polygon *m_polygon;
    std::vector<std::vector<Box2>> m_levels; // over edges, over these boxes, …, one box
};

/// The same over all rings of a region, whose holes lie inside and apart.
class RegionTree
{
public:
    explicit RegionTree(const Region &region);

    /// The same as locate(point, region).
    Side locate(const Vec2 &point) const;

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
