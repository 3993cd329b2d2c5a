// What edits of one weight make of the document: shared by keys, commands and the fields of the
// window. Refused with EditFailed where the weight is not there, or what is wanted is none.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/model.h"

#include <string>

namespace fff {

/// What + and − change the selected weight by, kg.
inline constexpr double kMassStep = 0.01;

/// The weight with the same id as it is given, named by what is another then: its mass, its name or
/// its place. Refused where it would go to hang beside its section, or that is locked.
SectionEdit changedWeight(const Model &model, const Weight &weight);
/// On its section, by this way in the frame's coordinates, mm. Moves of the same weight after each
/// other are one step (an arrow key pressed again).
SectionEdit movedWeight(const Model &model, WeightId id, const Vec2 &by);
/// Heavier by this mass, kg, or lighter; again and again it is one step. The sum is exact to a
/// milligram.
SectionEdit withMassAdded(const Model &model, WeightId id, double mass);
SectionEdit removedWeight(const Model &model, WeightId id);

} // namespace fff
