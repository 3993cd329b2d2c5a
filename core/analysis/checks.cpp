#include "core/analysis/checks.h"

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/narrow_slits.h"
#include "core/analysis/findings/sheet_fit.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/total_mass.h"
#include "core/analysis/findings/waste.h"
#include "core/analysis/findings/wholeness.h"

namespace fff {

std::span<const Finder> finders()
{
    static constexpr Finder all[] = {findConnection,  findLoosePieces, findStanding, findSheetFit,
                                     findMass,        findJointFaults, findFailures, findDivided,
                                     findLooseJoints, findNarrowSlits, findWaste};
    return all;
}

std::vector<Finding> checks(const Analysis &analysis, const LayoutOptions &layout,
                            const CheckRules &rules)
{
    CheckCaches caches;
    return checks(analysis, caches, layout, rules);
}

std::vector<Finding> checks(const Analysis &analysis, CheckCaches &caches,
                            const LayoutOptions &layout, const CheckRules &rules,
                            std::span<const Finder> by)
{
    std::vector<Finding> found;
    const std::size_t count = analysis.model.sectionCount();
    refreshCaches(analysis, layout, caches);
    if (count == 0)
        return found;
    const Looked at{analysis, layout, rules, caches, heldGroups(analysis, caches.captives)};
    for (const Finder find : by)
        find(at, found);
    return found;
}

} // namespace fff
