// The shapes an SVG file can draw, as lines. Internal to io.
#pragma once

#include "core/io/svg_source.h"
#include "core/io/svg_values.h"

#include <vector>

namespace fff::io {

/// The lines of a path, rect, circle, ellipse, line, polyline or polygon, in its user units; none
/// where it has no size. viewport: what percentages are of. Errors go to the source.
std::vector<SvgSubpath> svgShape(SvgSource &source, const pugi::xml_node &node,
                                 const Vec2 &viewport);

} // namespace fff::io
