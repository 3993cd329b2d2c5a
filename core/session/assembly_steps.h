// The steps in which a model is put together, for those who show them: in the view, on paper, as
// pictures.
#pragma once

#include "core/analysis/assembly_plan.h"
#include "core/assembly/playback.h"
#include "core/assembly/step_groups.h"

#include <QString>

#include <memory>
#include <vector>

namespace fff {

/// Refers to all parts by the plan's indices.
struct AssemblySteps
{
    AnalysisPointer analysis;
    Bodies bodies; // the plan's parts
    Playback playback;
    /// Of each step: the sections, of what its parts are brought to, that joints connect them with;
    /// ascending.
    std::vector<std::vector<int>> mates;
    std::vector<StepGroup> groups; // of each step

    /// As engraved (core/fabrication/part.h): 1 … n.
    static int numberOf(int part) { return part + 1; }
    const Section &sectionOf(int part) const
    {
        return *analysis->model.section(static_cast<std::size_t>(bodies.sectionOf(part)));
    }
};

using AssemblyStepsPointer = std::shared_ptr<const AssemblySteps>;

/// plan  of this analysis. Null when it has no steps: the model is empty, cannot be put together,
///       or the order was not found.
AssemblyStepsPointer assemblySteps(AnalysisPointer analysis, const ModelPlan &plan);

/// Why there are no steps, as a sentence for people; empty when there are some.
QString whyNoSteps(const Analysis &analysis, const ModelPlan &plan);

/// "Step 4 of 38"
QString stepTitle(const AssemblySteps &steps, int step);
/// What a person does in it: "slide Rib 3 down into Body".
QString stepText(const AssemblySteps &steps, int step);

} // namespace fff
