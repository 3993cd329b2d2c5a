#include "core/analysis/finding_action.h"

namespace fff {

std::vector<FindingAction> actionsOf(const Finding &finding, const Analysis &analysis,
                                     const Flips *flips)
{
    if (!finding.kind->actions)
        return {};
    std::vector<FindingAction> actions = finding.kind->actions(finding, analysis);
    std::erase_if(actions, [&](const FindingAction &action) {
        return isEdit(*action.kind) && !carriedOut(action, finding, analysis, flips);
    });
    return actions;
}

std::optional<FindingEdit> carriedOut(const FindingAction &action, const Finding &finding,
                                      const Analysis &analysis, const Flips *flips)
{
    return isEdit(*action.kind) ? action.kind->carriedOut(action, finding, analysis, flips)
                                : std::nullopt;
}

} // namespace fff
