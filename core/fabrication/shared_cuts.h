// Where edges of parts lie on each other. Internal to fabrication.
#pragma once

#include "core/fabrication/cutting_order.h"

#include <span>
#include <vector>

namespace fff {

/// A piece of a closed line, from one station to another (line_stations.h): from < to, and `to`
/// may be beyond the line's length, where it goes over its start.
struct LineSpan
{
    double from = 0.0, to = 0.0;
};

/// Of each line the spans in which its straight edges lie, within kTouchingDepth, on edges of lines
/// before it: that is cut already. Ascending, apart from each other. Curves on curves are not
/// looked for: parts that lie next to each other share edges.
/// O(n log n) where edges lie on few others.
std::vector<std::vector<LineSpan>> sharedSpans(std::span<const ToolLine *const> lines);

} // namespace fff
