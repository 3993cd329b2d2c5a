// What of a section lies in the strip that the other one's slab takes up beside their axis: more
// than what lies on the axis itself. Internal to assembly.
#pragma once

#include "core/assembly/intervals.h"

#include <vector>

namespace fff {

/// A stretch of a line, mm along it.
struct Stretch
{
    double from = 0.0, to = 0.0;
};

/// How far the connected pieces of the region in the strip |across| ≤ halfWidth (mm) reach along
/// the line, ascending by where they begin; several may lie beside each other. A piece's boundary
/// is made of arcs of the region's rings and of stretches of the strip's two edges: the arcs and
/// stretches that meet are one piece. O(vertices + crossings of the edges · log of that).
std::vector<Stretch> lobesIn(const PlaneLine &line, const Region &region, double halfWidth);
/// The same of a shape's region, in the time of the edges near the strip.
std::vector<Stretch> lobesIn(const PlaneLine &line, const Shape &shape, double halfWidth);

/// Whether that is one piece, across which the region's outer ring goes from one edge of the strip
/// to the other exactly twice: nearly every section is so, and there is no more to know.
/// O(vertices).
bool isOneLobe(const PlaneLine &line, const Region &region, double halfWidth);
/// The same of a shape's region, in the time of the edges near the strip.
bool isOneLobe(const PlaneLine &line, const Shape &shape, double halfWidth);

/// What is left of the lobes where the line is cut.
std::vector<Stretch> leftOf(const std::vector<Stretch> &lobes, std::vector<Stretch> cuts);

} // namespace fff
