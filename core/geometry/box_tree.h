// Boxes in space, for finding those near something: each question costs the work of its
// surroundings, not of all.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// Over boxes that stay as they are. Source  C. Ericson 2005, Real-Time Collision Detection, 6.2
/// (median split).
class BoxTree
{
public:
    BoxTree() = default;
    /// O(n log n).
    explicit BoxTree(const std::vector<Box3> &boxes);

    /// Calls visit(index) for each box of which `isNear` says true, as it does of what is around
    /// such a box, in an order of the tree's own, until it says true itself. Whether it did.
    template <class IsNear, class Visit>
    bool any(IsNear isNear, Visit visit) const
    {
        for (std::size_t next = 0; next < m_nodes.size();) {
            const Node &node = m_nodes[next];
            if (!isNear(node.box)) {
                next = node.behind;
                continue;
            }
            if (node.index >= 0 && visit(node.index))
                return true;
            ++next;
        }
        return false;
    }

private:
    struct Node
    {
        Box3 box;
        std::size_t behind = 0; // the next one that is not in it
        int index = -1;         // of the only box in it
    };
    void add(const std::vector<Box3> &boxes, std::vector<int> &order, std::size_t first,
             std::size_t end);

    std::vector<Node> m_nodes; // each before those in it
};

} // namespace fff
