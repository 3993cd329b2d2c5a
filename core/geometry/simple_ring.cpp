#include "core/geometry/simple_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

__extension__ using Wide = __int128;

// Relative error of the difference of two rounded products, twice over.
constexpr double kProductError = 4.0 * std::numeric_limits<double>::epsilon();

/// On which side of the line from a to b lies p: the sign, exactly.
int side(const GridPoint &a, const GridPoint &b, const GridPoint &p)
{
    const std::int64_t bx = b.x - a.x, by = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
    const double left = static_cast<double>(bx) * static_cast<double>(py);
    const double right = static_cast<double>(by) * static_cast<double>(px);
    const double difference = left - right;
    if (std::abs(difference) > kProductError * (std::abs(left) + std::abs(right)))
        return difference > 0.0 ? 1 : -1;
    const Wide exact = Wide(bx) * Wide(py) - Wide(by) * Wide(px);
    return exact > 0 ? 1 : (exact < 0 ? -1 : 0);
}

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
    if (side(a.from, a.to, b.from) * side(a.from, a.to, b.to) > 0)
        return false;
    return side(b.from, b.to, a.from) * side(b.from, b.to, a.to) <= 0;
}

/// The second edge runs back on the first, which it follows.
bool turnsBack(const Edge &first, const Edge &second)
{
    if (side(first.from, first.to, second.to) != 0)
        return false;
    const Wide along = Wide(first.to.x - first.from.x) * Wide(second.to.x - second.from.x) +
                       Wide(first.to.y - first.from.y) * Wide(second.to.y - second.from.y);
    return along < 0;
}

/// Which way the edges of a ring are swept: along the longer side of its box.
bool isWide(const GridRing &ring)
{
    const auto [minX, maxX] = std::minmax_element(
        ring.begin(), ring.end(), [](const auto &a, const auto &b) { return a.x < b.x; });
    const auto [minY, maxY] = std::minmax_element(
        ring.begin(), ring.end(), [](const auto &a, const auto &b) { return a.y < b.y; });
    return maxX->x - minX->x >= maxY->y - minY->y;
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

} // namespace

bool isSimple(const GridRing &ring)
{
    const std::size_t count = ring.size();
    if (count < 3)
        return false;
    std::vector<Edge> edges;
    edges.reserve(count);
    addEdges(ring, 0, isWide(ring), edges);
    return !anyPair(edges, [count](const Edge &a, const Edge &b) {
        const std::size_t afterA = a.index + 1 < count ? a.index + 1 : 0;
        const std::size_t afterB = b.index + 1 < count ? b.index + 1 : 0;
        if (afterA == b.index)
            return turnsBack(a, b);
        return afterB == a.index ? turnsBack(b, a) : edgesMeet(a, b);
    });
}

bool meet(const GridRing &a, const GridRing &b)
{
    if (a.empty() || b.empty())
        return false;
    std::vector<Edge> edges;
    edges.reserve(a.size() + b.size());
    const bool alongX = isWide(a);
    addEdges(a, 0, alongX, edges);
    addEdges(b, 1, alongX, edges);
    return anyPair(edges, [](const Edge &first, const Edge &second) {
        return first.ring != second.ring && edgesMeet(first, second);
    });
}

} // namespace fff
