#include "core/analysis/findings/doubted_verdicts.h"

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/narrow_slits.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/pulled_joints.h"
#include "core/analysis/findings/pushed_over.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/findings/thin_necks.h"

#include <bit>

namespace fff {

namespace {

enum Verdict : unsigned { Connects = 1, Assembles = 2, Stands = 4, Holds = 8 };

/// What a finding says against verdicts; no text: nothing.
struct Doubt
{
    unsigned against = 0;
    Text provided;
};

Doubt doubtFrom(const Finding &finding)
{
    if (finding.is(kNotConnected) || finding.is(kLoosePieces) || finding.is(kSevered))
        return {Stands | Holds, FFF_TEXT("Checks", "if it held together")};
    if (finding.is(kHangsByNothing))
        return {Connects | Assembles | Stands | Holds, FFF_TEXT("Checks", "if nothing fell apart")};
    if (finding.is(kNarrowSlit) && finding.details<NarrowSlit>()->isClosed)
        return {Connects | Assembles | Stands | Holds,
                FFF_TEXT("Checks", "if the kerf closed no slit")};
    if (finding.is(kTightSlits))
        return {Assembles, FFF_TEXT("Checks", "if no slit were too tight")};
    if (finding.is(kWideSlits))
        return {Connects | Stands | Holds, FFF_TEXT("Checks", "if no slit were too wide")};
    if (finding.is(kFolds))
        return {Stands, FFF_TEXT("Checks", "if it did not fold")};
    if (finding.is(kMovesWithin))
        return {Stands, finding.sections.empty() ? FFF_TEXT("Checks", "if it did not slide away")
                                                 : FFF_TEXT("Checks", "if nothing came loose")};
    if (finding.is(kPulledOpen))
        return {Stands, FFF_TEXT("Checks", "if no joint were pulled open")};
    if (finding.is(kPushedOver))
        return {Stands, FFF_TEXT("Checks", "if nothing pushed it")};
    return {};
}

/// Of all that is wrong, or is so far, the first that says anything against a verdict; what says
/// something against most of them goes first. Null: none does.
const Finding *doubterOf(Verdict verdict, const std::vector<Finding> &found)
{
    const Finding *most = nullptr;
    int against = 0; // verdicts
    for (const Finding &finding : found) {
        if (finding.severity != Severity::Error && !finding.isYet)
            continue;
        const Doubt doubt = doubtFrom(finding);
        if ((doubt.against & verdict) == 0 || std::popcount(doubt.against) <= against)
            continue;
        most = &finding;
        against = std::popcount(doubt.against);
    }
    return most;
}

Text doubtOf(Verdict verdict, const std::vector<Finding> &found)
{
    const Finding *doubter = doubterOf(verdict, found);
    return doubter ? doubtFrom(*doubter).provided : Text();
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

struct Doubted
{
    Verdict verdict;
    const FindingKind *kind, *as;
    void (*doubt)(Finding &, const FindingKind &, const Text &);
};
constexpr Doubted kDoubted[] = {
    {Connects, &kConnected, &kWouldConnect, doubt<Connection>},
    {Assembles, &kCanAssemble, &kCouldAssemble, doubt<AssemblyOrder>},
    {Stands, &kStands, &kWouldStand, doubt<Footing>},
    {Holds, &kHolds, &kWouldHold, doubt<Held>},
};

} // namespace

void doubtVerdicts(std::vector<Finding> &found)
{
    for (const Doubted &row : kDoubted) {
        const Text provided = doubtOf(row.verdict, found);
        if (!provided.source)
            continue;
        for (Finding &finding : found)
            if (finding.kind == row.kind)
                row.doubt(finding, *row.as, provided);
    }
}

const Finding *doubterOf(const Finding &verdict, const std::vector<Finding> &found)
{
    for (const Doubted &row : kDoubted)
        if (verdict.is(*row.as))
            return doubterOf(row.verdict, found);
    return nullptr;
}

VerdictDoubts verdictDoubts(const std::vector<Finding> &found)
{
    return {doubtOf(Assembles, found), doubtOf(Stands, found), doubtOf(Holds, found)};
}

} // namespace fff
