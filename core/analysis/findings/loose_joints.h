// Joints whose slits hold nothing: a step at an edge, a section that is cut right through.
#pragma once

#include "core/analysis/finder.h"

namespace fff {

/// Of kLooseJoint.
struct LooseJoint
{
    LooseSlit slit; // of the first of the finding's sections
};

extern const FindingKind kLooseJoint; // one a joint

/// Without those that only touch (touching_pairs.h).
void findLooseJoints(const Looked &at, std::vector<Finding> &found);

} // namespace fff
