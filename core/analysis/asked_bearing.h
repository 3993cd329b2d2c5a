// The stage of where a section is strong enough: of the one that a person asks about.
#pragma once

#include "core/analysis/bearing_map.h"

namespace fff {

struct AskedBearing
{
    std::shared_ptr<const BearingMap> map; // null: nobody asks
    std::shared_ptr<StrengthCaches> caches;
};

inline constexpr StageOf<AskedBearing> kBearing{"bearing"};

Result<AskedBearing> askedBearing(const Snapshot &snapshot, const AskedBearing *previous,
                                  Progress &progress, std::stop_token stop);

} // namespace fff
