#include "core/nesting/proof.h"

#include "core/base/tolerances.h"
#include "core/geometry/grid_predicates.h"
#include "core/geometry/segment_distance.h"
#include "core/geometry/turning.h"

#include <algorithm>
#include <cmath>

namespace fff::nest {

namespace {

/// An edge of a boundary on the grid.
struct GridEdge
{
    GridPoint from, to;

    std::int64_t left() const { return std::min(from.x, to.x); }
    std::int64_t right() const { return std::max(from.x, to.x); }
    std::int64_t bottom() const { return std::min(from.y, to.y); }
    std::int64_t top() const { return std::max(from.y, to.y); }
};

struct Lying
{
    std::vector<GridEdge> edges; // by their left ends
    std::int64_t left = 0, bottom = 0, right = 0, top = 0, longest = 0;
};

GridPoint onGrid(const Vec2 &p)
{
    return {std::llround(p.x() / kClipGrid), std::llround(p.y() / kClipGrid)};
}

Vec2 fromGrid(const GridPoint &p)
{
    return Vec2(static_cast<double>(p.x), static_cast<double>(p.y)) * kClipGrid;
}

Lying lyingAs(const Region &outline, const Vec2 &turn, const Vec2 &offset)
{
    Lying lying;
    const auto add = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            lying.edges.push_back({onGrid(turned(ring[i], turn) + offset),
                                   onGrid(turned(ring[(i + 1) % ring.size()], turn) + offset)});
    };
    add(outline.outer);
    for (const Polygon &hole : outline.holes)
        add(hole);
    std::sort(lying.edges.begin(), lying.edges.end(),
              [](const GridEdge &a, const GridEdge &b) { return a.left() < b.left(); });
    lying.left = lying.bottom = std::numeric_limits<std::int64_t>::max();
    lying.right = lying.top = std::numeric_limits<std::int64_t>::min();
    for (const GridEdge &edge : lying.edges) {
        lying.left = std::min(lying.left, edge.left());
        lying.right = std::max(lying.right, edge.right());
        lying.bottom = std::min(lying.bottom, edge.bottom());
        lying.top = std::max(lying.top, edge.top());
        lying.longest = std::max(lying.longest, edge.right() - edge.left());
    }
    return lying;
}

/// Calls visit(a, b) for pairs of edges whose boxes are within `reach` of each other, until it says
/// true; whether it did.
template <class Visit>
bool anyPair(const Lying &a, const Lying &b, std::int64_t reach, Visit visit)
{
    for (const GridEdge &edge : a.edges) {
        if (edge.right() + reach < b.left || edge.left() - reach > b.right ||
            edge.top() + reach < b.bottom || edge.bottom() - reach > b.top)
            continue;
        auto other =
            std::lower_bound(b.edges.begin(), b.edges.end(), edge.left() - reach - b.longest,
                             [](const GridEdge &e, std::int64_t x) { return e.left() < x; });
        for (; other != b.edges.end() && other->left() <= edge.right() + reach; ++other)
            if (other->right() + reach >= edge.left() && other->bottom() - reach <= edge.top() &&
                other->top() + reach >= edge.bottom() && visit(edge, *other))
                return true;
    }
    return false;
}

/// Each passes from one side of the other to the other side.
bool edgesCross(const GridEdge &a, const GridEdge &b)
{
    return sideOf(b.from, b.to, a.from) * sideOf(b.from, b.to, a.to) < 0 &&
           sideOf(a.from, a.to, b.from) * sideOf(a.from, a.to, b.to) < 0;
}

bool isOn(const GridPoint &p, const GridEdge &edge)
{
    return p.x >= edge.left() && p.x <= edge.right() && p.y >= edge.bottom() && p.y <= edge.top() &&
           sideOf(edge.from, edge.to, p) == 0;
}

/// 1 inside, 0 on the boundary, −1 outside.
int sideOfBoundary(const GridPoint &p, const Lying &lying)
{
    bool inside = false;
    for (const GridEdge &edge : lying.edges) {
        if (isOn(p, edge))
            return 0;
        if ((edge.from.y > p.y) != (edge.to.y > p.y))
            inside ^= (sideOf(edge.from, edge.to, p) > 0) == (edge.to.y > edge.from.y);
    }
    return inside ? 1 : -1;
}

/// Whether they share a point.
bool edgesTouch(const GridEdge &a, const GridEdge &b)
{
    return edgesCross(a, b) || isOn(a.from, b) || isOn(a.to, b) || isOn(b.from, a) || isOn(b.to, a);
}

/// Of two whose boundaries do not meet.
bool isIn(const Lying &a, const Lying &b)
{
    return !a.edges.empty() && sideOfBoundary(a.edges.front().from, b) > 0;
}

double gapBetween(const GridEdge &a, const GridEdge &b)
{
    const Vec2 p = fromGrid(a.from), q = fromGrid(a.to), r = fromGrid(b.from), s = fromGrid(b.to);
    return std::min({distanceToSegment(p, r, s), distanceToSegment(q, r, s),
                     distanceToSegment(r, p, q), distanceToSegment(s, p, q)});
}

bool areNear(const Lying &a, const Lying &b, std::int64_t reach)
{
    return a.left - reach <= b.right && b.left - reach <= a.right && a.bottom - reach <= b.top &&
           b.bottom - reach <= a.top;
}

std::optional<Fault::Kind> faultBetween(const Lying &a, const Lying &b, double apart)
{
    if (anyPair(a, b, 0, edgesTouch) || isIn(a, b) || isIn(b, a))
        return Fault::Kind::Overlap;
    if (!(apart > 0.0))
        return std::nullopt;
    const auto reach = static_cast<std::int64_t>(std::ceil(apart / kClipGrid));
    const auto isTooNear = [&](const GridEdge &p, const GridEdge &q) {
        return gapBetween(p, q) < apart - kClipSlack;
    };
    return anyPair(a, b, reach, isTooNear) ? std::optional(Fault::Kind::TooNear) : std::nullopt;
}

/// Within the container and as far as it has to be from its edge.
bool isOutside(const Lying &lying, const Lying &container, double margin)
{
    if (anyPair(lying, container, 0, edgesCross))
        return true;
    for (const GridEdge &edge : lying.edges)
        if (sideOfBoundary(edge.from, container) < 0)
            return true;
    // Holes of the container, or bays, that lie in the piece.
    for (const GridEdge &edge : container.edges)
        if (areNear(lying, container, 0) && sideOfBoundary(edge.from, lying) > 0)
            return true;
    if (!(margin > 0.0))
        return false;
    const auto reach = static_cast<std::int64_t>(std::ceil(margin / kClipGrid));
    return anyPair(lying, container, reach, [&](const GridEdge &p, const GridEdge &q) {
        return gapBetween(p, q) < margin - kClipSlack;
    });
}

Region containerOf(const Problem &problem, const Solution &solution, int sheet)
{
    if (problem.stripHeight > 0.0) {
        const double far = solution.length, high = problem.stripHeight;
        return {{{0.0, 0.0}, {far, 0.0}, {far, high}, {0.0, high}}, {}};
    }
    const int kind = solution.sheets[static_cast<std::size_t>(sheet)];
    return problem.sheets[static_cast<std::size_t>(kind)].outline;
}

const std::vector<Polygon> &takenOf(const Problem &problem, const Solution &solution, int sheet)
{
    static const std::vector<Polygon> kNone;
    if (problem.stripHeight > 0.0)
        return kNone;
    const int kind = solution.sheets[static_cast<std::size_t>(sheet)];
    return problem.sheets[static_cast<std::size_t>(kind)].taken;
}

bool mayBeTurned(const Piece &piece, const Vec2 &turn)
{
    return piece.turnsFreely ||
           std::any_of(piece.turns.begin(), piece.turns.end(), [&turn](const Vec2 &allowed) {
               return (allowed - turn).norm() < kSameDirection;
           });
}

bool areCountsRight(const Problem &problem, const Solution &solution)
{
    std::vector<int> counts(problem.pieces.size(), 0), sheets(problem.sheets.size(), 0);
    for (const Place &place : solution.places)
        ++counts[static_cast<std::size_t>(place.piece)];
    for (const int piece : solution.left)
        ++counts[static_cast<std::size_t>(piece)];
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i] != std::max(0, problem.pieces[i].demand))
            return false;
    if (problem.stripHeight > 0.0)
        return true;
    for (const int kind : solution.sheets)
        ++sheets[static_cast<std::size_t>(kind)];
    for (std::size_t i = 0; i < sheets.size(); ++i)
        if (problem.sheets[i].count >= 0 && sheets[i] > problem.sheets[i].count)
            return false;
    return true;
}

} // namespace

std::optional<Fault> faultOf(const Problem &problem, const Solution &solution)
{
    if (!areCountsRight(problem, solution))
        return Fault{Fault::Kind::WrongCount, 0, -1};
    const double apart = problem.spacing > 0.0 ? problem.spacing + 2.0 * problem.chord : 0.0;
    const double margin = problem.margin > 0.0 ? problem.margin + problem.chord : 0.0;
    std::vector<Lying> lying;
    std::vector<std::size_t> order;
    for (const Place &place : solution.places) {
        const Piece &piece = problem.pieces[static_cast<std::size_t>(place.piece)];
        const int index = static_cast<int>(lying.size());
        lying.push_back(lyingAs(piece.outline, place.turn, place.offset));
        if (!mayBeTurned(piece, place.turn))
            return Fault{Fault::Kind::WrongTurn, index, -1};
        const Lying container =
            lyingAs(containerOf(problem, solution, place.sheet), Vec2::UnitX(), Vec2::Zero());
        if (isOutside(lying.back(), container, margin))
            return Fault{Fault::Kind::OutsideOfSheet, index, -1};
        for (const Polygon &taken : takenOf(problem, solution, place.sheet))
            if (const auto kind = faultBetween(
                    lying.back(), lyingAs({taken, {}}, Vec2::UnitX(), Vec2::Zero()), apart))
                return Fault{*kind, index, -1};
        order.push_back(order.size());
    }
    // By sheets and then from the left; each with those that begin before it ends.
    const auto sheetOf = [&](std::size_t i) { return solution.places[i].sheet; };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(sheetOf(a), lying[a].left) < std::pair(sheetOf(b), lying[b].left);
    });
    const auto reach = static_cast<std::int64_t>(std::ceil(apart / kClipGrid));
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Lying &a = lying[order[i]], &b = lying[order[j]];
            if (sheetOf(order[j]) != sheetOf(order[i]) || b.left > a.right + reach)
                break;
            if (!areNear(a, b, reach))
                continue;
            if (const auto kind = faultBetween(a, b, apart))
                return Fault{*kind, static_cast<int>(order[i]), static_cast<int>(order[j])};
        }
    }
    return std::nullopt;
}

} // namespace fff::nest
