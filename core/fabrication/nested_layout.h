// Parts on sheets by their true outlines: closer together than their boxes would be.
#pragma once

#include "core/base/long_work.h"
#include "core/fabrication/layout.h"
#include "core/nesting/problem.h"

namespace fff {

struct NestOptions
{
    LayoutOptions layout; // `turnsFreely` is not looked at:
    nest::Turning turning = nest::Turning::Free;
    std::vector<nest::Turning> turnings; // of each part, where there is one, in place of that

    std::uint64_t seed = 1;
    std::int64_t work = 0; // for all stocks together, see nest::Options
    bool usesThreads = true;
};

struct NestedLayout
{
    Layout layout;
    std::int64_t work = 0; // that was done
};

/// As layOut(), for the same sheets with the same margin and spacing; holes and bays of parts are
/// room, too. Each stock by itself, with a share of the work that goes by its number of parts. What
/// fits no sheet as it may be turned is oversized. Never more sheets than layOut() takes, where its
/// turns are allowed.
///
/// Deterministic for the same parts, options and seed unless it is stopped; then what is best so
/// far is given out. Proven before: outlines are off the edge by the margin, and off each other by
/// the spacing (nesting/proof.h).
NestedLayout nestOut(const std::vector<Part> &parts, const Model &model, const NestOptions &options,
                     const LongWork &longWork = {});

} // namespace fff
