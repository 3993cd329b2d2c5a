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

/// The place that stays where it is sized. What stands on the ground, or goes through it, keeps
/// standing there as it did: on the ground below its middle. All else, and what lies flat on it:
/// `otherwise`. World, mm.
Vec3 keptInSizing(const Template &one, const Vec3 &otherwise, const Model &model);
/// So that it is as large in its largest extent, mm; on the ground as keptInSizing() has it, else
/// about its middle. Errors  those of movedBy().
Result<Template> sizedInPlace(Template one, double size, const Model &model);
/// So that what is from one place to the other is so long, mm: it keeps standing on the ground,
/// else the first place stays. Places in the world; of what is flat in its plane. Errors  those of
/// movedBy(); BadValue, place = "line", for places that are the same, "length" for one that is not
/// above 0.
Result<Template> sizedByLine(Template one, const Vec3 &from, const Vec3 &to, double length,
                             const Model &model);

/// What of it comes level with other things: its middle and its corners, of a mesh those of the box
/// round it. World; empty while it is not there. O(vertices).
std::vector<Vec3> alignedPointsOf(const Template &one, const Model &model);

} // namespace fff
