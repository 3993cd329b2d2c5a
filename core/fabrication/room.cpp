#include "core/fabrication/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace fff {

namespace {

// Shares of the box and of the best found so far below which a better place is not looked for.
constexpr double kScaleStep = 0.1;
constexpr double kRelativeStep = 0.05;
// A part that is a thousand times longer than wide is searched more coarsely.
constexpr double kMaxFirstCells = 1024.0;
// Rows are tried at halves, quarters and so on up to one over this.
constexpr int kFinestRow = 4;

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
        // It is zero between the ends only when it changes its sign there.
        if (value * (value + slope) >= 0.0)
            continue;
        nearest = std::min(nearest, Vec2(a - (value / slope) * d).cwiseAbs().maxCoeff());
    }
    return nearest;
}

/// Distance in the same sense from the origin to a box: negative inside, to its boundary.
double squareDistance(const Box2 &box)
{
    return std::max(std::max(box.min.x(), -box.max.x()), std::max(box.min.y(), -box.max.y()));
}

/// Whether the insides of two boxes have something in common.
bool overlap(const Box2 &a, const Box2 &b)
{
    return a.min.x() < b.max.x() && b.min.x() < a.max.x() && a.min.y() < b.max.y() &&
           b.min.y() < a.max.y();
}

/// Whether a ray from the point along +x crosses the edge.
bool rayCrosses(const Vec2 &point, const Vec2 &a, const Vec2 &b)
{
    return (a.y() > point.y()) != (b.y() > point.y()) &&
           point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

/// A square of the search, in units of the box: there the factor is a distance, and no point within
/// r of another one has a factor larger by more than r.
struct Cell
{
    Vec2 center = Vec2::Zero();
    double size = 0.0; // half of its side
    double scale = -std::numeric_limits<double>::infinity();
    std::size_t nearest = 0; // edge

    double promise() const { return scale + size; }
    bool operator<(const Cell &other) const { return promise() < other.promise(); }
};

/// More than this a place must be better to be looked for.
double stepFrom(double scale)
{
    return std::max(kScaleStep, kRelativeStep * scale);
}

} // namespace

Room::Room(const Region &region)
{
    std::size_t count = region.outer.size();
    for (const Polygon &hole : region.holes)
        count += hole.size();
    m_edges.resize(count);
    auto addRing = [this, next = m_edges.begin()](const Polygon &ring) mutable {
        m_ringStarts.push_back(static_cast<std::size_t>(next - m_edges.begin()));
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            *next++ = {ring[j], ring[i]};
    };
    addRing(region.outer);
    for (const Polygon &hole : region.holes)
        addRing(hole);
    m_edgeBoxes.fill(count, [this](std::size_t i) {
        const Edge &e = m_edges[i];
        return Box2{e.from.cwiseMin(e.to), e.from.cwiseMax(e.to)};
    });
    m_bounds = m_edgeBoxes.bounds();
}

void Room::take(const Box2 &box)
{
    m_taken.push_back(box);
    m_takenBoxes.add(box);
}

void Room::giveBack(std::size_t count)
{
    m_taken.resize(count);
    m_takenBoxes.fill(count, [this](std::size_t i) { return m_taken[i]; });
}

bool Room::isInside(const Vec2 &point) const
{
    // Rounding does not matter: who asks has found no edge close by.
    bool inside = false;
    const auto isOneRing = [this](std::size_t first, std::size_t end) {
        const auto next = std::upper_bound(m_ringStarts.begin(), m_ringStarts.end(), first);
        return next == m_ringStarts.end() || *next >= end;
    };
    m_edgeBoxes.walk(
        [&](const Box2 &box, std::size_t first, std::size_t end) {
            if (!(box.min.y() <= point.y() && point.y() < box.max.y() && point.x() <= box.max.x()))
                return false;
            if (point.x() >= box.min.x() || !isOneRing(first, end))
                return true;
            // All to the right: crossed an odd number of times where its ends are on different
            // sides.
            inside ^=
                (m_edges[first].from.y() > point.y()) != (m_edges[end - 1].to.y() > point.y());
            return false;
        },
        [&](std::size_t i) {
            inside ^= rayCrosses(point, m_edges[i].from, m_edges[i].to);
            return false;
        });
    return inside;
}

bool Room::fits(const Vec2 &center, const Vec2 &half) const
{
    const Box2 box{center - half, center + half};
    if ((box.min.array() < m_bounds.min.array()).any() ||
        (box.max.array() > m_bounds.max.array()).any())
        return false;
    const auto isNear = [&box](const Box2 &other) { return overlap(box, other); };
    if (m_takenBoxes.any(isNear, [&](std::size_t i) { return overlap(box, m_taken[i]); }))
        return false;
    // Edges are boxes that overlap, and are not wholly to one side of the edge.
    const auto reachesInto = [&](std::size_t i) {
        const Edge &e = m_edges[i];
        if (std::max(e.from.x(), e.to.x()) <= box.min.x() ||
            std::min(e.from.x(), e.to.x()) >= box.max.x() ||
            std::max(e.from.y(), e.to.y()) <= box.min.y() ||
            std::min(e.from.y(), e.to.y()) >= box.max.y())
            return false;
        const Vec2 along = e.to - e.from;
        return std::abs(cross(along, center - e.from)) <
               half.x() * std::abs(along.y()) + half.y() * std::abs(along.x());
    };
    return !m_edgeBoxes.any(isNear, reachesInto) && isInside(center);
}

/// The factor, if it is more than `least`; else something that is not.
/// nearest   the edge that is likely to be the nearest; becomes that which is
double Room::clearScale(const Vec2 &center, const Vec2 &toScale, double least,
                        std::size_t &nearest) const
{
    const auto scaled = [&](const Box2 &box) {
        return Box2{(box.min - center).cwiseProduct(toScale),
                    (box.max - center).cwiseProduct(toScale)};
    };
    double scale = std::numeric_limits<double>::infinity();
    const auto isNear = [&](const Box2 &box) { return squareDistance(scaled(box)) < scale; };
    const auto lookAt = [&](std::size_t i) {
        const Vec2 from = (m_edges[i].from - center).cwiseProduct(toScale);
        const Vec2 to = (m_edges[i].to - center).cwiseProduct(toScale);
        if (squareDistance({from.cwiseMin(to), from.cwiseMax(to)}) >= scale)
            return false;
        if (const double distance = squareDistance(from, to); distance < scale) {
            scale = distance;
            nearest = i;
        }
        return scale <= least;
    };
    if (lookAt(nearest) || m_edgeBoxes.any(isNear, lookAt))
        return scale;
    m_takenBoxes.any(isNear, [&](std::size_t i) {
        scale = std::min(scale, squareDistance(scaled(m_taken[i])));
        return scale <= least;
    });
    return scale;
}

double Room::scaleAt(const Vec2 &center, const Vec2 &half) const
{
    std::size_t nearest = 0;
    const double scale =
        clearScale(center, half.cwiseInverse(), -std::numeric_limits<double>::infinity(), nearest);
    return isInside(center) ? scale : -std::abs(scale);
}

/// Where the row of the box's height about y is free, widest first; also outside of the region.
std::vector<Room::Gap> Room::gapsInRow(double y, const Vec2 &half) const
{
    const double low = y - half.y(), high = y + half.y();
    const auto isNear = [&](const Box2 &box) { return box.min.y() < high && box.max.y() > low; };
    std::vector<Gap> filled;
    m_takenBoxes.any(isNear, [&](std::size_t i) {
        if (isNear(m_taken[i]))
            filled.push_back({m_taken[i].min.x(), m_taken[i].max.x()});
        return false;
    });
    m_edgeBoxes.any(isNear, [&](std::size_t i) {
        const bool isRising = m_edges[i].from.y() <= m_edges[i].to.y();
        const Vec2 &a = isRising ? m_edges[i].from : m_edges[i].to;
        const Vec2 &b = isRising ? m_edges[i].to : m_edges[i].from;
        if (a.y() >= high || b.y() <= low)
            return false;
        const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0.0;
        const double first = a.y() < low ? a.x() + (low - a.y()) * slope : a.x();
        const double last = b.y() > high ? a.x() + (high - a.y()) * slope : b.x();
        filled.push_back({std::min(first, last), std::max(first, last)});
        return false;
    });
    std::sort(filled.begin(), filled.end(),
              [](const Gap &a, const Gap &b) { return a.from < b.from; });
    std::vector<Gap> gaps;
    double reached = std::numeric_limits<double>::infinity(); // nothing is free before the first
    for (const Gap &next : filled) {
        if (next.from - reached > 2.0 * half.x())
            gaps.push_back({reached, next.from});
        reached = std::isinf(reached) ? next.to : std::max(reached, next.to);
    }
    std::sort(gaps.begin(), gaps.end(),
              [](const Gap &a, const Gap &b) { return a.width() > b.width(); });
    return gaps;
}

std::optional<Vec2> Room::findInRows(const Vec2 &half) const
{
    const Vec2 spare = m_bounds.size() - 2.0 * half;
    if (!(spare.minCoeff() > 0.0))
        return std::nullopt;
    for (int rows = 2; rows <= kFinestRow; rows *= 2) {
        for (int row = 1; row < rows; row += 2) {
            const double y = m_bounds.min.y() + half.y() + spare.y() * row / rows;
            for (const Gap &gap : gapsInRow(y, half)) {
                const Vec2 center(0.5 * (gap.from + gap.to), y);
                if (fits(center, half))
                    return center;
            }
        }
    }
    return std::nullopt;
}

Vec2 Room::roomiest(const Vec2 &half, double enough) const
{
    const Vec2 toScale = half.cwiseInverse();
    const Vec2 low = m_bounds.min.cwiseProduct(toScale),
               extent = m_bounds.size().cwiseProduct(toScale);
    std::priority_queue<Cell> cells;
    Cell best;
    // Queues the cell if there can be a better place in it.
    const auto look = [&](const Vec2 &center, double size, const Cell *parent) {
        const double least = best.scale + stepFrom(best.scale) - size;
        const Vec2 place = center.cwiseProduct(half);
        Cell cell{center, size};
        cell.nearest = parent ? parent->nearest : 0;
        cell.scale = clearScale(place, toScale, least, cell.nearest);
        if (cell.scale <= least)
            return;
        // Where the parent's middle is farther from every edge than from here, both are on one
        // side.
        const bool staysInside = parent && parent->scale > size;
        if (!staysInside && !isInside(place))
            cell.scale = -std::abs(cell.scale);
        if (cell.scale > best.scale)
            best = cell;
        if (cell.promise() > best.scale + stepFrom(best.scale))
            cells.push(cell);
    };
    look(low + 0.5 * extent, 0.0, nullptr);
    const double side = std::max(extent.minCoeff(), extent.maxCoeff() / kMaxFirstCells);
    for (double x = 0.5 * side; x < extent.x() + 0.5 * side && best.scale < enough; x += side) {
        for (double y = 0.5 * side; y < extent.y() + 0.5 * side && best.scale < enough; y += side)
            look(low + Vec2(x, y), 0.5 * side, nullptr);
    }
    while (!cells.empty() && best.scale < enough) {
        const Cell top = cells.top();
        cells.pop();
        if (top.promise() <= best.scale + stepFrom(best.scale))
            break;
        const double quarter = 0.5 * top.size;
        for (const Vec2 &corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)})
            look(top.center + quarter * corner, quarter, &top);
    }
    return best.center.cwiseProduct(half);
}

} // namespace fff
