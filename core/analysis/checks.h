// The findings of each place of a drag: all but those that take planning.
#pragma once

#include "core/analysis/finder.h"

#include <span>

namespace fff {

/// What finds them, in the order in which a person reads them.
std::span<const Finder> finders();

/// Of each subject but Assembly at least one (Joints: only what is wrong), in the order of the
/// subjects and, within one, of the sections. A model that is not connected says so first; each of
/// its groups then stands or falls by itself. Nothing for a model without sections.
///
/// Deterministic. Costs what a layout does; for a worker, not for the window's thread.
std::vector<Finding> checks(const Analysis &analysis, const LayoutOptions &layout = {},
                            const CheckRules &rules = {});

/// As from scratch, with any caches.
std::vector<Finding> checks(const Analysis &analysis, CheckCaches &caches,
                            const LayoutOptions &layout = {}, const CheckRules &rules = {},
                            std::span<const Finder> by = finders());

} // namespace fff
