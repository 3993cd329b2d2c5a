// Whether a path is right for a round tool: judged by the two outlines alone, however the path was
// made. Internal to geometry.
#pragma once

#include "core/geometry/boolean.h"

#include <vector>

namespace fff {

struct SweepFault
{
    enum class Kind {
        Crossing,   // the path touches or crosses itself here
        TooNear,    // the disc enters the part
        TooFar,     // the path leaves the part alone
        NotReached, // a disc here touches the part where the path lets none come
        Nesting,    // a ring of the path lies where none can
    };
    Kind kind = Kind::Crossing;
    Vec2 at = Vec2::Zero(); // of the path; NotReached: the disc's middle
};

/// What is wrong with `path` as the way of the middle of a disc round `part`. Empty:
///
///  - the rings of the path neither touch themselves nor each other, exact for chords of the curves
///    finer than kSweepError / 8 and for coarser ones, so that no reader of them sees a crossing;
///  - no point of the path is nearer to the part than radius − kSweepError, nor inside;
///  - every point of the part's boundary at which a disc of the radius (+ kSweepError / 5) touches
///    the part without entering it is within radius + kSweepError of the path;
///  - the outer ring runs counter-clockwise round the part, holes clockwise beside it.
///
/// Not at samples: edges are compared with edges, by intervals where they are within reach.
/// radius   mm, above 0; where it is below kSweepError, errors are measured by it
/// O(n log n) for outlines with n chords on which few places lie within the radius of each other.
std::vector<SweepFault> sweepFaults(const CurvedRegion &part, const CurvedRegion &path,
                                    double radius);

/// Places that the disc comes to, or all but comes to: where it would enter the part by no more
/// than kSweepError / 5, and the path lets none come near. NotReached, all of them.
std::vector<SweepFault> placesLeft(const CurvedRegion &part, const CurvedRegion &path,
                                   double radius);

} // namespace fff
