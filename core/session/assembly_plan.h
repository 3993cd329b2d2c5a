// The plan of a model's assembly, from what is known of it.
#pragma once

#include "core/assembly/planning.h"
#include "core/session/analysis.h"

namespace fff {

/// A part of the model: the section's index and that of the piece of it (CutSection::parts()).
struct PartRef
{
    int section = 0, piece = 0;
    bool operator==(const PartRef &) const = default;
};

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
    std::vector<PartRef> parts;        // the plan's indices
    std::vector<PartOverlap> overlaps; // in the order of (a, b); the plan passes them over
    AssemblyPlan plan;
    std::optional<Stop> stop; // of two that are locked
};

/// The parts as solids, in the sections' order.
std::vector<Solid> solidsOf(const Analysis &analysis, std::vector<PartRef> &parts);
/// Which way the parts of a joint's sections come off each other; of all joints that hold.
std::vector<Slide> slidesOf(const Analysis &analysis, const std::vector<PartRef> &parts);
/// Pairs of parts that are deeper in each other than `depth` (mm), wherever they are.
std::vector<PartOverlap> overlapsOf(const std::vector<Solid> &solids, double depth);

/// A pure function of the analysis, but for the time. A part that a press fit holds may be as deep
/// in its mate as the clearance is negative and as bumps press into it from both sides.
ModelPlan planOf(const Analysis &analysis, const std::function<bool()> &isOutOfTime = {});

} // namespace fff
