#include "core/analysis/asked_bearing.h"

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"

namespace fff {

Result<AskedBearing> askedBearing(const Snapshot &snapshot, const AskedBearing *previous,
                                  Progress &progress, std::stop_token stop)
{
    AskedBearing out;
    out.caches = previous ? previous->caches : std::make_shared<StrengthCaches>();
    const std::optional<SectionRef> &section = snapshot.get(kQuestions).bearing;
    if (!section)
        return out;
    const LongWork work{std::move(stop), [&progress](double share) { progress.set(share); }};
    Result<BearingMap> map = bearingMap(snapshot.get(kAnalysed).analysis, *section,
                                        snapshot.get(kRules).strength, *out.caches, work);
    if (!map)
        return tl::unexpected(std::move(map.error()));
    out.map = std::make_shared<const BearingMap>(*std::move(map));
    return out;
}

} // namespace fff
