#include "core/nesting/first_layout.h"

#include "core/base/tolerances.h"
#include "core/geometry/turning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>

namespace fff::nest {

namespace {

/// Rows for a few pieces and for many.
constexpr int kMostRows = 48, kLeastRows = 12;
constexpr int kRowsForAll = 4500; // rows of all pieces together
/// So many pieces are tried in several orders and with all of their turns.
constexpr std::size_t kFewPieces = 100, kTurnsOfMany = 4;
/// Edges that are passed by while a piece slides, to a step of what is counted as work: each is a
/// comparison of two numbers.
constexpr Steps kEdgesToAStep = 8;
/// Where one order took so much work, others are not tried: the first layout comes at once.
constexpr Steps kWorkForOrders = 40'000'000;
/// A sheet without room for a piece is asked again for one with less than this of its area.
constexpr double kSmaller = 0.8;

struct OpenSheet
{
    int kind = 0;
    std::unique_ptr<Board> board;
    std::vector<int> pieces;
    std::vector<Pose> poses;
    std::map<int, RowStarts> starts;                          // by kinds of outlines
    double refused = std::numeric_limits<double>::infinity(); // area of what had no room
};

/// Of each shape which others have its outline, to a thousandth of a mm: a number for all of them.
std::vector<int> kindsOfOutlines(const Prepared &prepared)
{
    constexpr double kSame = 1e-3; // mm
    std::map<std::vector<std::int64_t>, int> known;
    std::vector<int> kinds;
    for (const Shape &shape : prepared.shapes) {
        std::vector<std::int64_t> key{static_cast<std::int64_t>(shape.turns.size())};
        const auto add = [&](const Vec2 &p, double scale) {
            key.push_back(std::llround(p.x() * scale));
            key.push_back(std::llround(p.y() * scale));
        };
        for (const Vec2 &p : shape.outline.outer)
            add(p, 1.0 / kSame);
        for (const Polygon &hole : shape.outline.holes)
            for (const Vec2 &p : hole)
                add(p, 1.0 / kSame);
        for (const Posed &posed : shape.turns)
            add(posed.turn, 1.0 / kClipGrid);
        kinds.push_back(
            known.emplace(std::move(key), static_cast<int>(known.size())).first->second);
    }
    return kinds;
}

class Filler
{
public:
    Filler(const Prepared &prepared, const std::vector<int> &kinds, std::size_t expected,
           Steps &steps)
        : m_prepared(prepared), m_kinds(kinds), m_expected(expected), m_steps(steps)
    {
        m_meter.limit = std::numeric_limits<Steps>::max();
        m_filling.rows =
            std::clamp(kRowsForAll / static_cast<int>(std::max<std::size_t>(1, expected)),
                       kLeastRows, kMostRows);
        if (expected > kFewPieces)
            m_filling.turns = kTurnsOfMany;
        // Those that there are so many of lie ready, and are used up before others are taken.
        for (std::size_t kind = 0; kind < prepared.sheets.size(); ++kind)
            for (int i = 0; i < prepared.sheets[kind].count; ++i)
                if (!prepared.sheets[kind].box.isEmpty())
                    open(kind);
    }

    void put(int piece)
    {
        const Shape &shape = m_prepared.shapes[static_cast<std::size_t>(piece)];
        const double area = fff::area(shape.outline);
        for (OpenSheet &sheet : m_open) {
            if (area > kSmaller * sheet.refused)
                continue;
            if (putOn(sheet, piece))
                return;
            sheet.refused = area;
        }
        if (!putOnNew(piece))
            m_left.push_back(piece);
    }

    Laid take()
    {
        Laid laid;
        laid.left = std::move(m_left);
        for (OpenSheet &sheet : m_open)
            if (!sheet.pieces.empty())
                laid.sheets.push_back(
                    {sheet.kind, std::move(sheet.pieces), std::move(sheet.poses)});
        m_steps += m_meter.used / kEdgesToAStep;
        return laid;
    }

private:
    bool putOn(OpenSheet &sheet, int piece)
    {
        const auto index = static_cast<std::size_t>(piece);
        const auto pose = leftmost(*sheet.board, m_prepared.shapes[index], 0, m_filling,
                                   sheet.starts[m_kinds[index]], m_meter);
        if (!pose)
            return false;
        sheet.board->add(index, *pose);
        sheet.pieces.push_back(piece);
        sheet.poses.push_back(*pose);
        return true;
    }

    void open(std::size_t kind)
    {
        const Prepared::Sheet &sheet = m_prepared.sheets[kind];
        OpenSheet one;
        one.kind = static_cast<int>(kind);
        one.board = std::make_unique<Board>(m_prepared.shapes, std::vector{sheet.box}, m_expected);
        for (const Shape &obstacle : sheet.obstacles)
            one.board->addObstacle(obstacle, -obstacle.moved);
        m_open.push_back(std::move(one));
    }

    /// Of a kind that there are as many of as it takes.
    bool putOnNew(int piece)
    {
        for (std::size_t kind = 0; kind < m_prepared.sheets.size(); ++kind) {
            const Prepared::Sheet &sheet = m_prepared.sheets[kind];
            if (sheet.count >= 0 || sheet.box.isEmpty())
                continue;
            open(kind);
            if (putOn(m_open.back(), piece))
                return true;
            m_open.pop_back();
        }
        return false;
    }

    const Prepared &m_prepared;
    const std::vector<int> &m_kinds;
    std::size_t m_expected;
    Steps &m_steps;
    Meter m_meter;
    Filling m_filling;
    std::vector<OpenSheet> m_open;
    std::vector<int> m_left;
};

enum class Order { Area, Length, Width };

std::vector<int> ordered(const Prepared &prepared, const Problem &problem, Order by)
{
    const auto size = [&](int piece) {
        const Shape &shape = prepared.shapes[static_cast<std::size_t>(piece)];
        switch (by) {
        case Order::Area:
            return fff::area(shape.outline);
        case Order::Length:
            return shape.diameter;
        case Order::Width:
            return shape.least;
        }
        return 0.0; // not reached: every order is above
    };
    std::vector<int> pieces;
    for (std::size_t i = 0; i < problem.pieces.size(); ++i)
        for (int copy = 0; copy < problem.pieces[i].demand; ++copy)
            pieces.push_back(static_cast<int>(i));
    std::stable_sort(pieces.begin(), pieces.end(), [&](int a, int b) { return size(a) > size(b); });
    return pieces;
}

} // namespace

std::size_t Laid::count() const
{
    std::size_t count = 0;
    for (const Sheet &sheet : sheets)
        count += sheet.pieces.size();
    return count;
}

double usedLength(const Prepared &prepared, const Laid &laid)
{
    if (laid.sheets.empty())
        return 0.0;
    const Laid::Sheet &sheet = laid.sheets.back();
    const double left = prepared.sheets[static_cast<std::size_t>(sheet.kind)].box.min.x();
    double right = left;
    for (std::size_t i = 0; i < sheet.pieces.size(); ++i) {
        const Shape &shape = prepared.shapes[static_cast<std::size_t>(sheet.pieces[i])];
        const Pose &pose = sheet.poses[i];
        const Box2 box = pose.turn == Pose::kFree
                             ? turnedBounds(shape.outline.outer, pose.direction)
                             : shape.turns[static_cast<std::size_t>(pose.turn)].box;
        right = std::max(right, pose.at.x() + box.max.x());
    }
    return right - left;
}

bool isBetter(const Prepared &prepared, const Laid &a, const Laid &b)
{
    const auto key = [&](const Laid &of) {
        const auto paid =
            std::count_if(of.sheets.begin(), of.sheets.end(), [&](const Laid::Sheet &sheet) {
                return !prepared.sheets[static_cast<std::size_t>(sheet.kind)].isFree;
            });
        return std::tuple(of.left.size(), paid, paid > 0 ? std::size_t{0} : of.sheets.size(),
                          usedLength(prepared, of));
    };
    return key(a) < key(b);
}

Laid firstLayout(const Prepared &prepared, const Problem &problem, Steps &steps)
{
    const std::vector<int> kinds = kindsOfOutlines(prepared);
    // What lies there already is in the way as well.
    std::size_t lying = 0;
    for (const Prepared::Sheet &sheet : prepared.sheets)
        lying += sheet.obstacles.size();
    Laid best;
    bool isFirst = true;
    std::vector<std::vector<int>> tried;
    for (const Order order : {Order::Area, Order::Length, Order::Width}) {
        const std::vector<int> pieces = ordered(prepared, problem, order);
        if (!isFirst && (pieces.size() > kFewPieces || steps > kWorkForOrders))
            break;
        if (std::find(tried.begin(), tried.end(), pieces) != tried.end())
            continue;
        tried.push_back(pieces);
        Filler filler(prepared, kinds, pieces.size() + lying, steps);
        for (const int piece : pieces)
            filler.put(piece);
        Laid laid = filler.take();
        if (isFirst || isBetter(prepared, laid, best))
            best = std::move(laid);
        isFirst = false;
    }
    return best;
}

} // namespace fff::nest
