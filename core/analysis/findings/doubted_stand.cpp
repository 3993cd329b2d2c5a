#include "core/analysis/findings/doubted_stand.h"

#include "core/analysis/findings/pulled_joints.h"
#include "core/analysis/findings/pushed_over.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"

namespace fff {

namespace {

/// What a finding says against it; empty: nothing.
Text providedOf(const Finding &finding)
{
    if (finding.severity != Severity::Error)
        return {};
    if (finding.is(kFolds))
        return FFF_TEXT("Checks", "if it did not fold");
    if (finding.is(kMovesWithin))
        return finding.sections.empty() ? FFF_TEXT("Checks", "if it did not slide away")
                                        : FFF_TEXT("Checks", "if nothing came loose");
    if (finding.is(kPulledOpen))
        return FFF_TEXT("Checks", "if no joint were pulled open");
    if (finding.is(kPushedOver))
        return FFF_TEXT("Checks", "if nothing pushed it");
    return {};
}

} // namespace

void doubtStanding(std::vector<Finding> &found)
{
    Text provided;
    for (const Finding &finding : found)
        if (const Text text = providedOf(finding); text.source && !provided.source)
            provided = text;
    if (!provided.source)
        return;
    for (Finding &finding : found)
        if (finding.is(kStands)) {
            Footing footing = *finding.details<Footing>();
            footing.provided = provided;
            finding.kind = &kWouldStand;
            finding.severity = Severity::Unknown;
            finding.setDetails(std::move(footing));
        }
}

} // namespace fff
