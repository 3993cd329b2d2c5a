// Which group of parts each step of an assembly works on.
#pragma once

#include "core/assembly/planning.h"

#include <vector>

namespace fff {

struct StepGroup
{
    /// Counted from 0 as they are begun. A group that is brought to another one becomes part of
    /// that, and its number is used no more.
    int group = 0;
    /// Of a step that brings two groups together that were built apart: the last steps of both,
    /// indices into the plan, ascending. Else empty.
    std::vector<int> joins;

    bool operator==(const StepGroup &) const = default;
};

/// Of each step of the plan.
std::vector<StepGroup> stepGroups(const AssemblyPlan &plan);

} // namespace fff
