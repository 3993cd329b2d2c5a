// The plan of a model's assembly, from what is known of it.
#pragma once

#include "core/analysis/analysis.h"
#include "core/assembly/planning.h"

namespace fff {

/// Two parts that are in each other where they end up.
struct PartOverlap
{
    int a = 0, b = 0; // indices of parts, a < b
    Interpenetration how;
};

/// A part that comes out of its slit, but then runs into the one that it came out of.
struct Stop
{
    int part = 0, by = 0;  // indices of parts
    double distance = 0.0; // mm
};

struct ModelPlan
{
    Bodies bodies;                     // the plan's indices: its parts
    std::vector<PartOverlap> overlaps; // in the order of (a, b); on its way none is deeper
    AssemblyPlan plan;
    std::optional<Stop> stop;     // of two that are locked
    std::optional<Error> failure; // why nothing is known: haveSolids(); then there are no bodies
};

/// What is known from the time before. Not for several threads at once.
struct PlanCaches
{
    Collisions collisions;
};

/// Of each body. Every one has to have one (haveSolids). None when the time is over before.
std::vector<SolidPointer> solidsOf(const Bodies &bodies,
                                   const std::function<bool()> &isOutOfTime = {});
/// Which way the bodies of a joint's sections come off each other; of all joints that hold.
std::vector<Slide> slidesOf(const Analysis &analysis);
/// Pairs of parts that are in each other, wherever they are; those that are found in the time.
std::vector<PartOverlap> overlapsOf(Collisions &collisions,
                                    const std::function<bool()> &isOutOfTime = {});

/// How many pairs of sections are in each other by this, mm, or more.
std::size_t pairsInEachOther(const ModelPlan &plan, double least);

/// A pure function of the analysis, but for the time. A part that a press fit holds may be as deep
/// in its mate as the clearance is negative and as bumps press into it from both sides.
ModelPlan planOf(const Analysis &analysis, const std::function<bool()> &isOutOfTime = {});
/// The same, with any caches: an edit costs the look at what it touches, and the search itself.
ModelPlan planOf(const Analysis &analysis, PlanCaches &caches,
                 const std::function<bool()> &isOutOfTime = {});

} // namespace fff
