// Where a part is weakest, as a maker would say it.
#pragma once

#include "core/analysis/analysis.h"
#include "core/base/message.h"
#include "core/physics/section_stress.h"

#include <optional>

namespace fff {

struct WeakPlace
{
    enum class Spot {
        Slit,   // a crack would begin at the end of a slit
        Edge,   // beside tabs or fingers
        Corner, // at an inner corner of the outline
        Neck,   // straight across
    };
    SectionRef section;
    Spot spot = Spot::Neck;
    std::optional<SectionRef> guest;             // whose slit that is, or what is joined there
    Vec3 from = Vec3::Zero(), to = Vec3::Zero(); // of the line across it, world, mm
};

/// Of a body of the analysis.
WeakPlace weakPlaceOf(const Analysis &analysis, int body, const NeckStress &neck);

/// "beside its slit for Spine", "at an inner corner", "at its neck".
Message spotText(const WeakPlace &place, const Model &model);

} // namespace fff
