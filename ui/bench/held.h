// What is known of whether the model holds: the better of two answers.
#pragma once

#include "core/analysis/bent_model.h"
#include "core/analysis/holding.h"
#include "core/analysis/movement.h"

#include <memory>
#include <string_view>

namespace fff {
class Scheduler;
} // namespace fff

namespace fff::ui {

/// With sections that bend where that is known of the model that is there, else with rigid ones.
/// Null: nothing is known yet.
std::shared_ptr<const Holding> heldNow(const Scheduler &scheduler);
/// How the model gives under the forces of what heldNow() is; null: not known.
std::shared_ptr<const BentModel> bentNow(const Scheduler &scheduler);
/// Where the model moves; nothing where it does not, or what is known is older than the drawing.
std::optional<Movement> movementNow(const Scheduler &scheduler);
/// A stage whose result that may be.
bool isOfHolding(std::string_view stage);

} // namespace fff::ui
