#include "core/geometry/box_tree.h"

#include <algorithm>
#include <numeric>

namespace fff {

BoxTree::BoxTree(const std::vector<Box3> &boxes)
{
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    m_nodes.reserve(2 * boxes.size());
    if (!boxes.empty())
        add(boxes, order, 0, boxes.size());
}

void BoxTree::add(const std::vector<Box3> &boxes, std::vector<int> &order, std::size_t first,
                  std::size_t end)
{
    const auto begin = order.begin();
    const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
    Node node;
    Box3 middles;
    for (std::size_t i = first; i < end; ++i) {
        const Box3 &box = boxes[static_cast<std::size_t>(order[i])];
        node.box.extend(box);
        middles.extend(box.center());
    }
    const std::size_t own = m_nodes.size();
    if (end - first == 1)
        node.index = order[first];
    m_nodes.push_back(node);
    if (end - first > 1) {
        Eigen::Index axis = 0;
        middles.size().maxCoeff(&axis);
        const std::size_t middle = first + (end - first) / 2;
        std::nth_element(at(first), at(middle), at(end), [&](int a, int b) {
            const double x = boxes[static_cast<std::size_t>(a)].center()[axis];
            const double y = boxes[static_cast<std::size_t>(b)].center()[axis];
            return x != y ? x < y : a < b;
        });
        add(boxes, order, first, middle);
        add(boxes, order, middle, end);
    }
    m_nodes[own].behind = m_nodes.size();
}

} // namespace fff
