// Whether two shapes are in each other, how deep about, and how far one has to slide. Internal to
// nesting. In floating point: shapes are larger than what they stand for by more than rounding.
#pragma once

#include "core/nesting/posed.h"

namespace fff::nest {

/// What it took, in about equal steps.
using Steps = long long;

/// Whether they share a point, `a` moved by that much from where `b` is. Boxes, then runs of edges
/// in the window that both boxes share, then whether one holds the other.
bool collide(const Posed &a, const Posed &b, const Vec2 &by, Steps &steps);

/// By how much the discs of both penetrate each other.
struct Depth
{
    float deepest = 0.0f; // over 0: they collide
    float sum = 0.0f;     // each depth times the lesser radius, mm²; grows smoothly from far on
};
/// soft  mm, depth below which depths fade away slower than they should: so that shapes that only
///       just collide, and those that have no discs where they do, know where to go.
/// Source  the proxy of J. Gardeyn, G. Vanden Berghe, T. Wauters 2025, arXiv 2509.13329, section
///         on quantifying collisions.
Depth depth(const Poles &a, const Poles &b, const Vec2 &by, float soft);

enum class Axis { X, Y };

/// How far `a` has to move along the positive axis until it is beside `b` or in a gap of it: 0
/// where it is free already. Exact but for rounding, by the stretches in which pairs of edges meet.
double wayOut(const Posed &a, const Posed &b, const Vec2 &by, Axis axis, Steps &steps);
/// How far `a`, which is free, can move along the negative axis before it touches `b`; `most` where
/// it does not.
double wayDown(const Posed &a, const Posed &b, const Vec2 &by, Axis axis, double most,
               Steps &steps);

} // namespace fff::nest
