#include "core/analysis/findings/doubted_verdicts.h"

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/pulled_joints.h"
#include "core/analysis/findings/pushed_over.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/findings/thin_necks.h"

namespace fff {

namespace {

/// What a finding says against that it stands; empty: nothing.
Text whyNotStanding(const Finding &finding)
{
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

/// What it says against all of that.
Text whyNotWhole(const Finding &finding)
{
    if (finding.is(kNotConnected) || finding.is(kLoosePieces) || finding.is(kSevered) ||
        finding.is(kHangsByNothing))
        return FFF_TEXT("Checks", "if it held together");
    return {};
}

/// The first of what is wrong, or is so far, that says anything.
Text firstOf(const std::vector<Finding> &found, Text (*why)(const Finding &))
{
    for (const Finding &finding : found)
        if (finding.severity == Severity::Error || finding.isYet)
            if (const Text text = why(finding); text.source)
                return text;
    return {};
}

/// The same verdict as one that hangs on something.
template <class Details>
void doubt(Finding &finding, const FindingKind &as, const Text &provided)
{
    Details details = *finding.details<Details>();
    details.provided = provided;
    finding.kind = &as;
    finding.severity = Severity::Unknown;
    finding.setDetails(std::move(details));
}

} // namespace

void doubtVerdicts(std::vector<Finding> &found)
{
    const Text whole = firstOf(found, whyNotWhole);
    const Text standing = whole.source ? whole : firstOf(found, whyNotStanding);
    for (Finding &finding : found) {
        if (finding.is(kStands) && standing.source)
            doubt<Footing>(finding, kWouldStand, standing);
        else if (finding.is(kHolds) && whole.source)
            doubt<Held>(finding, kWouldHold, whole);
    }
}

} // namespace fff
