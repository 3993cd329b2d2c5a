// What stays between the slits of a section, and beside them.
#pragma once

#include "core/analysis/plan_finder.h"

namespace fff {

/// Of both; the finding's others are whom its one or two slits hold.
struct ThinWeb
{
    double width = 0.0;     // what stays, mm
    bool isByAHole = false; // a slit and a hole, not a slit and the edge
};

extern const FindingKind kThinWeb;   // less than the stock's thickness stays beside a slit
extern const FindingKind kSlitsMeet; // two slits run into each other

/// Less than half of the thickness breaks in the hand; below the whole of it it is good to know.
void findThinWebs(const LookedAtPlan &at, std::vector<Finding> &found);

} // namespace fff
