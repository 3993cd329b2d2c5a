// Regions grown by a distance, with curves.
#pragma once

#include "core/geometry/boolean.h"

namespace fff {

/// The way of the middle of a disc of radius `distance` mm (0 or more) that rolls round the region:
/// the outer boundary outwards, holes inwards. Connected, so one region. Slits and holes that the
/// disc does not go into close; a room behind a mouth that is too narrow for it becomes a hole.
///
/// Straight segments stay straight, exactly parallel; a curve becomes one cubic or several within
/// kOffsetError of the true offset curve, or chords where no such curve keeps clear of what is
/// beside it. Corners are mitred, so that those of slits stay square, up to kMitreLimit and where
/// that leaves the disc all places that it can come to; else they are round.
/// A distance below kLeastGrowth gives the region back as it is.
///
/// What comes out has no sweepFaults(). Errors  CannotOffset where no such path is found, as for an
/// outline that touches itself within rounding.
///
/// Method: every boundary is offset by itself (raw_offset.h); what the offsets wind round is the
/// grown region. Where the judge finds a fault, mitres give way to arcs and curves to chords.
inline constexpr double kLeastGrowth = 5e-4; // mm, a tenth of what the path may be off
Result<CurvedRegion> grow(const CurvedRegion &region, double distance);

/// As large as the grown region in every direction and all but of its area, in a fraction of the
/// time; its boundaries cross themselves. For those who only want to know how much room it takes.
Result<CurvedRegion> growLoosely(const CurvedRegion &region, double distance);

} // namespace fff
