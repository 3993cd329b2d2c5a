#include "core/nesting/board.h"

#include <algorithm>
#include <cmath>

namespace fff::nest {

namespace {

/// Cells of about the size of what is expected to lie there, but not too many.
constexpr double kMostCells = 200.0; // along one side
/// mm: what is divided by is no less, where shapes or sheets have no size at all.
constexpr double kNoSize = 1e-9;

} // namespace

Board::Board(std::span<const Shape> shapes, std::vector<Box2> sheets, std::size_t expected)
    : m_shapes(shapes), m_sheets(std::move(sheets))
{
    Box2 all;
    for (const Box2 &sheet : m_sheets)
        all.extend(sheet);
    double side = 0.0;
    for (const Shape &shape : shapes)
        side += shape.diameter;
    side /= static_cast<double>(std::max<std::size_t>(1, shapes.size()));
    const Vec2 size = all.size();
    const auto cellsAlong = [&](double length) {
        const double most = std::min(kMostCells, 2.0 + static_cast<double>(expected));
        return std::max(1,
                        static_cast<int>(std::min(most, 1.5 * length / std::max(side, kNoSize))));
    };
    m_origin = all.min;
    m_columns = cellsAlong(size.x());
    m_rows = cellsAlong(size.y());
    m_cell = size.cwiseQuotient(Vec2(m_columns, m_rows)).cwiseMax(kNoSize);
    m_buckets.resize(static_cast<std::size_t>(m_columns * m_rows));
}

std::size_t Board::add(std::size_t shape, const Pose &pose)
{
    m_items.emplace_back();
    m_items.back().shape = &m_shapes[shape];
    m_items.back().index = shape;
    m_seen.push_back(0);
    ++m_count;
    place(m_items.size() - 1, pose);
    return m_items.size() - 1;
}

void Board::addObstacle(const Shape &shape, const Vec2 &at)
{
    m_items.emplace_back();
    m_items.back().shape = &shape;
    m_seen.push_back(0);
    Pose pose;
    pose.at = at;
    place(m_items.size() - 1, pose);
}

std::size_t Board::sheetAt(double x) const
{
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < m_sheets.size(); ++i) {
        const double away = std::max({0.0, m_sheets[i].min.x() - x, x - m_sheets[i].max.x()});
        if (away < least) {
            least = away;
            nearest = i;
        }
    }
    return nearest;
}

void Board::place(std::size_t item, const Pose &pose)
{
    Item &placed = m_items[item];
    if (placed.posed)
        leave(item);
    if (pose.turn == Pose::kFree) {
        if (!placed.own)
            placed.own = std::make_unique<Posed>();
        if (placed.own->edges.empty() || placed.own->turn != pose.direction)
            fff::nest::pose(placed.shape->outline, placed.shape->poles, pose.direction,
                            *placed.own);
        placed.posed = placed.own.get();
    } else {
        placed.posed = &placed.shape->turns[static_cast<std::size_t>(pose.turn)];
    }
    placed.pose = pose;
    placed.box = {placed.posed->box.min + pose.at, placed.posed->box.max + pose.at};
    enter(item);
}

std::optional<Vec2> Board::within(const Posed &posed, const Vec2 &at, std::size_t sheet) const
{
    const Vec2 low = m_sheets[sheet].min - posed.box.min,
               high = m_sheets[sheet].max - posed.box.max;
    if (low.x() > high.x() || low.y() > high.y())
        return std::nullopt;
    return Vec2(at.cwiseMax(low).cwiseMin(high));
}

Board::Cells Board::cellsOf(const Box2 &box) const
{
    const auto column = [&](double x) {
        return static_cast<int>(std::clamp((x - m_origin.x()) / m_cell.x(), 0.0, m_columns - 1.0));
    };
    const auto row = [&](double y) {
        return static_cast<int>(std::clamp((y - m_origin.y()) / m_cell.y(), 0.0, m_rows - 1.0));
    };
    return {column(box.min.x()), row(box.min.y()), column(box.max.x()), row(box.max.y())};
}

void Board::enter(std::size_t item)
{
    const Cells cells = cellsOf(m_items[item].box);
    for (int row = cells.bottom; row <= cells.top; ++row)
        for (int column = cells.left; column <= cells.right; ++column)
            m_buckets[bucket(column, row)].push_back(static_cast<int>(item));
}

void Board::leave(std::size_t item)
{
    const Cells cells = cellsOf(m_items[item].box);
    for (int row = cells.bottom; row <= cells.top; ++row)
        for (int column = cells.left; column <= cells.right; ++column) {
            std::vector<int> &items = m_buckets[bucket(column, row)];
            const auto found = std::find(items.begin(), items.end(), static_cast<int>(item));
            *found = items.back();
            items.pop_back();
        }
}

} // namespace fff::nest
