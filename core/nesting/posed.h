// A shape at a turn, as collisions and overlaps are found on it. Internal to nesting.
#pragma once

#include "core/geometry/polygon.h"

#include <array>
#include <cstddef>
#include <vector>

namespace fff::nest {

/// A disc inside a shape.
struct Pole
{
    Vec2 center = Vec2::Zero();
    double radius = 0.0;
};

/// The same disc, of many shapes, in fours: what is empty has no radius and is far away.
struct Poles
{
    static constexpr std::size_t kMost = 16;

    alignas(16) std::array<float, kMost> x, y, r;
    std::size_t count = 0;  // of those that are some
    std::size_t padded = 0; // the next multiple of 4
};

struct Edge
{
    Vec2 from, to;
    Box2 box;
};

struct Posed
{
    Vec2 turn = Vec2::UnitX();
    Box2 box;
    std::vector<Edge> edges; // of all rings
    std::vector<Box2> runs;  // boxes of every kRun edges
    Poles poles;

    static constexpr std::size_t kRun = 8;
};

/// Fills `posed`, whose memory is used again.
void pose(const Region &outline, const std::vector<Pole> &poles, const Vec2 &turn, Posed &posed);

} // namespace fff::nest
