#include "core/nesting/filling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff::nest {

namespace {

/// One turn of a shape that looks for its place on a sheet.
class Lodger
{
public:
    Lodger(const Board &board, const Posed &posed, const Box2 &sheet, Meter &meter)
        : m_board(board), m_posed(posed), m_low(sheet.min - posed.box.min),
          m_high(sheet.max - posed.box.max), m_meter(meter)
    {
    }

    bool fits() const { return m_low.x() <= m_high.x() && m_low.y() <= m_high.y(); }

    /// In the row at that height, above the lower edge; none beyond `most`, of its right end.
    /// start  where to begin; becomes how far there is no place
    std::optional<Vec2> inRow(double above, double most, double &start) const
    {
        Vec2 at(std::max(m_low.x(), start), m_low.y() + above);
        const double end = std::min(m_high.x(), most - m_posed.box.max.x());
        // Where rounding sees no way out of what is met, farther and farther.
        double nudge = leastWay();
        while (at.x() <= end) {
            const auto isInWay = [&](std::size_t item) {
                if (!collide(m_posed, m_board.posed(item), at - m_board.at(item), m_meter.used))
                    return false;
                const double out = way(item, at);
                at.x() += std::max(nudge, out);
                if (out < nudge)
                    nudge *= 2.0;
                return true;
            };
            m_meter.used += 8;
            const bool isInWayOfAny = m_board.anyNear(boxAt(at), isInWay);
            start = at.x();
            if (!isInWayOfAny)
                return at;
        }
        return std::nullopt;
    }

    /// Down and to the left in turns, from a free place.
    Vec2 settled(Vec2 at, int times) const
    {
        for (int i = 0; i < times; ++i) {
            const double down = free(at, Axis::Y, at.y() - m_low.y());
            at.y() -= down;
            const double left = free(at, Axis::X, at.x() - m_low.x());
            at.x() -= left;
            if (down + left < leastWay())
                break;
        }
        return at;
    }

    double roomAbove() const { return m_high.y() - m_low.y(); }
    double rightEnd(const Vec2 &at) const { return at.x() + m_posed.box.max.x(); }

    /// How far it can go, less what rounding asks for.
    double free(const Vec2 &at, Axis axis, double most) const
    {
        if (!(most > 0.0))
            return 0.0;
        Box2 swept = boxAt(at);
        (axis == Axis::X ? swept.min.x() : swept.min.y()) -= most;
        double way = most;
        m_board.anyNear(swept, [&](std::size_t item) {
            if (&m_board.posed(item) == &m_posed && m_board.at(item) == at)
                return false; // itself
            way = std::min(way, wayDown(m_posed, m_board.posed(item), at - m_board.at(item), axis,
                                        way, m_meter.used));
            return false;
        });
        return way < most ? std::max(0.0, way - leastWay()) : most;
    }

private:
    double way(std::size_t item, const Vec2 &at) const
    {
        return wayOut(m_posed, m_board.posed(item), at - m_board.at(item), Axis::X, m_meter.used);
    }
    Box2 boxAt(const Vec2 &at) const { return {m_posed.box.min + at, m_posed.box.max + at}; }
    /// More than rounding.
    double leastWay() const
    {
        constexpr double kPartly = 1e-11;
        return kPartly * (1.0 + m_posed.box.size().maxCoeff() + m_low.cwiseAbs().maxCoeff());
    }

    const Board &m_board;
    const Posed &m_posed;
    Vec2 m_low, m_high;
    Meter &m_meter;
};

} // namespace

std::optional<Pose> leftmost(const Board &board, const Shape &shape, std::size_t sheet,
                             const Filling &filling, RowStarts &starts, Meter &meter)
{
    std::optional<Pose> best;
    double most = std::numeric_limits<double>::infinity();
    const std::size_t count = shape.turns.size();
    const auto rows = static_cast<std::size_t>(filling.rows);
    starts.at.resize(count * rows, -std::numeric_limits<double>::infinity());
    for (std::size_t turn = count - std::min(count, filling.turns); turn < count; ++turn) {
        const Lodger lodger(board, shape.turns[turn], board.sheets()[sheet], meter);
        if (!lodger.fits())
            continue;
        for (std::size_t row = 0; row < rows; ++row) {
            const double above = lodger.roomAbove() * static_cast<double>(row) /
                                 static_cast<double>(std::max<std::size_t>(1, rows - 1));
            const std::optional<Vec2> found =
                lodger.inRow(above, most, starts.at[turn * rows + row]);
            if (!found)
                continue;
            const Vec2 at = lodger.settled(*found, filling.settling);
            if (lodger.rightEnd(at) < most) {
                most = lodger.rightEnd(at);
                best.emplace();
                best->at = at;
                best->turn = static_cast<int>(turn);
            }
        }
    }
    return best;
}

void slideLeft(Board &board, std::size_t sheet, Meter &meter)
{
    std::vector<std::pair<double, std::size_t>> items;
    for (std::size_t item = 0; item < board.count(); ++item)
        if (board.sheetOf(item) == sheet)
            items.emplace_back(board.box(item).min.x(), item);
    std::sort(items.begin(), items.end());
    const double edge = board.sheets()[sheet].min.x();
    for (const auto &[left, item] : items) {
        const Lodger lodger(board, board.posed(item), board.sheets()[sheet], meter);
        Pose pose = board.pose(item);
        pose.at.x() -= lodger.free(pose.at, Axis::X, left - edge);
        board.place(item, pose);
    }
}

} // namespace fff::nest
