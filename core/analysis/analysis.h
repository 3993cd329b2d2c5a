// All that is derived from one model, published as one immutable value.
#pragma once

#include "core/assembly/assembly.h"
#include "core/assembly/grips.h"

namespace fff {

/// Everything refers to sections by their index in `model`.
struct Analysis
{
    Model model; // the one it belongs to
    Assembly assembly;
    CutList cuts;  // one a section
    Bodies bodies; // that these are cut into
    Grips grips;   // what the joints hold of these
};

struct CaptiveCache;
/// Of its bodies, with those that all others hold together (captives.h).
std::vector<std::vector<int>> heldGroups(const Analysis &analysis);
std::vector<std::vector<int>> heldGroups(const Analysis &analysis, CaptiveCache &cache);
/// The one of these groups that the section's largest body is in.
std::vector<int> groupOf(const Analysis &analysis, int section);

using AnalysisPointer = std::shared_ptr<const Analysis>;

/// Not for several threads at once.
struct AnalysisCaches
{
    AnalysisPointer last; // from which the next one is made; null at first
    CutCache cuts;
};

/// As from scratch, with any caches. Reuses what they hold: an edit costs the work on the sections
/// it touches and their mates, and a copy of a few pointers for each of the others.
AnalysisPointer analyseNext(const Model &model, AnalysisCaches &caches);
/// The same as a value.
Analysis analyse(const Model &model, AnalysisCaches &caches);

/// Computes now what drawing will ask for, so that it costs a worker's time, not the window's.
/// prepared  what it has of this one is not looked at again; null: nothing
void prepareDrawing(const Analysis &analysis, const Analysis *prepared = nullptr);

} // namespace fff
