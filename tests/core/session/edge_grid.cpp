#include "tests/core/session/edge_grid.h"

#include <algorithm>
#include <cmath>

namespace fff::test {

namespace {

constexpr double kCell = 2.0; // mm

double toSegment(const Vec2 &p, const Vec2 &from, const Vec2 &to)
{
    const Vec2 along = to - from;
    const double length = along.squaredNorm();
    const double share = length > 0.0 ? std::clamp(along.dot(p - from) / length, 0.0, 1.0) : 0.0;
    return (p - from - share * along).norm();
}

} // namespace

EdgeGrid::EdgeGrid(const PlainRing &outer, const std::vector<PlainRing> &holes)
{
    const auto add = [this](const PlainRing &ring) {
        for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++)
            m_edges.push_back({ring[k], ring[i]});
    };
    add(outer);
    for (const PlainRing &hole : holes)
        add(hole);
    m_min = m_max = outer.front();
    for (const Vec2 &p : outer) {
        m_min = m_min.cwiseMin(p);
        m_max = m_max.cwiseMax(p);
    }
    m_columns = 1 + static_cast<int>((m_max.x() - m_min.x()) / kCell);
    m_rows = 1 + static_cast<int>((m_max.y() - m_min.y()) / kCell);
    // Counted first, then entered.
    m_ofRows.starts.assign(static_cast<std::size_t>(m_rows) + 1, 0);
    m_ofCells.starts.assign(static_cast<std::size_t>(m_rows * m_columns) + 1, 0);
    const auto forEachEntry = [this](auto row, auto cell) {
        for (std::size_t i = 0; i < m_edges.size(); ++i) {
            const Edge &edge = m_edges[i];
            const auto [low, high] = std::minmax(edge.from.y(), edge.to.y());
            for (int r = rowOf(low); r <= rowOf(high); ++r)
                row(static_cast<std::size_t>(r), static_cast<int>(i));
            forEachCell(edge, [&](std::size_t c) { cell(c, static_cast<int>(i)); });
        }
    };
    forEachEntry([&](std::size_t r, int) { ++m_ofRows.starts[r + 1]; },
                 [&](std::size_t c, int) { ++m_ofCells.starts[c + 1]; });
    for (Lists *lists : {&m_ofRows, &m_ofCells}) {
        for (std::size_t i = 1; i < lists->starts.size(); ++i)
            lists->starts[i] += lists->starts[i - 1];
        lists->edges.resize(static_cast<std::size_t>(lists->starts.back()));
    }
    std::vector<int> nextOfRow = m_ofRows.starts, nextOfCell = m_ofCells.starts;
    forEachEntry(
        [&](std::size_t r, int i) { m_ofRows.edges[static_cast<std::size_t>(nextOfRow[r]++)] = i; },
        [&](std::size_t c, int i) {
            m_ofCells.edges[static_cast<std::size_t>(nextOfCell[c]++)] = i;
        });
}

int EdgeGrid::columnOf(double x) const
{
    return static_cast<int>(std::clamp(std::floor((x - m_min.x()) / kCell), 0.0, m_columns - 1.0));
}

int EdgeGrid::rowOf(double y) const
{
    return static_cast<int>(std::clamp(std::floor((y - m_min.y()) / kCell), 0.0, m_rows - 1.0));
}

/// Of each row that the edge passes, the cells from where it enters to where it leaves.
template <class Visit>
void EdgeGrid::forEachCell(const Edge &edge, Visit visit) const
{
    const bool rises = edge.from.y() <= edge.to.y();
    const Vec2 &low = rises ? edge.from : edge.to, &high = rises ? edge.to : edge.from;
    const double height = high.y() - low.y();
    const auto xAt = [&](double y) {
        const double share = height > 0.0 ? std::clamp((y - low.y()) / height, 0.0, 1.0) : 0.0;
        return low.x() + share * (high.x() - low.x());
    };
    constexpr double kSlack = 1e-6; // mm: an edge on a line between two cells is in both
    for (int r = rowOf(low.y() - kSlack); r <= rowOf(high.y() + kSlack); ++r) {
        const double bottom = m_min.y() + r * kCell;
        double left = xAt(bottom - kSlack), right = xAt(bottom + kCell + kSlack);
        if (height == 0.0)
            right = high.x();
        for (int c = columnOf(std::min(left, right) - kSlack);
             c <= columnOf(std::max(left, right) + kSlack); ++c)
            visit(static_cast<std::size_t>(r * m_columns + c));
    }
}

bool EdgeGrid::isInside(const Vec2 &p) const
{
    if ((p.array() < m_min.array()).any() || (p.array() > m_max.array()).any())
        return false;
    const auto row = static_cast<std::size_t>(rowOf(p.y()));
    bool isIn = false;
    for (int k = m_ofRows.starts[row]; k < m_ofRows.starts[row + 1]; ++k) {
        const Edge &edge =
            m_edges[static_cast<std::size_t>(m_ofRows.edges[static_cast<std::size_t>(k)])];
        if ((edge.from.y() > p.y()) == (edge.to.y() > p.y()))
            continue;
        const double share = (p.y() - edge.from.y()) / (edge.to.y() - edge.from.y());
        isIn ^= p.x() < edge.from.x() + share * (edge.to.x() - edge.from.x());
    }
    return isIn;
}

double EdgeGrid::distance(const Vec2 &p, double limit) const
{
    const Vec2 reach = Vec2::Constant(limit);
    if ((p.array() < (m_min - reach).array()).any() || (p.array() > (m_max + reach).array()).any())
        return limit;
    double nearest = limit;
    for (int r = rowOf(p.y() - limit); r <= rowOf(p.y() + limit); ++r) {
        for (int c = columnOf(p.x() - limit); c <= columnOf(p.x() + limit); ++c) {
            const auto cell = static_cast<std::size_t>(r * m_columns + c);
            for (int k = m_ofCells.starts[cell]; k < m_ofCells.starts[cell + 1]; ++k) {
                const Edge &edge =
                    m_edges[static_cast<std::size_t>(m_ofCells.edges[static_cast<std::size_t>(k)])];
                nearest = std::min(nearest, toSegment(p, edge.from, edge.to));
            }
        }
    }
    return nearest;
}

} // namespace fff::test
