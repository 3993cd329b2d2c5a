// What becomes of something that rests on the ground when it is pushed, or the ground is tilted.
#pragma once

#include "core/assembly/ground.h"

#include <vector>

namespace fff {

/// Of something that rests; without points on which it lies still it is one that tips at 0.
struct Toppling
{
    Ground ground;            // on which it lies still, at last: a face of its hull; mostly within
                              // a hair of that which was asked for
    double tipAngle = 0.0;    // radians: on a table that is tilted by less it does not fall
    double margin = 0.0;      // mm along the ground from its centre of mass to the edge over which
                              // it falls, as it leans by then
    Vec3 edge = Vec3::Zero(); // the point of that edge to which that is measured
    double rocking = 0.0;     // radians: so far from its ground it comes before it falls, when that
                              // is tilted by less than kSteadyTilt
    std::vector<Vec3> contacts; // all points on which it stands, at once or one after the other
};

/// First it goes where its centre of mass goes down, as what it was found to rest on may be so only
/// to what counts as contact: a wheel does not lie on its rim. Then it is pushed. Pushed over an
/// edge of what touches it rolls until another point touches: on that it stands,
/// too, as long as it is turned by no more than kFarthestLean then. Every edge is tried, and every
/// one of what it comes to lie on, which are faces of its hull: it falls over those after which
/// nothing touches in time, and of the ways to one of them that counts which takes least tilting.
/// points  as settle() has them
/// ground  on which it rests, to kGroundContact
/// O(n log n).
Toppling topplingOf(const std::vector<Vec3> &points, const Vec3 &centreOfMass,
                    const Ground &ground);

} // namespace fff
