// The contract of what finds: a function that looks at a model that is worked out, and adds what it
// finds.
#pragma once

#include "core/analysis/check_caches.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/finding_action.h"

#include <vector>

namespace fff {

/// What the findings of each place of a drag are found in; the model has sections.
struct Looked
{
    const Analysis &analysis;
    const LayoutOptions &layout;
    const CheckRules &rules;
    CheckCaches &caches;                        // up to date
    const std::vector<std::vector<int>> groups; // of bodies that joints hold together (heldGroups)
};
using Finder = void (*)(const Looked &, std::vector<Finding> &);

} // namespace fff
