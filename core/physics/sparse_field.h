// A field of stress with no more points than one sees.
#pragma once

#include "core/physics/stress_field.h"

namespace fff {

/// How much it may be off, anywhere.
struct SparseLimits
{
    double use = 0.01;        // of uses between 0 and kMostTold
    double movedShare = 2e-3; // of the farthest way that one point goes from another
    double edge = 0.05;       // mm: of the boundary
    static constexpr double kMostTold = 1.25; // more than all is told by one colour
};

/// The same over fewer points: each of them one of the field's, with the field's values. `most` is
/// the field's own.
///
/// Points are taken out one after the other, each onto a neighbour, as long as what is left says
/// the same about them to the limits; those on the boundary onto one beside them there, if the
/// boundary stays. What is said about a point adds up with what was wrong around it before, so that
/// the limits hold at the field's points. Triangles stay counter-clockwise, and the boundary is
/// gone round as before.
///
/// Source  H. Hoppe et al. 1993, Mesh Optimization: the half-edge collapse; the bound that adds up
///         in place of its energy.
StressField sparseField(const StressField &field, const SparseLimits &limits = {});

} // namespace fff
