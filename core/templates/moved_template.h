// A template as it lies in the world, moved there: by hand, and by a line that is said to be so
// long. Pure, as flat_template.h.
#pragma once

#include "core/base/result.h"
#include "core/model/model.h"

#include <vector>

namespace fff {

/// Moved, turned and scaled, `by` without a reflection; what lies on a section stays on it.
///
/// Errors  BadValue, place = "on" while the section that it lies on is not there, "size" for what
/// no
///         template can be as large or as far away as
Result<Template> movedBy(Template one, const Similarity &by, const Model &model);

/// How the axes of its file lie, as turns about the world's X, then Y, then Z, radians; of what
/// does not lie on a section. The second one is within a quarter turn; where it is one the third is
/// 0.
Vec3 turnsOf(const Template &one);
/// With these turns, about its middle.
Template turnedTo(Template one, const Vec3 &turns);

/// So that what is from one place to the other is so long, mm: the first place stays. Places in
/// the world; of what is flat in its plane. Errors  those of movedBy(); BadValue, place = "line",
/// for places that are the same, "length" for one that is not above 0.
Result<Template> sizedByLine(Template one, const Vec3 &from, const Vec3 &to, double length,
                             const Model &model);

/// What of it comes level with other things: its middle and its corners, of a mesh those of the box
/// round it. World; empty while it is not there. O(vertices).
std::vector<Vec3> alignedPointsOf(const Template &one, const Model &model);

} // namespace fff
