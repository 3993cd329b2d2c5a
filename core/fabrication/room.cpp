#include "core/fabrication/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace fff {

namespace {

// Shares of the box and of the best found so far below which a better place is not looked for.
constexpr double kScaleStep = 0.05;
constexpr double kRelativeStep = 0.02;
// A part that is a thousand times longer than wide is searched more coarsely.
constexpr double kMaxFirstCells = 1024.0;

/// Smallest max(|x|, |y|) on the way from a to b: at an end, or where x, y, x + y or x - y is zero.
double squareDistance(const Vec2 &a, const Vec2 &b)
{
    const Vec2 d = b - a;
    double nearest = std::min(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
    const std::array<std::array<double, 2>, 4> lines{{{a.x(), d.x()},
                                                      {a.y(), d.y()},
                                                      {a.x() + a.y(), d.x() + d.y()},
                                                      {a.x() - a.y(), d.x() - d.y()}}};
    for (const auto &[value, slope] : lines) {
        if (slope == 0.0)
            continue;
        const double t = -value / slope;
        if (t > 0.0 && t < 1.0)
            nearest = std::min(nearest, Vec2(a + t * d).cwiseAbs().maxCoeff());
    }
    return nearest;
}

Polygon corners(const Box2 &box)
{
    return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}

bool contains(const Box2 &box, const Vec2 &point)
{
    return (point.array() >= box.min.array()).all() && (point.array() <= box.max.array()).all();
}

} // namespace

Room::Room(Region region) : m_region(std::move(region))
{
    const auto addRing = [this](const Polygon &ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            m_edges.push_back({ring[j], ring[i]});
    };
    addRing(m_region.outer);
    for (const Polygon &hole : m_region.holes)
        addRing(hole);
}

void Room::take(const Box2 &box)
{
    m_taken.push_back(box);
    const Polygon ring = corners(box);
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        m_edges.push_back({ring[j], ring[i]});
}

double Room::scaleAt(const Vec2 &center, const Vec2 &half) const
{
    const Vec2 toScale = half.cwiseInverse();
    double scale = std::numeric_limits<double>::infinity();
    for (const Edge &e : m_edges)
        scale = std::min(scale, squareDistance((e.from - center).cwiseProduct(toScale),
                                               (e.to - center).cwiseProduct(toScale)));
    const bool isTaken = std::any_of(m_taken.begin(), m_taken.end(),
                                     [&](const Box2 &box) { return contains(box, center); });
    return !isTaken && locate(center, m_region) == Side::Inside ? scale : -scale;
}

Vec2 Room::roomiest(const Vec2 &half) const
{
    // In units of the box, where the factor is a distance: no point within r of another one has a
    // factor larger by more than r.
    struct Cell
    {
        Vec2 center;
        double size; // half of its side
        double scale;

        double promise() const { return scale + size; }
        bool operator<(const Cell &other) const { return promise() < other.promise(); }
    };
    const Box2 box = bounds(m_region.outer);
    const Vec2 low = box.min.cwiseQuotient(half), extent = box.size().cwiseQuotient(half);
    const auto cell = [&](const Vec2 &center, double size) {
        return Cell{center, size, scaleAt(center.cwiseProduct(half), half)};
    };
    std::priority_queue<Cell> cells;
    const double side = std::max(extent.minCoeff(), extent.maxCoeff() / kMaxFirstCells);
    for (double x = 0.5 * side; x < extent.x() + 0.5 * side; x += side) {
        for (double y = 0.5 * side; y < extent.y() + 0.5 * side; y += side)
            cells.push(cell(low + Vec2(x, y), 0.5 * side));
    }
    Cell best = cell(low + 0.5 * extent, 0.0);
    while (!cells.empty()) {
        const Cell top = cells.top();
        cells.pop();
        if (top.scale > best.scale)
            best = top;
        if (top.promise() - best.scale <= std::max(kScaleStep, kRelativeStep * best.scale))
            break;
        const double quarter = 0.5 * top.size;
        for (const Vec2 &corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)})
            cells.push(cell(top.center + quarter * corner, quarter));
    }
    return best.center.cwiseProduct(half);
}

} // namespace fff
