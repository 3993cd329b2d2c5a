// Sections that are in each other where no slit lets them be, and joints at shallow angles.
#pragma once

#include "core/analysis/finder.h"
#include "core/analysis/plan_finder.h"
#include "core/assembly/slits.h"

namespace fff {

/// Of kNoSlit.
struct MissingSlit
{
    double overlap = 0.0; // the longest, mm
    NoSlit why = NoSlit::Enclosed;
};
/// Of kInterference.
struct Interference
{
    double depth = 0.0;    // mm
    bool isJoined = false; // by a joint, outside of whose slits they are in each other
};
/// Of kShallowAngle, radians.
struct ShallowAngle
{
    double angle = 0.0;
    double least = 0.0; // below which it is said
};

extern const FindingKind kNoSlit; // two cut into each other, but no slit lets them slide together
extern const FindingKind kInterference; // two cut into each other where no joint is
/// Two meet at less than what a person wants (CheckRules), or, as an error, at less than any joint
/// takes (kMinJointAngle).
extern const FindingKind kShallowAngle;

void findJointFaults(const Looked &at, std::vector<Finding> &found);
void findInterferences(const LookedAtPlan &at, std::vector<Finding> &found);

} // namespace fff
