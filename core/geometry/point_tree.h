// Points in the plane that are taken out one after the other, always the nearest that is left.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// Source  J. L. Bentley 1975, Multidimensional binary search trees, CACM 18(9); halves at the
/// median of the longer side of their box, counts of what is left in each.
class PointTree
{
public:
    /// O(n log n).
    explicit PointTree(std::vector<Vec2> points);

    /// Index of the nearest that is left, of equally near ones the lowest; −1: none is. As a rule
    /// O(log n).
    int nearest(const Vec2 &to) const;
    /// Takes one out that is left. O(log n).
    void remove(int index);

private:
    struct Node
    {
        Box2 box;
        int first = 0, end = 0;      // in the order, of a leaf
        int child = -1, parent = -1; // children lie side by side
        int left = 0;                // points
    };
    void split(int node);

    std::vector<Vec2> m_points;
    std::vector<int> m_order;
    std::vector<int> m_leaves; // of each point; −1: taken out
    std::vector<Node> m_nodes;
};

} // namespace fff
