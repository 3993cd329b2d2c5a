#include "core/nesting/posed.h"

#include "core/geometry/turning.h"

#include <algorithm>

namespace fff::nest {

namespace {

void addRing(const Polygon &ring, const Vec2 &turn, std::vector<Edge> &edges)
{
    if (ring.empty())
        return;
    Vec2 from = turned(ring.back(), turn);
    for (const Vec2 &corner : ring) {
        const Vec2 to = turned(corner, turn);
        edges.push_back({from, to, {from.cwiseMin(to), from.cwiseMax(to)}});
        from = to;
    }
}

void turnPoles(const std::vector<Pole> &poles, const Vec2 &turn, Poles &into)
{
    constexpr float kFarAway = 1e15f; // mm
    into.count = std::min(poles.size(), Poles::kMost);
    into.padded = (into.count + 3) / 4 * 4;
    for (std::size_t i = 0; i < into.padded; ++i) {
        const bool isSome = i < into.count;
        const Vec2 center = isSome ? turned(poles[i].center, turn) : Vec2::Zero();
        into.x[i] = isSome ? static_cast<float>(center.x()) : kFarAway;
        into.y[i] = isSome ? static_cast<float>(center.y()) : kFarAway;
        into.r[i] = isSome ? static_cast<float>(poles[i].radius) : 0.0f;
    }
}

} // namespace

void pose(const Region &outline, const std::vector<Pole> &poles, const Vec2 &turn, Posed &posed)
{
    posed.turn = turn;
    posed.edges.clear();
    addRing(outline.outer, turn, posed.edges);
    for (const Polygon &hole : outline.holes)
        addRing(hole, turn, posed.edges);
    posed.runs.assign((posed.edges.size() + Posed::kRun - 1) / Posed::kRun, Box2());
    posed.box = Box2();
    for (std::size_t i = 0; i < posed.edges.size(); ++i)
        posed.runs[i / Posed::kRun].extend(posed.edges[i].box);
    for (const Box2 &run : posed.runs)
        posed.box.extend(run);
    turnPoles(poles, turn, posed.poles);
}

} // namespace fff::nest
