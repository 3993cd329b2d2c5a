// Whether the model can be put together.
#pragma once

#include "core/analysis/plan_finder.h"

namespace fff {

/// Of all that have an order.
struct AssemblyOrder
{
    int steps = 0;
    int inEachOther = 0; // pairs of sections
    int loose = 0;       // parts that nothing holds to most of the others
    Text provided = {};  // kCouldAssemble: what keeps it from that
};
/// Of kCannotAssemble.
struct Blocked
{
    int joints = 0;         // of those that block each other
    int directions = 0;     // in which these slide
    double distance = 0.0;  // how far the first section comes out of the second one, mm; 0: it is
                            // not that
    bool areSlices = false; // of a mesh, in two directions or around an axis
    std::vector<ProblemLink> links; // who blocks whom
};
/// Of kOrderUnknown.
struct OrderUnknown
{
    std::optional<Error> failure; // none: it took too long
};

extern const FindingKind kCanAssemble, kCouldAssemble;
/// There is an order, but for parts that take up the same place where they end up.
extern const FindingKind kCanOtherwiseAssemble;
extern const FindingKind kCannotAssemble; // parts that block each other
extern const FindingKind kOrderUnknown;   // not found within the time
extern const ActionKind kMakeAssemblable; // slits turned round (flips.h)
extern const ActionKind kShowSteps;

void findOrder(const LookedAtPlan &at, std::vector<Finding> &found);

} // namespace fff
