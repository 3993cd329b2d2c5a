#include "core/analysis/plan_checks.h"

#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/rings.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/findings/touching_pairs.h"

#include <set>

namespace fff {

std::span<const PlanFinder> planFinders()
{
    static constexpr PlanFinder all[] = {findOrder, findInterferences, findTouching, findRings,
                                         findThinWebs};
    return all;
}

std::vector<int> sectionsOf(const std::vector<int> &parts, const ModelPlan &plan)
{
    std::set<int> sections;
    for (const int part : parts)
        sections.insert(plan.bodies.sectionOf(part));
    return {sections.begin(), sections.end()};
}

ProblemLink linkOf(const Model &model, const Joint &joint)
{
    const auto middleOf = [&](int index) {
        const Section &section = *model.section(static_cast<std::size_t>(index));
        return section.frame.toWorld(section.shape->centroid());
    };
    const auto &axis = joint.crossing->axis;
    return {middleOf(joint.a), axis.at(joint.crossing->overlaps.front().meet), middleOf(joint.b),
            axis.direction};
}

std::vector<Finding> planChecks(const Analysis &analysis, const ModelPlan &plan,
                                const CheckRules &rules)
{
    PlanCheckCaches caches;
    return planChecks(analysis, plan, caches, rules);
}

std::vector<Finding> planChecks(const Analysis &analysis, const ModelPlan &plan,
                                PlanCheckCaches &caches, const CheckRules &rules)
{
    std::vector<Finding> found;
    const bool isEmpty =
        plan.bodies.size() == 0 && plan.plan.verdict == AssemblyPlan::Verdict::Possible;
    if (isEmpty)
        return found;
    const LookedAtPlan at{analysis, plan, rules, caches};
    for (const PlanFinder find : planFinders())
        find(at, found);
    return found;
}

std::function<bool()> timeLimit(std::chrono::milliseconds time)
{
    const auto end = std::chrono::steady_clock::now() + time;
    return [end] { return std::chrono::steady_clock::now() >= end; };
}

} // namespace fff
