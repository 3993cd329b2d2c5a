// A boundary moved sideways, loops and all: what grow() finds the grown region in. Internal to
// geometry.
#pragma once

#include "core/geometry/contour.h"

#include <vector>

namespace fff {

/// A mitre reaches at most this many distances from its corner (SVG and Clipper cut off at a like
/// ratio); a right angle needs 1.41. Beyond it the corner is round.
inline constexpr double kMitreLimit = 2.5;

/// How a boundary is offset, where it is not as usual.
struct OffsetStyle
{
    std::vector<double> chords; // of a segment: 0 for curves, else chords within so many mm of it
    std::vector<char> isRound;  // of a segment: no mitre where it begins
    double arcChord = 0.0;      // the same as chords, for round corners
};

struct RawOffset
{
    Contour contour;
    /// The mitres in it: the corner and the segment that begins there.
    struct Mitre
    {
        Vec2 corner = Vec2::Zero();
        int segment = 0;
    };
    std::vector<Mitre> mitres;
};

/// The boundary moved to its right by `distance` mm (above 0). It winds at least once round all
/// that a disc of that radius sweeps whose middle runs along the boundary, and as often as the
/// boundary does round the rest, so together the boundaries of a region wind round the grown one,
/// and round nothing else.
///
/// Straight segments stay straight and exactly parallel; a curve becomes cubics within `error` mm
/// of its offset. Corners to the left are mitred up to kMitreLimit and round beyond it. At those to
/// the right the way leads from the end of one segment's offset through the corner itself to the
/// start of the next one's, or along to where the two cross, if both are long enough for that.
/// Where a curve bends to the right by less than the distance, its offset would run backwards;
/// there its chords are offset instead.
///
/// Source  X. Chen, S. McMains 2005, Polygon Offsetting by Computing Winding Numbers; for concave
/// corners the decomposition into the region, a rectangle an edge and a sector a corner, whose
/// boundaries add up to this one.
Result<RawOffset> rawOffset(const Contour &contour, double distance, double error,
                            const OffsetStyle &style = {});

} // namespace fff
