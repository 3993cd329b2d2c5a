#include "core/nesting/shape.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/turning.h"
#include "core/nesting/poles.h"

#include <algorithm>
#include <cmath>

namespace fff::nest {

void Shape::addPoles()
{
    if (!poles.empty())
        return;
    poles = polesOf(outline);
    for (Posed &posed : turns)
        pose(outline, poles, Vec2(posed.turn), posed);
}

Shape shapeOf(Region outline, const std::vector<Vec2> &turns, bool turnsFreely, double area)
{
    Shape shape;
    shape.moved = -bounds(outline.outer).center();
    shape.outline = std::move(outline);
    for (Vec2 &p : shape.outline.outer)
        p += shape.moved;
    for (Polygon &hole : shape.outline.holes)
        for (Vec2 &p : hole)
            p += shape.moved;
    shape.turnsFreely = turnsFreely;
    shape.area = area;
    shape.turns.resize(turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i)
        pose(shape.outline, {}, turns[i], shape.turns[i]);
    const Vec2 size = bounds(shape.outline.outer).size();
    constexpr double kSlim = 0.1; // steps of the search are no shorter for a needle than that
    shape.diameter = size.norm();
    shape.least = std::max(size.minCoeff(), kSlim * shape.diameter);
    shape.weight = std::sqrt(std::sqrt(signedArea(convexHull(shape.outline.outer))));
    return shape;
}

std::vector<Vec2> goodTurns(const Polygon &outline, const std::vector<Vec2> &more)
{
    std::vector<Vec2> turns;
    const auto add = [&turns](const Vec2 &turn) {
        const auto isSame = [&turn](const Vec2 &other) {
            return (turn - other).norm() < kSameDirection;
        };
        if (std::none_of(turns.begin(), turns.end(), isSame))
            turns.push_back(turn);
    };
    const Turns good = findTurns(convexHull(outline));
    for (Vec2 turn : {Vec2(Vec2::UnitX()), good.smallest, good.lowest})
        for (int quarter = 0; quarter < 4; ++quarter, turn = perpendicular(turn))
            add(turn);
    for (const Vec2 &turn : more)
        add(turn);
    return turns;
}

} // namespace fff::nest
