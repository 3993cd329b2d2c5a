// What edits of one weight make of the document: shared by keys, commands and the fields of the
// window. Refused with EditFailed where the weight is not there, or what is wanted is none.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/model.h"

#include <string>

namespace fff {

/// What + and − change the selected weight by, kg.
inline constexpr double kMassStep = 0.01;

/// On its section, by this way in the frame's coordinates, mm. Moves of the same weight after each
/// other are one step (an arrow key pressed again). Refused where it would hang beside the section,
/// or that is locked.
SectionEdit movedWeight(const Model &model, WeightId id, const Vec2 &by);
/// The same, to this place in the frame of its section, mm; a step of its own.
SectionEdit placedWeight(const Model &model, WeightId id, const Vec2 &position);
/// mass: kg.
SectionEdit withMass(const Model &model, WeightId id, double mass);
/// Heavier by this mass, kg, or lighter; again and again it is one step. The sum is exact to a
/// milligram.
SectionEdit withMassAdded(const Model &model, WeightId id, double mass);
/// An empty name: it has none of its own.
SectionEdit renamedWeight(const Model &model, WeightId id, const std::string &name);
/// What the history says of that.
Step nameStep(const Weight &weight, const std::string &name);
SectionEdit removedWeight(const Model &model, WeightId id);

} // namespace fff
