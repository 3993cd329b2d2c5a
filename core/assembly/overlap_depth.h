// How deep two solids are in each other. Internal to assembly.
#pragma once

#include "core/assembly/solid.h"

#include <optional>

namespace fff {

/// Of the rooms that both take up the one that is thickest, in the direction in which it is
/// thinnest: what would have to be filed away there. And a place in it. No less than what any two
/// of their prisms would have to move to come apart. Nothing when they only touch, to the depth.
///
/// A room is what is connected, however many triangles it is cut into; what is held from two sides
/// is in two rooms. O(prisms that meet · directions).
std::optional<Interpenetration> overlapOf(const Solid &a, const Solid &b, double depth);

class Encounter;
/// The same of an encounter of the two as they are.
std::optional<Interpenetration> overlapOf(const Solid &a, const Solid &b, Encounter &still);

} // namespace fff
