// The edges of an outline by where they are: for the judge of what is held, which shares nothing
// with the product's own ways to find them.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff::test {

using PlainRing = std::vector<Vec2>; // closed, the first point not repeated, either winding

class EdgeGrid
{
public:
    EdgeGrid(const PlainRing &outer, const std::vector<PlainRing> &holes);

    /// Even-odd.
    bool isInside(const Vec2 &p) const;
    /// From the nearest edge, or `limit` where that is farther away. mm
    double distance(const Vec2 &p, double limit) const;
    const Vec2 &min() const { return m_min; }
    const Vec2 &max() const { return m_max; }

private:
    struct Edge
    {
        Vec2 from, to;
    };
    /// Lists of edges, one after another.
    struct Lists
    {
        std::vector<int> starts, edges;
    };

    int columnOf(double x) const;
    int rowOf(double y) const;
    template <class Visit>
    void forEachCell(const Edge &edge, Visit visit) const;

    std::vector<Edge> m_edges;
    Vec2 m_min, m_max;
    int m_columns = 1, m_rows = 1;
    Lists m_ofRows, m_ofCells;
};

} // namespace fff::test
