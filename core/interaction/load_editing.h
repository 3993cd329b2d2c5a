// What edits of one load make of the document: shared by keys, commands and the fields of the
// window. Refused with EditFailed where the load is not there, or what is wanted is none.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/model.h"

#include <string>

namespace fff {

/// What + and − change the selected weight by, kg, and a push, N.
inline constexpr double kMassStep = 0.01, kForceStep = 0.5;

/// The load with the same id as it is given, named by what is another then: how much it is, its
/// place, name or spread. Refused where it would go to be beside its section, or that is locked.
SectionEdit changedLoad(const Model &model, const Load &load);
/// On its section, by this way in the frame's coordinates, mm. Moves of the same load after each
/// other are one step (an arrow key pressed again).
SectionEdit movedLoad(const Model &model, LoadId id, const Vec2 &by);
/// By so much more, kg or N, or less; again and again it is one step. The sum is exact to a
/// milligram, or a thousandth of a newton. A push stays one: nothing of it is turned round.
SectionEdit withMore(const Model &model, LoadId id, double more);
SectionEdit removedLoad(const Model &model, LoadId id);

} // namespace fff
