// Where a model moves under what holds and loads it, to be shown larger than it is.
#pragma once

#include "core/analysis/bent_model.h"
#include "core/analysis/holding.h"

#include <optional>

namespace fff {

struct Movement
{
    AnalysisPointer analysis;              // that it is of
    std::shared_ptr<const BentModel> bent; // null: bodies move as they are
    std::vector<RigidMotion> motions;      // of each body about its centroid
    std::vector<Vec3> centroids;           // of each, world, mm
    double most = 0.0;                     // mm, the farthest that a point moves
    bool isLoose = false; // nothing holds it: it has a way to go, but no end. `most` is of that way
    double size = 0.0;    // mm, of the model

    /// As many times as it is shown at most: then the farthest point moves by a twentieth of the
    /// model's size. No more than kMostTimes where it has an end.
    double mostTimes() const;
    static constexpr double kMostTimes = 1000.0;
};

/// How it bends, where that is known; of what comes apart or slides within itself the way in which
/// it begins to. Nothing where nothing moves, or nobody knows.
std::optional<Movement> movementOf(const Holding &held, std::shared_ptr<const BentModel> bent);

} // namespace fff
