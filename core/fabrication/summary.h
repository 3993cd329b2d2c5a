// Mass, centre of mass and size of a model as it will be cut.
#pragma once

#include "core/fabrication/cut_section.h"
#include "core/model/model.h"

#include <optional>

namespace fff {

struct MassProperties
{
    double mass = 0.0;          // kg
    Vec3 centre = Vec3::Zero(); // world, mm; the origin for a mass of 0

    MassProperties &operator+=(const MassProperties &other);
};

/// Of one section after its slits: exact area of its parts × thickness × density. Weights are not
/// in it.
MassProperties massOf(const Section &section, const Stock &stock, const CutSection &cut);

/// Of all sections together. `cuts` belong to the model, one a section.
MassProperties massOf(const Model &model, const std::vector<CutSectionPointer> &cuts);

/// Box of a section's slab: its contour, half a thickness to both sides. World, mm.
Box3 slabBounds(const Section &section, const Stock &stock);
/// Of all slabs. Empty for an empty model.
Box3 slabBounds(const Model &model);

} // namespace fff
