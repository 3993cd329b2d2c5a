// What could not be worked out of a model, and sections whose slits leave nothing of them, or more
// than one part.
#pragma once

#include "core/analysis/finder.h"

namespace fff {

/// Of kDivided.
struct DividedSection
{
    int parts = 0;
};

extern const FindingKind kDivided;     // its slits divide a section into several parts, all held
extern const FindingKind kNothingLeft; // its slits leave nothing of a section
extern const FindingKind kNotCutOut; // what they leave could not be worked out; all else counts it
                                     // without them
extern const FindingKind kNotMade;   // an operation's sections; its details are the Named operation

void findFailures(const Looked &at, std::vector<Finding> &found);
void findDivided(const Looked &at, std::vector<Finding> &found);

} // namespace fff
