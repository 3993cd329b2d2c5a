// What all parts weigh.
#pragma once

#include "core/analysis/finder.h"
#include "core/assembly/mass.h"

namespace fff {

extern const FindingKind kMass; // its details are MassProperties: kg, and its centre

void findMass(const Looked &at, std::vector<Finding> &found);

} // namespace fff
