// What is to be known of a model before it is cut, on standard error.
#pragma once

#include "core/analysis/analysis.h"

namespace fff::cli {

/// Prints what is wrong with it, and what is not known, in the sentences of the window's Export
/// panel, the worst first; many of one kind in one line. Whether parts fit their sheets is for
/// whoever has laid them.
void printWarnings(const Analysis &analysis);

} // namespace fff::cli
