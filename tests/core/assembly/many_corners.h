// Shapes of very many corners, and lines across them: what a spine is to its ribs.
#pragma once

#include "core/assembly/intervals.h"
#include "tests/core/assembly/plates.h"

#include <numbers>
#include <random>

namespace fff::test {

/// 100 mm long for each 10 of so many corners on either side, which stand out by turns.
inline ShapePointer spineOf(int corners)
{
    Polygon outline;
    for (int i = 0; i <= corners; ++i)
        outline.push_back({10.0 * i, i % 2 == 0 ? 0.0 : -1.0});
    for (int i = corners; i >= 0; --i)
        outline.push_back({10.0 * i, 40.0 + (i % 2 == 0 ? 0.0 : 1.0)});
    return polygonShape(outline);
}

/// A jagged disc with holes in rows.
inline ShapePointer jaggedDisc(std::mt19937_64 &random, int corners)
{
    std::uniform_real_distribution<double> reach(60.0, 90.0);
    Polygon outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners, radius = reach(random);
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    std::vector<Polygon> holes;
    for (const double x : {-30.0, -10.0, 10.0, 30.0})
        for (const double y : {-20.0, 0.0, 20.0})
            holes.push_back(rectangle(x - 3, y - 2, x + 3, y + 2));
    return polygonShape(outline, holes);
}

/// Anywhere, through corners, and along edges.
inline std::vector<PlaneLine> linesAcross(std::mt19937_64 &random, const Shape &shape)
{
    const Polygon &ring = shape.region().outer;
    std::uniform_int_distribution<std::size_t> corner(0, ring.size() - 1);
    std::uniform_real_distribution<double> turn(0.0, 2.0 * std::numbers::pi);
    std::vector<PlaneLine> lines;
    for (int i = 0; i < 60; ++i) {
        const std::size_t at = corner(random), next = at + 1 < ring.size() ? at + 1 : 0;
        const double angle = turn(random);
        lines.push_back({ring[at], Vec2(std::cos(angle), std::sin(angle))});
        lines.push_back({0.3 * ring[at] + 0.7 * ring[corner(random)], lines.back().direction});
        lines.push_back({ring[at], Vec2::UnitY()});
        lines.push_back({ring[at], (ring[next] - ring[at]).normalized()});
    }
    for (const double height : {-22.0, 0.0, 2.0, 40.0})
        lines.push_back({Vec2(0.0, height), Vec2::UnitX()});
    return lines;
}

} // namespace fff::test
