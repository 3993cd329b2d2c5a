#include "core/analysis/pulling.h"

namespace fff {

Result<PulledTemplates> pulled(const Snapshot &snapshot, const PulledTemplates *previous,
                               Progress &, std::stop_token stop)
{
    return pullTemplates(snapshot.get(kModel), previous, {std::move(stop), {}});
}

} // namespace fff
