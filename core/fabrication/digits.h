// Numbers as single strokes, for a laser that follows lines.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// An open chain of straight edges.
using Stroke = std::vector<Vec2>;

struct StrokedNumber
{
    std::vector<Stroke> strokes; // inside (0, 0) … size
    Vec2 size = Vec2::Zero();
};

/// The number (0 or more) with digits of height 1. Parts get turned over: a number that reads as
/// another one upside down is underlined, and the size includes that line.
StrokedNumber strokedNumber(int number);

} // namespace fff
