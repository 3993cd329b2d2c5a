// Drawings of other programs: the lines of an SVG file in true size.
#pragma once

#include "core/base/result.h"
#include "core/geometry/curve_path.h"

#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

struct SvgDrawing
{
    struct Line
    {
        CurvePath path;     // mm, y upwards, the drawing's lower left at 0
        std::string stroke; // as written, lower case ("#ff0000"); empty: none is said
        bool isFilled = false;
    };
    std::vector<Line> lines;     // in the order of the file
    int texts = 0, pictures = 0; // that were passed over
    bool isCuttingFile = false;  // one of ours (core/io/svg_writer.h)
    bool isTrueSize = true;      // it says how wide it is; else px are taken as said below
};

/// Reads paths (all commands), rectangles, circles, ellipses, lines, polylines and polygons, in
/// groups, nested drawings, `use` and symbols, under transforms; what is clipped is clipped; what
/// is not displayed is left out. In UTF-8, or UTF-16 with or without a byte-order mark.
///
/// Units  width and height of the root say how long a user unit is; without a unit, or in px, 96 of
///        them are an inch, in files of Illustrator 72 and of Inkscape before 0.92 90, as those
///        programs mean it. Percentages are of the drawing's size.
/// name   how errors call the file; empty: places are without it
/// Errors  BadSyntax at name:line for what is no XML, or no svg; BadValue at name:line for a path
///         or number that cannot be read, and without a line when there is nothing in it that could
///         be drawn; BadCount for more than kMostSvgPoints points and elements, or kMostSvgMarks.
/// Source  W3C, Scalable Vector Graphics (SVG) 1.1, second edition, 2011.
Result<SvgDrawing> readSvg(std::string_view bytes, const std::string &name = {});

/// Control points of a drawing, so that a file with a thousand copies of copies ends soon: a path
/// of a million lines has three million.
inline constexpr std::size_t kMostSvgPoints = 4'000'000;
/// Elements and attributes in the text of a drawing, of whatever kind: each takes up many times its
/// length.
inline constexpr std::size_t kMostSvgMarks = 8'000'000;

} // namespace fff::io
