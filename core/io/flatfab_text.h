// FlatFab's text as it stands: lines, words and numbers, without a thought about geometry.
// Internal to flatfab_format.cpp.
#pragma once

#include "core/geometry/vector.h"
#include "core/io/problems.h"

#include <array>

namespace fff::io {

struct FlatfabCurve
{
    int line = 0;             // of "BezierPoints"
    std::vector<Vec2> points; // p0 h h p1 h h … p0, units of the file
};

struct FlatfabSection
{
    int line = 0; // of "P"
    Vec3 p = Vec3::Zero(), t = Vec3::Zero(), n = Vec3::Zero(), b = Vec3::Zero();
    std::vector<FlatfabCurve> curves; // the contour, then holes
};

/// The sections of a file. When it is not right, `problems` has an error and what comes back is of
/// no use. Errors  NotAModel, Truncated, BadSyntax, BadValue, NonFinite, BadCount, BadContour.
std::vector<FlatfabSection> parseFlatfab(std::string_view bytes, Problems &problems);

} // namespace fff::io
