#include "core/geometry/simple_ring.h"

#include "core/geometry/grid_predicates.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

struct Edge
{
    GridPoint from, to;
    std::int64_t low = 0, high = 0;   // along the sweep
    std::int64_t left = 0, right = 0; // across it
    std::size_t index = 0;
    int ring = 0;
};

/// Edges that do not follow each other.
bool edgesMeet(const Edge &a, const Edge &b)
{
    if (sideOf(a.from, a.to, b.from) * sideOf(a.from, a.to, b.to) > 0)
        return false;
    return sideOf(b.from, b.to, a.from) * sideOf(b.from, b.to, a.to) <= 0;
}

/// The second edge runs back on the first, which it follows.
bool turnsBack(const Edge &first, const Edge &second)
{
    if (sideOf(first.from, first.to, second.to) != 0)
        return false;
    const Int128 along = Int128(first.to.x - first.from.x) * Int128(second.to.x - second.from.x) +
                         Int128(first.to.y - first.from.y) * Int128(second.to.y - second.from.y);
    return along < 0;
}

/// Which way the edges of a ring are swept: along that side of its box of which an edge takes the
/// smaller part, so that fewer are beside each other.
bool isSweptAlongX(const GridRing &ring)
{
    GridPoint min = ring.front(), max = ring.front(), before = ring.back();
    double width = 0.0, height = 0.0; // of all edges
    for (const GridPoint &p : ring) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
        width += std::abs(static_cast<double>(p.x - before.x));
        height += std::abs(static_cast<double>(p.y - before.y));
        before = p;
    }
    return width * static_cast<double>(max.y - min.y) <=
           height * static_cast<double>(max.x - min.x);
}

void addEdges(const GridRing &ring, int number, bool alongX, std::vector<Edge> &edges)
{
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const GridPoint &a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
        const auto [lowX, highX] = std::minmax(a.x, b.x);
        const auto [lowY, highY] = std::minmax(a.y, b.y);
        if (alongX)
            edges.push_back({a, b, lowX, highX, lowY, highY, i, number});
        else
            edges.push_back({a, b, lowY, highY, lowX, highX, i, number});
    }
}

/// Whether `test` says yes to any two edges whose boxes meet.
template <class Test>
bool anyPair(const std::vector<Edge> &edges, Test test)
{
    // Keys apart from the edges: sorting moves as little as possible.
    std::vector<std::pair<std::int64_t, std::uint32_t>> order;
    order.reserve(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        order.emplace_back(edges[i].low, static_cast<std::uint32_t>(i));
    std::sort(order.begin(), order.end());
    std::vector<const Edge *> beside; // those that the sweep has not left behind
    for (const auto &[low, index] : order) {
        const Edge &edge = edges[index];
        for (std::size_t i = 0; i < beside.size();) {
            const Edge &other = *beside[i];
            if (other.high < low) {
                beside[i] = beside.back();
                beside.pop_back();
                continue;
            }
            if (other.right >= edge.left && other.left <= edge.right && test(other, edge))
                return true;
            ++i;
        }
        beside.push_back(&edge);
    }
    return false;
}

/// Beyond what neighbours have in common.
bool doMeet(const Edge &a, const Edge &b, std::span<const GridRing> rings)
{
    if (a.ring != b.ring)
        return edgesMeet(a, b);
    const std::size_t size = rings[static_cast<std::size_t>(a.ring)].size();
    const std::size_t afterA = a.index + 1 < size ? a.index + 1 : 0;
    const std::size_t afterB = b.index + 1 < size ? b.index + 1 : 0;
    if (afterA == b.index)
        return turnsBack(a, b);
    return afterB == a.index ? turnsBack(b, a) : edgesMeet(a, b);
}

} // namespace

bool isSimple(const GridRing &ring)
{
    return areSimpleAndApart({&ring, 1});
}

bool areSimpleAndApart(std::span<const GridRing> rings)
{
    return !firstMeeting(rings);
}

std::optional<GridPoint> firstMeeting(std::span<const GridRing> rings)
{
    std::size_t count = 0;
    for (const GridRing &ring : rings) {
        if (ring.size() < 3)
            return ring.empty() ? GridPoint() : ring.front();
        count += ring.size();
    }
    std::vector<Edge> edges;
    edges.reserve(count);
    for (std::size_t i = 0; i < rings.size(); ++i)
        addEdges(rings[i], static_cast<int>(i), isSweptAlongX(rings.front()), edges);
    std::optional<GridPoint> meeting;
    anyPair(edges, [&](const Edge &a, const Edge &b) {
        if (doMeet(a, b, rings))
            meeting = a.high - a.low < b.high - b.low ? a.from : b.from; // of the shorter one
        return meeting.has_value();
    });
    return meeting;
}

bool meet(const GridRing &a, const GridRing &b)
{
    if (a.empty() || b.empty())
        return false;
    std::vector<Edge> edges;
    edges.reserve(a.size() + b.size());
    const bool alongX = isSweptAlongX(a);
    addEdges(a, 0, alongX, edges);
    addEdges(b, 1, alongX, edges);
    return anyPair(edges, [](const Edge &first, const Edge &second) {
        return first.ring != second.ring && edgesMeet(first, second);
    });
}

} // namespace fff
