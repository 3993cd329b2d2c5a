#include "core/analysis/touching.h"

#include "core/assembly/slab.h"
#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

Slab slabOf(const Model &model, int index)
{
    const Section &section = *model.section(static_cast<std::size_t>(index));
    return {section.shape->region(), section.frame, model.document.stockOf(section).thickness};
}

} // namespace

bool touchLoosely(const Model &model, const JointList &joints, int a, int b)
{
    if (joints.find(std::min(a, b), std::max(a, b)))
        return false;
    const Slab slab = slabOf(model, a), other = slabOf(model, b);
    return distanceBetween(boundsOf(slab), boundsOf(other)) <= kTouchingDepth &&
           nearestPoints(slab, other, kTouchingDepth).distance <= kTouchingDepth;
}

} // namespace fff
