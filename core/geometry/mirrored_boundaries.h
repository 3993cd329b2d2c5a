// Boundaries that are the same on both sides of a line, control point by control point.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/halfplane_clip.h"
#include "core/geometry/mirror_axis.h"

#include <vector>

namespace fff {

/// Control points differ from their images by no more than this, mm: what rounding of files and
/// scales leaves.
inline constexpr double kSameImage = 1e-6;

/// Whether each control point of these boundaries has its image among them, within kSameImage. Says
/// nothing about which curves run between them. O(n log n).
bool isMirrored(const Contour &contour, const std::vector<Contour> &holes, const MirrorAxis &axis);

/// What of the region lies to one side of the axis, and the exact image of that: a boundary that
/// the axis cuts is opened there, and joined to its own image. Points that are on the axis already
/// stay to the bit. Where the half falls apart the largest piece counts. In difference to
/// mirroredHalf() (symmetrised.h) nothing goes through the booleans' grid; so a contour can be
/// edited any number of times. Errors  EmptyContour when nothing lies there, or does not reach the
/// axis; as clip().
Result<ClippedPiece> withImage(const Contour &contour, const std::vector<Contour> &holes,
                               const MirrorAxis &axis, bool isLeft);

} // namespace fff
