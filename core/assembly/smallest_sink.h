// The smallest set of nodes of a graph that no edge leads out of, without looking at more edges
// than it takes. Internal to assembly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace fff {

/// How far the edges of a node have been looked at.
struct EdgeCursor
{
    std::size_t first = 0, second = 0; // as who follows them likes
};

/// weights  of the nodes
/// limit    the set weighs less
/// next     next(node, cursor): where to the next edge of the node leads, and the cursor beyond it;
///          nothing behind the last one. Edges to itself do no harm.
/// Result   the nodes of the lightest such set, of equal ones of the one with the lowest node;
///          nothing when there is none.
///
/// Such a set is strongly connected, or it would have a smaller one in it. A node that an edge
/// leads out of towards what was seen before, or towards too much, belongs to none: the other edges
/// of all that led to it are not looked at. O(nodes + edges).
/// Source  H. Gabow 2000, Path-based depth-first search for strong and biconnected components.
template <class Next>
std::optional<std::vector<int>> smallestSink(const std::vector<std::size_t> &weights,
                                             std::size_t limit, Next next)
{
    constexpr int kUnseen = -1, kDone = -2;
    struct Visit
    {
        int node;
        EdgeCursor cursor;
    };
    std::vector<int> place(weights.size(), kUnseen); // in `open`
    std::vector<int> open;                           // nodes on the way, each leads to the next
    std::vector<std::size_t> before;                 // of each of these the weight before it
    std::vector<std::size_t> begins; // of those that lead to each other the place of the first
    std::vector<Visit> visits;
    std::optional<std::vector<int>> best;
    std::size_t total = 0;
    const auto weightOfLast = [&] { return total - before[begins.back()]; };
    const auto push = [&](int node) {
        place[static_cast<std::size_t>(node)] = static_cast<int>(open.size());
        begins.push_back(open.size());
        open.push_back(node);
        before.push_back(total);
        total += weights[static_cast<std::size_t>(node)];
        visits.push_back({node, {}});
    };
    const auto keepLast = [&] {
        std::vector<int> found(open.begin() + static_cast<std::ptrdiff_t>(begins.back()),
                               open.end());
        std::sort(found.begin(), found.end());
        const bool isLighter = weightOfLast() + 1 < limit;
        if (!best || isLighter || found.front() < best->front())
            best = std::move(found);
        limit = weightOfLast() + 1; // for what is as light, too
    };
    const auto follow = [&](int root) {
        push(root);
        while (weightOfLast() < limit) {
            Visit &visit = visits.back();
            const std::optional<int> there = next(visit.node, visit.cursor);
            if (!there) {
                if (begins.back() ==
                    static_cast<std::size_t>(place[static_cast<std::size_t>(visit.node)]))
                    return keepLast();
                visits.pop_back();
                continue;
            }
            const int at = place[static_cast<std::size_t>(*there)];
            if (at == kDone)
                return;
            if (at == kUnseen)
                push(*there);
            while (at >= 0 && begins.back() > static_cast<std::size_t>(at))
                begins.pop_back();
        }
    };
    for (int root = 0; root < static_cast<int>(weights.size()); ++root) {
        if (place[static_cast<std::size_t>(root)] != kUnseen)
            continue;
        follow(root);
        for (const int node : open)
            place[static_cast<std::size_t>(node)] = kDone;
        open.clear();
        before.clear();
        begins.clear();
        visits.clear();
        total = 0;
    }
    return best;
}

} // namespace fff
