#include "core/fabrication/hand_placing.h"

#include "core/base/tolerances.h"
#include "core/fabrication/sheet_supply.h"
#include "core/geometry/turning.h"
#include "core/nesting/proof.h"
#include "core/nesting/sliding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace fff {

namespace {

/// What a spacing of less comes to when parts are slid beside each other, mm.
constexpr double kLeastApart = 0.01;

Region turnedRegion(const Region &region, const Vec2 &turn)
{
    const auto ring = [&](Polygon polygon) {
        for (Vec2 &p : polygon)
            p = turned(p, turn);
        return polygon;
    };
    Region next{ring(region.outer), {}};
    for (const Polygon &hole : region.holes)
        next.holes.push_back(ring(hole));
    return next;
}

Region movedRegion(Region region, const Vec2 &by)
{
    for (Vec2 &p : region.outer)
        p += by;
    for (Polygon &hole : region.holes)
        for (Vec2 &p : hole)
            p += by;
    return region;
}

Box2 boxAt(const Part &part, const HandPlace &place)
{
    const Box2 box = turnedBounds(part.outline.region.outer, place.turn);
    return {box.min + place.offset, box.max + place.offset};
}

/// To the nearer of both edges within reach, for each axis.
std::array<std::optional<double>, 2> waysToEdge(const Box2 &box, const Vec2 &sheet, double margin,
                                                double reach)
{
    std::array<std::optional<double>, 2> ways;
    for (const int axis : {0, 1}) {
        const double low = margin - box.min[axis], high = sheet[axis] - margin - box.max[axis];
        const double way = std::abs(low) <= std::abs(high) ? low : high;
        if (std::abs(way) <= reach)
            ways[static_cast<std::size_t>(axis)] = way;
    }
    return ways;
}

} // namespace

HandPlace turnedInPlace(const Part &part, const HandPlace &place, const Vec2 &turn)
{
    const Box2 before = boxAt(part, place);
    HandPlace next = place;
    next.turn = turned(place.turn, turn).normalized();
    // Quarter turns stay what they are to the last bit.
    for (int axis : {0, 1})
        if (std::abs(next.turn[axis]) == 1.0)
            next.turn[1 - axis] = 0.0;
    const Box2 after = boxAt(part, next);
    next.offset += 0.5 * (before.min + before.max - after.min - after.max);
    return next;
}

HandPlacing::HandPlacing(const std::vector<Part> &parts, const Layout &layout,
                         const LayoutOptions &options, int part)
    : m_parts(parts), m_layout(layout), m_options(options), m_part(part)
{
}

bool HandPlacing::takes(int sheet) const
{
    if (sheet < 0 || static_cast<std::size_t>(sheet) >= m_layout.sheets.size())
        return false;
    const Sheet &on = m_layout.sheets[static_cast<std::size_t>(sheet)];
    const std::vector<int> &large = m_layout.oversized;
    const bool isOfOversized =
        !on.placements.empty() &&
        std::find(large.begin(), large.end(), on.placements.front().part) != large.end();
    return !isOfOversized && on.stock == m_parts[static_cast<std::size_t>(m_part)].stock;
}

/// Others on that sheet whose boxes are no farther than that.
std::vector<Region> HandPlacing::neighbours(const HandPlace &place, double reach) const
{
    const Box2 box = boxAt(m_parts[static_cast<std::size_t>(m_part)], place);
    const Vec2 around = Vec2::Constant(reach);
    std::vector<Region> near;
    for (const Placement &one : m_layout.sheets[static_cast<std::size_t>(place.sheet)].placements) {
        if (one.part == m_part)
            continue;
        const Part &part = m_parts[static_cast<std::size_t>(one.part)];
        const Box2 other = boxAt(part, {place.sheet, one.turn, one.offset});
        if (((other.min - around).array() <= box.max.array()).all() &&
            ((other.max + around).array() >= box.min.array()).all())
            near.push_back(movedRegion(turnedRegion(part.outline.region, one.turn), one.offset));
    }
    return near;
}

bool HandPlacing::isSound(const HandPlace &place) const
{
    if (!takes(place.sheet) || !place.offset.allFinite() || !place.turn.allFinite())
        return false;
    nest::Problem problem;
    problem.margin = m_options.margin;
    problem.spacing = m_options.spacing; // without chords, as all that is pinned is judged
    problem.sheets = {{outlineOf(m_layout.sheets[static_cast<std::size_t>(place.sheet)]), 1}};
    nest::Solution solution;
    solution.sheets = {0};
    const auto add = [&](Region outline, const Vec2 &turn, const Vec2 &offset) {
        nest::Piece piece;
        piece.outline = std::move(outline);
        piece.turnsFreely = true;
        solution.places.push_back({static_cast<int>(problem.pieces.size()), 0, turn, offset});
        problem.pieces.push_back(std::move(piece));
    };
    add(m_parts[static_cast<std::size_t>(m_part)].outline.region, place.turn, place.offset);
    for (Region &other : neighbours(place, m_options.spacing + kClipGrid))
        add(std::move(other), Vec2::UnitX(), Vec2::Zero());
    return !nest::faultOf(problem, solution);
}

HandPlace HandPlacing::snapped(HandPlace place, double reach) const
{
    if (!takes(place.sheet))
        return place;
    const HandPlace wished = place;
    const Part &part = m_parts[static_cast<std::size_t>(m_part)];
    const Vec2 &sheet = m_layout.sheets[static_cast<std::size_t>(place.sheet)].size;
    auto settled = waysToEdge(boxAt(part, place), sheet, m_options.margin, reach);
    for (const int axis : {0, 1})
        place.offset[axis] += settled[static_cast<std::size_t>(axis)].value_or(0.0);
    const double apart = std::max(m_options.spacing, kLeastApart);
    const std::vector<Region> others = neighbours(place, apart + 2.0 * reach);
    const nest::Sliding sliding(turnedRegion(part.outline.region, place.turn), others, apart);
    if (!sliding.isFree(place.offset)) {
        const std::optional<Vec2> out = sliding.wayOut(place.offset, reach);
        if (!out)
            return wished;
        place.offset += *out;
        settled[out->y() != 0.0 ? 1 : 0] = 0.0;
    }
    for (const int axis : {0, 1}) {
        if (settled[static_cast<std::size_t>(axis)])
            continue;
        if (const auto way = sliding.wayTo(place.offset, axis, reach))
            place.offset[axis] += *way;
    }
    return isSound(place) ? place : wished;
}

} // namespace fff
