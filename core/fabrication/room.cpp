#include "core/fabrication/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace fff {

namespace {

// Shares of the box and of the best found so far below which a better place is not looked for.
constexpr double kScaleStep = 0.1;
constexpr double kRelativeStep = 0.05;
// Share of the box by which the boundary that is searched may be off the real one.
constexpr double kSearchChord = 0.02;
// Vertices that are left out in a row at most.
constexpr std::size_t kMaxRun = 16;
// A part that is a thousand times longer than wide is searched more coarsely.
constexpr double kMaxFirstCells = 1024.0;
// Cells of the grid in one direction at most.
constexpr double kMaxGridSide = 1024.0;

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

/// Distance in the same sense from a point to a box: negative inside, to its boundary.
double squareDistance(const Vec2 &point, const Box2 &box)
{
    return (box.min - point).cwiseMax(point - box.max).maxCoeff();
}

/// Whether a ray from the point along +x crosses the edge.
bool rayCrosses(const Vec2 &point, const Vec2 &a, const Vec2 &b)
{
    return (a.y() > point.y()) != (b.y() > point.y()) &&
           point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

/// The ring with fewer vertices, none of those left out farther than `tolerance` from the chord
/// that stands for it.
Polygon simplified(const Polygon &ring, double tolerance)
{
    const auto isNear = [&](const Vec2 &p, const Vec2 &a, const Vec2 &b) {
        const Vec2 chord = b - a;
        const double length = chord.norm(), along = chord.dot(p - a);
        return along >= 0.0 && along <= length * length &&
               std::abs(cross(chord, p - a)) <= tolerance * length;
    };
    Polygon result;
    for (std::size_t i = 0; i < ring.size();) {
        result.push_back(ring[i]);
        std::size_t next = i + 1;
        while (
            next < ring.size() && next - i < kMaxRun &&
            std::all_of(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                        ring.begin() + static_cast<std::ptrdiff_t>(next) + 1, [&](const Vec2 &p) {
                            return isNear(p, ring[i], ring[next + 1 < ring.size() ? next + 1 : 0]);
                        }))
            ++next;
        i = next;
    }
    return result;
}

/// A square of the search.
struct Cell
{
    Vec2 center = Vec2::Zero();
    double size = 0.0; // half of its side
    double scale = 0.0;
    // Of the edges and boxes that matter to it, in the pools.
    std::uint32_t firstEdge = 0, edges = 0, firstBox = 0, boxes = 0;

    double promise() const { return scale + size; }
    bool operator<(const Cell &other) const { return promise() < other.promise(); }
};

/// The search for the roomiest point, in units of the box: there the factor is a distance, and no
/// point within r of another one has a factor larger by more than r.
class RoomSearch
{
public:
    void addRing(const Polygon &ring)
    {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            m_edges.push_back({ring[j], ring[i]});
    }
    void addTaken(const Box2 &box) { m_boxes.push_back(box); }

    Vec2 roomiest(const Vec2 &low, const Vec2 &extent, double enough);

private:
    struct Edge
    {
        Vec2 from, to;

        Box2 box() const { return {from.cwiseMin(to), from.cwiseMax(to)}; }
    };

    /// Less than this a place must be better to be looked for.
    double step() const { return std::max(kScaleStep, kRelativeStep * m_best.scale); }
    void look(const Vec2 &center, double size, const Cell *parent);
    bool isInside(const Vec2 &point) const;
    void keepRelevant(Cell &cell);

    // Those of the region, then those that matter to cells.
    std::vector<Edge> m_edges;
    std::vector<Box2> m_boxes;
    std::uint32_t m_edgeCount = 0, m_boxCount = 0;
    std::priority_queue<Cell> m_cells;
    Cell m_best{Vec2::Zero(), 0.0, -std::numeric_limits<double>::infinity(), 0, 0, 0, 0};
};

bool RoomSearch::isInside(const Vec2 &point) const
{
    bool inside = false;
    for (std::uint32_t i = 0; i < m_edgeCount; ++i)
        inside ^= rayCrosses(point, m_edges[i].from, m_edges[i].to);
    return inside;
}

/// Queues the cell if there can be a better place in it.
void RoomSearch::look(const Vec2 &center, double size, const Cell *parent)
{
    Cell cell{center, size, 0.0, 0, m_edgeCount, 0, m_boxCount};
    if (parent) {
        cell.firstEdge = parent->firstEdge;
        cell.edges = parent->edges;
        cell.firstBox = parent->firstBox;
        cell.boxes = parent->boxes;
    }
    // What is left of it below this does not matter.
    const double least = m_best.scale + step() - size;
    double scale = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < cell.boxes; ++i)
        scale = std::min(scale, squareDistance(center, m_boxes[cell.firstBox + i]));
    for (std::uint32_t i = 0; i < cell.edges && scale > least; ++i) {
        const Edge &e = m_edges[cell.firstEdge + i];
        if (squareDistance(center, e.box()) < scale)
            scale = std::min(scale, squareDistance(e.from - center, e.to - center));
    }
    if (scale <= least)
        return;
    // Where the parent's middle is farther from every edge than from here, both are on one side.
    const bool staysInside = parent && parent->scale > size;
    cell.scale = staysInside || isInside(center) ? scale : -std::abs(scale);
    if (cell.scale > m_best.scale)
        m_best = cell;
    if (cell.promise() > m_best.scale + step())
        m_cells.push(cell);
}

/// Of the edges and boxes of its parent, those that can be the nearest to some point of the cell.
void RoomSearch::keepRelevant(Cell &cell)
{
    const double reach = std::abs(cell.scale) + 2.0 * cell.size;
    const auto firstEdge = static_cast<std::uint32_t>(m_edges.size());
    for (std::uint32_t i = 0; i < cell.edges; ++i) {
        const Edge edge = m_edges[cell.firstEdge + i];
        if (squareDistance(cell.center, edge.box()) <= reach)
            m_edges.push_back(edge);
    }
    const auto firstBox = static_cast<std::uint32_t>(m_boxes.size());
    for (std::uint32_t i = 0; i < cell.boxes; ++i) {
        const Box2 box = m_boxes[cell.firstBox + i];
        if (squareDistance(cell.center, box) <= reach)
            m_boxes.push_back(box);
    }
    cell.firstEdge = firstEdge;
    cell.edges = static_cast<std::uint32_t>(m_edges.size()) - firstEdge;
    cell.firstBox = firstBox;
    cell.boxes = static_cast<std::uint32_t>(m_boxes.size()) - firstBox;
}

Vec2 RoomSearch::roomiest(const Vec2 &low, const Vec2 &extent, double enough)
{
    m_edgeCount = static_cast<std::uint32_t>(m_edges.size());
    m_edges.reserve(8 * m_edges.size());
    m_boxCount = static_cast<std::uint32_t>(m_boxes.size());
    look(low + 0.5 * extent, 0.0, nullptr);
    const double side = std::max(extent.minCoeff(), extent.maxCoeff() / kMaxFirstCells);
    for (double x = 0.5 * side; x < extent.x() + 0.5 * side && m_best.scale < enough; x += side) {
        for (double y = 0.5 * side; y < extent.y() + 0.5 * side && m_best.scale < enough; y += side)
            look(low + Vec2(x, y), 0.5 * side, nullptr);
    }
    while (!m_cells.empty() && m_best.scale < enough) {
        Cell top = m_cells.top();
        m_cells.pop();
        if (top.promise() <= m_best.scale + step())
            break;
        keepRelevant(top);
        const double quarter = 0.5 * top.size;
        for (const Vec2 &corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(-1, 1), Vec2(1, 1)})
            look(top.center + quarter * corner, quarter, &top);
    }
    return m_best.center;
}

} // namespace

Room::Room(Region from) : m_region(std::move(from))
{
    const Region &region = m_region;
    std::size_t count = region.outer.size();
    for (const Polygon &hole : region.holes)
        count += hole.size();
    m_edges.reserve(count);
    const auto addRing = [this](const Polygon &ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            m_edges.push_back({ring[j], ring[i]});
    };
    addRing(region.outer);
    for (const Polygon &hole : region.holes)
        addRing(hole);
    m_bounds = bounds(region.outer);
    for (const Polygon &hole : region.holes)
        m_bounds.extend(bounds(hole));
    sortIntoCells();
}

Room::Cells Room::cellsOf(const Box2 &box) const
{
    const auto index = [this](double offset, int count) {
        return static_cast<int>(std::clamp(offset / m_cell, 0.0, count - 1.0));
    };
    return {index(box.min.x() - m_bounds.min.x(), m_columns),
            index(box.max.x() - m_bounds.min.x(), m_columns),
            index(box.min.y() - m_bounds.min.y(), m_rows),
            index(box.max.y() - m_bounds.min.y(), m_rows)};
}

void Room::sortIntoCells()
{
    const Vec2 size = m_bounds.size();
    m_cell = std::max({std::sqrt(size.x() * size.y() / static_cast<double>(m_edges.size())),
                       size.maxCoeff() / kMaxGridSide, std::numeric_limits<double>::min()});
    m_columns = static_cast<int>(size.x() / m_cell) + 1;
    m_rows = static_cast<int>(size.y() / m_cell) + 1;
    m_cellStart.assign(cellAt(0, m_rows) + 1, 0);
    m_rowStart.assign(static_cast<std::size_t>(m_rows) + 1, 0);
    m_takenInCell.resize(cellAt(0, m_rows));
    std::vector<Cells> cells;
    cells.reserve(m_edges.size());
    for (const Edge &edge : m_edges) {
        Box2 box{edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to)};
        cells.push_back(cellsOf(box));
    }
    // Counted, summed up, and filled from behind.
    const auto forAll = [&](const auto &visitCell, const auto &visitRow) {
        for (std::uint32_t i = 0; i < cells.size(); ++i) {
            for (int row = cells[i].bottom; row <= cells[i].top; ++row) {
                visitRow(static_cast<std::size_t>(row), i);
                for (int column = cells[i].left; column <= cells[i].right; ++column)
                    visitCell(cellAt(column, row), i);
            }
        }
    };
    forAll([this](std::size_t cell, std::uint32_t) { ++m_cellStart[cell]; },
           [this](std::size_t row, std::uint32_t) { ++m_rowStart[row]; });
    std::partial_sum(m_cellStart.begin(), m_cellStart.end(), m_cellStart.begin());
    std::partial_sum(m_rowStart.begin(), m_rowStart.end(), m_rowStart.begin());
    m_inCell.resize(m_cellStart.back());
    m_inRow.resize(m_rowStart.back());
    forAll([this](std::size_t cell, std::uint32_t i) { m_inCell[--m_cellStart[cell]] = i; },
           [this](std::size_t row, std::uint32_t i) { m_inRow[--m_rowStart[row]] = i; });
}

void Room::take(const Box2 &box)
{
    const Cells cells = cellsOf(box);
    for (int row = cells.bottom; row <= cells.top; ++row) {
        for (int column = cells.left; column <= cells.right; ++column)
            m_takenInCell[cellAt(column, row)].push_back(
                static_cast<std::uint32_t>(m_taken.size()));
    }
    m_taken.push_back(box);
}

bool Room::isInside(const Vec2 &point) const
{
    // Rounding does not matter: who asks has found no edge close by.
    const auto row = static_cast<std::size_t>(cellsOf({point, point}).bottom);
    bool inside = false;
    for (std::uint32_t i = m_rowStart[row]; i < m_rowStart[row + 1]; ++i)
        inside ^= rayCrosses(point, m_edges[m_inRow[i]].from, m_edges[m_inRow[i]].to);
    return inside;
}

bool Room::fits(const Vec2 &center, const Vec2 &half) const
{
    const Box2 box{center - half, center + half};
    if ((box.min.array() < m_bounds.min.array()).any() ||
        (box.max.array() > m_bounds.max.array()).any())
        return false;
    const Vec2 toScale = half.cwiseInverse();
    const Cells cells = cellsOf(box);
    for (int row = cells.bottom; row <= cells.top; ++row) {
        for (int column = cells.left; column <= cells.right; ++column) {
            const std::size_t cell = cellAt(column, row);
            for (const std::uint32_t i : m_takenInCell[cell]) {
                if ((box.min.array() < m_taken[i].max.array()).all() &&
                    (m_taken[i].min.array() < box.max.array()).all())
                    return false;
            }
            for (std::uint32_t i = m_cellStart[cell]; i < m_cellStart[cell + 1]; ++i) {
                const Edge &e = m_edges[m_inCell[i]];
                if (squareDistance((e.from - center).cwiseProduct(toScale),
                                   (e.to - center).cwiseProduct(toScale)) < 1.0)
                    return false;
            }
        }
    }
    return isInside(center);
}

double Room::scaleAt(const Vec2 &center, const Vec2 &half) const
{
    const Vec2 toScale = half.cwiseInverse();
    double scale = std::numeric_limits<double>::infinity();
    for (const Edge &e : m_edges)
        scale = std::min(scale, squareDistance((e.from - center).cwiseProduct(toScale),
                                               (e.to - center).cwiseProduct(toScale)));
    if (!isInside(center))
        scale = -scale;
    for (const Box2 &box : m_taken) {
        const Box2 scaled{(box.min - center).cwiseProduct(toScale),
                          (box.max - center).cwiseProduct(toScale)};
        scale = std::min(scale, squareDistance(Vec2::Zero(), scaled));
    }
    return scale;
}

Vec2 Room::roomiest(const Vec2 &half, double enough) const
{
    const Vec2 toScale = half.cwiseInverse();
    const auto scaled = [&](Polygon ring) {
        for (Vec2 &p : ring)
            p = p.cwiseProduct(toScale);
        return simplified(ring, kSearchChord);
    };
    RoomSearch search;
    search.addRing(scaled(m_region.outer));
    for (const Polygon &hole : m_region.holes)
        search.addRing(scaled(hole));
    for (const Box2 &box : m_taken)
        search.addTaken({box.min.cwiseProduct(toScale), box.max.cwiseProduct(toScale)});
    return search
        .roomiest(m_bounds.min.cwiseProduct(toScale), m_bounds.size().cwiseProduct(toScale), enough)
        .cwiseProduct(half);
}

} // namespace fff
