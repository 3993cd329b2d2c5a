#include "core/assembly/step_groups.h"

#include <algorithm>
#include <map>

namespace fff {

std::vector<StepGroup> stepGroups(const AssemblyPlan &plan)
{
    std::vector<StepGroup> steps;
    std::vector<int> lastOf;    // of each group its last step
    std::map<int, int> groupOf; // of each part that is there
    for (const AssemblyStep &step : plan.steps) {
        StepGroup made;
        if (step.onto.empty()) {
            made.group = static_cast<int>(lastOf.size());
            lastOf.push_back(0);
        } else {
            made.group = groupOf.at(*step.onto.begin());
        }
        const auto moved = groupOf.find(step.parts.front());
        if (moved != groupOf.end() && moved->second != made.group)
            made.joins = {lastOf[static_cast<std::size_t>(moved->second)],
                          lastOf[static_cast<std::size_t>(made.group)]};
        std::sort(made.joins.begin(), made.joins.end());
        for (const int part : step.parts)
            groupOf[part] = made.group;
        lastOf[static_cast<std::size_t>(made.group)] = static_cast<int>(steps.size());
        steps.push_back(std::move(made));
    }
    return steps;
}

} // namespace fff
