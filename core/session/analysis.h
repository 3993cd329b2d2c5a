// All that is derived from one model, published as one immutable value.
#pragma once

#include "core/assembly/assembly.h"
#include "core/fabrication/cut_section.h"

namespace fff {

/// Everything refers to sections by their index in `model`.
struct Analysis
{
    Model model; // the one it belongs to
    Assembly assembly;
    std::vector<CutSectionPointer> cuts; // one a section
};

struct AnalysisCaches
{
    CrossingCache crossings;
    CutCache cuts;
};

/// Reuses what the caches hold: an edit costs the work of what it touches.
Analysis analyse(const Model &model, AnalysisCaches &caches);

/// Computes now what drawing will ask for, so that it costs a worker's time, not the window's.
void prepareDrawing(const Analysis &analysis);

} // namespace fff
