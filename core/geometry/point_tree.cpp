#include "core/geometry/point_tree.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

namespace fff {

namespace {

constexpr int kPointsOfLeaf = 8;

double squaredToBox(const Vec2 &p, const Box2 &box)
{
    return (p - p.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm();
}

} // namespace

PointTree::PointTree(std::vector<Vec2> points)
    : m_points(std::move(points)), m_order(m_points.size()), m_leaves(m_points.size(), -1)
{
    std::iota(m_order.begin(), m_order.end(), 0);
    Node root;
    root.end = static_cast<int>(m_order.size());
    m_nodes.push_back(root);
    for (int node = 0; node < static_cast<int>(m_nodes.size()); ++node)
        split(node);
}

void PointTree::split(int index)
{
    Node node = m_nodes[static_cast<std::size_t>(index)];
    for (int i = node.first; i < node.end; ++i)
        node.box.extend(m_points[static_cast<std::size_t>(m_order[static_cast<std::size_t>(i)])]);
    node.left = node.end - node.first;
    if (node.left <= kPointsOfLeaf) {
        for (int i = node.first; i < node.end; ++i)
            m_leaves[static_cast<std::size_t>(m_order[static_cast<std::size_t>(i)])] = index;
    } else {
        const Vec2 size = node.box.size();
        const int axis = size.x() >= size.y() ? 0 : 1, middle = node.first + node.left / 2;
        std::nth_element(m_order.begin() + node.first, m_order.begin() + middle,
                         m_order.begin() + node.end, [&](int a, int b) {
                             const double x = m_points[static_cast<std::size_t>(a)][axis],
                                          y = m_points[static_cast<std::size_t>(b)][axis];
                             return x != y ? x < y : a < b;
                         });
        node.child = static_cast<int>(m_nodes.size());
        for (const auto &[first, end] :
             {std::pair(node.first, middle), std::pair(middle, node.end)}) {
            Node half;
            half.first = first;
            half.end = end;
            half.parent = index;
            m_nodes.push_back(half);
        }
    }
    m_nodes[static_cast<std::size_t>(index)] = node;
}

int PointTree::nearest(const Vec2 &to) const
{
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, int>> open;
    const auto push = [&](int node) {
        const Node &of = m_nodes[static_cast<std::size_t>(node)];
        if (of.left > 0)
            open.emplace_back(squaredToBox(to, of.box), node);
    };
    push(0);
    while (!open.empty()) {
        const auto [distance, index] = open.back();
        open.pop_back();
        if (distance > least)
            continue;
        const Node &node = m_nodes[static_cast<std::size_t>(index)];
        if (node.child >= 0) {
            push(node.child);
            push(node.child + 1);
            // The nearer one is looked into first.
            if (open.size() > 1 && node.left > 0) {
                auto &last = open.back(), &other = open[open.size() - 2];
                if (last.first > other.first && other.second == node.child)
                    std::swap(last, other);
            }
            continue;
        }
        for (int i = node.first; i < node.end; ++i) {
            const int point = m_order[static_cast<std::size_t>(i)];
            if (m_leaves[static_cast<std::size_t>(point)] < 0)
                continue;
            const double squared = (m_points[static_cast<std::size_t>(point)] - to).squaredNorm();
            if (squared < least || (squared == least && point < best)) {
                least = squared;
                best = point;
            }
        }
    }
    return best;
}

void PointTree::remove(int index)
{
    int &leaf = m_leaves[static_cast<std::size_t>(index)];
    assert(leaf >= 0 && "a point is taken out once");
    for (int node = leaf; node >= 0; node = m_nodes[static_cast<std::size_t>(node)].parent)
        --m_nodes[static_cast<std::size_t>(node)].left;
    leaf = -1;
}

} // namespace fff
