// Shapes on the sheets, wherever they are: where each lies and which are near a place. Internal to
// nesting.
#pragma once

#include "core/nesting/collision.h"
#include "core/nesting/shape.h"

#include <memory>
#include <optional>
#include <span>

namespace fff::nest {

/// Where a shape lies: its turn, and by how much it is moved.
struct Pose
{
    static constexpr int kFree = -1;

    Vec2 at = Vec2::Zero();
    int turn = 0;                   // index into the shape's turns, or kFree:
    Vec2 direction = Vec2::UnitX(); // cosine and sine
};

/// Sheets lie side by side along x, with gaps between them, so that a place names its sheet. What
/// is not free of a sheet lies on it as an obstacle.
class Board
{
public:
    /// shapes  have to stay as long as this
    Board(std::span<const Shape> shapes, std::vector<Box2> sheets, std::size_t expected);
    Board(const Board &) = delete;
    Board &operator=(const Board &) = delete;

    /// Who asks for count() adds obstacles after everything that moves.
    std::size_t add(std::size_t shape, const Pose &pose);
    void addObstacle(const Shape &shape, const Vec2 &at);
    std::size_t count() const { return m_count; } // of what moves: the first ones
    std::size_t size() const { return m_items.size(); }

    const std::vector<Box2> &sheets() const { return m_sheets; }
    void setSheets(const std::vector<Box2> &sheets) { m_sheets = sheets; }

    const Shape &shape(std::size_t item) const { return *m_items[item].shape; }
    std::size_t shapeIndex(std::size_t item) const { return m_items[item].index; }
    const Pose &pose(std::size_t item) const { return m_items[item].pose; }
    const Vec2 &at(std::size_t item) const { return m_items[item].pose.at; }
    const Posed &posed(std::size_t item) const { return *m_items[item].posed; }
    const Box2 &box(std::size_t item) const { return m_items[item].box; }
    /// On which it lies: that whose middle is nearest along x.
    std::size_t sheetOf(std::size_t item) const { return sheetAt(m_items[item].box.center().x()); }
    std::size_t sheetAt(double x) const;

    void place(std::size_t item, const Pose &pose);
    /// The nearest place on that sheet; none where it is larger than the sheet.
    std::optional<Vec2> within(const Posed &posed, const Vec2 &at, std::size_t sheet) const;

    /// Calls visit(item) once for everything whose box meets this one, until it says true; whether
    /// it did.
    template <class Visit>
    bool anyNear(const Box2 &box, Visit visit) const
    {
        const Cells cells = cellsOf(box);
        ++m_query;
        for (int row = cells.bottom; row <= cells.top; ++row)
            for (int column = cells.left; column <= cells.right; ++column)
                for (const int item : m_buckets[bucket(column, row)]) {
                    const auto index = static_cast<std::size_t>(item);
                    if (m_seen[index] == m_query)
                        continue;
                    m_seen[index] = m_query;
                    if (m_items[index].box.intersects(box) && visit(index))
                        return true;
                }
        return false;
    }

private:
    struct Item
    {
        const Shape *shape = nullptr;
        std::size_t index = 0; // of the shape; of an obstacle none
        Pose pose;
        const Posed *posed = nullptr;
        std::unique_ptr<Posed> own; // where it is turned freely
        Box2 box;
    };
    struct Cells
    {
        int left, bottom, right, top;
    };

    Cells cellsOf(const Box2 &box) const;
    std::size_t bucket(int column, int row) const
    {
        return static_cast<std::size_t>(row * m_columns + column);
    }
    void enter(std::size_t item);
    void leave(std::size_t item);

    std::span<const Shape> m_shapes;
    std::vector<Box2> m_sheets;
    std::vector<Item> m_items;
    std::size_t m_count = 0;
    Vec2 m_origin = Vec2::Zero(), m_cell = Vec2::Ones();
    int m_columns = 1, m_rows = 1;
    std::vector<std::vector<int>> m_buckets;
    mutable std::vector<std::uint32_t> m_seen;
    mutable std::uint32_t m_query = 0;
};

} // namespace fff::nest
