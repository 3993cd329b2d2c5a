#include "core/analysis/planned.h"

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"

namespace fff {

namespace {

/// True once the rules' time for planning is over, or nobody wants to know any more.
std::function<bool()> limitOf(const Snapshot &snapshot, const std::stop_token &stop)
{
    return [isOver = timeLimit(snapshot.get(kRules).planningTime), stop] {
        return stop.stop_requested() || isOver();
    };
}

} // namespace

Result<PlannedAnalysis> planned(const Snapshot &snapshot, const PlannedAnalysis *previous,
                                Progress &, std::stop_token stop)
{
    using Caches = PlannedAnalysis::Caches;
    PlannedAnalysis out{snapshot.get(kAnalysed).analysis,
                        {},
                        {},
                        previous ? previous->caches : std::make_shared<Caches>()};
    out.plan = planOf(*out.analysis, out.caches->plan, limitOf(snapshot, stop));
    if (stop.stop_requested())
        return failure(ErrorCode::Cancelled);
    out.findings = planChecks(*out.analysis, out.plan, out.caches->checks, snapshot.get(kRules));
    return out;
}

Result<FoundFlips> foundFlips(const Snapshot &snapshot, const FoundFlips *, Progress &,
                              std::stop_token stop)
{
    FoundFlips out{flipsThatHelp(*snapshot.get(kAnalysed).analysis, snapshot.get(kPlanned).plan,
                                 limitOf(snapshot, stop))};
    if (stop.stop_requested())
        return failure(ErrorCode::Cancelled);
    return out;
}

} // namespace fff
