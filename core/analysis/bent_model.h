// How a model gives under what holds and loads it: the stress all over its bodies, and where they
// move.
#pragma once

#include "core/analysis/strength.h"
#include "core/physics/stress_field.h"

#include <vector>

namespace fff {

struct BentModel
{
    AnalysisPointer analysis;               // that it is of
    std::vector<StressFieldPointer> fields; // of each body; null: rigid, or nothing is known of it
    std::vector<StressFieldPointer> drawn;  // the same, as sparse as it may be drawn
    std::vector<RigidMotion> motions;       // of each about its centroid, mm; a field's own
                                            // displacements come on top
    std::vector<Vec3> centroids;            // of each, world, mm
    double most = 0.0;                      // mm, the farthest that a point of a body moves
    int mostIn = -1;                        // that body; −1: nothing moves
    double worstGap = 0.0; // mm that are left between bodies that hold each other: rounding

    /// Of a point of a body's field, world, mm.
    Vec3 moved(int body, std::size_t point) const;
    /// Of a point of another field over that body.
    Vec3 moved(int body, const StressField &field, std::size_t point) const;
};

/// Under the forces that were found, of all bodies whose forces are known and whose strength is.
/// The stresses are the worst of the ways in which the load may be shared, displacements those of
/// the first. Only bodies that carry something else than before are worked out anew.
/// Errors  Cancelled.
Result<BentModel> bentModel(AnalysisPointer analysis, const Strength &strength,
                            StrengthCaches &caches, const LongWork &work = {});

} // namespace fff
