// Joints that what stands on the model, or its own weight, pulls apart.
#pragma once

#include "core/analysis/finding.h"
#include "core/analysis/strength.h"

namespace fff {

extern const FindingKind kPulledOpen;     // more than it holds
extern const FindingKind kHeldByFriction; // as much as only a slit without play holds

extern const ActionKind kTurnPulledSlits; // of the joint

/// Of either.
struct PulledJoint
{
    double force = 0.0; // N
};

/// Each joint once, by its strongest pull.
void findPulledJoints(const Analysis &analysis, const Strength &strength,
                      const StrengthRules &rules, std::vector<Finding> &found);

} // namespace fff
