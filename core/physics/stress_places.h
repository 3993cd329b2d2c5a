// The weakest places of a piece, few enough to show.
#pragma once

#include "core/physics/section_stress.h"

#include <vector>

namespace fff {

struct PlaceOptions
{
    double along = 3.0; // mm: along a member at most one neck in so much
    int atCorner = 4;   // of those that end at the same corner
    double least = 0.0; // uses below are none
};

/// Indices of necks, the most used first, thinned: of necks whose middles are nearer than
/// PlaceOptions::along the worst one, of those that end at one corner the worst few.
std::vector<int> weakestPlaces(const SectionStress &stress, const PlaceOptions &options = {});

} // namespace fff
