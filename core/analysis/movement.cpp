#include "core/analysis/movement.h"

#include <algorithm>

namespace fff {

namespace {

constexpr double kShownSize = 0.05; // of the model's: the farthest that something is shown to move

} // namespace

double Movement::mostTimes() const
{
    const double times = most > 0.0 ? kShownSize * size / most : 0.0;
    return isLoose ? times : std::min(times, kMostTimes);
}

std::optional<Movement> movementOf(const Holding &held, std::shared_ptr<const BentModel> bent)
{
    Movement movement;
    movement.analysis = held.analysis;
    const Structure &structure = held.strength.made.structure;
    Box3 box;
    for (std::size_t i = 0; i < held.analysis->bodies.size(); ++i)
        box.extend(held.analysis->bodies.at(static_cast<int>(i)).box());
    movement.size = box.isEmpty() ? 0.0 : box.size().norm();
    if (bent) {
        movement.most = bent->most;
        movement.motions = bent->motions;
        movement.centroids = bent->centroids;
        movement.bent = std::move(bent);
    } else {
        for (const Member &member : structure.members)
            movement.centroids.push_back(member.centroid);
        movement.motions.resize(structure.members.size());
        for (const ComponentState &state : held.strength.equilibrium().components) {
            for (std::size_t k = 0; k < state.motion.size(); ++k)
                movement.motions[static_cast<std::size_t>(state.parts.members[k])] =
                    state.motion[k];
            if (!state.motion.empty()) {
                movement.isLoose = true;
                movement.most = 1.0; // as such motions are given
            }
        }
    }
    return movement.most > 0.0 && movement.size > 0.0 ? std::optional(std::move(movement))
                                                      : std::nullopt;
}

} // namespace fff
