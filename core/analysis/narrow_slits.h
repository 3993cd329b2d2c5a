// Slits that the mill's tool does not go into, or that the kerf closes.
#pragma once

#include "core/analysis/checks.h"

namespace fff {

/// How wide a slit is at its narrowest, mm: between its bumps, or a short closed one along itself.
double narrowest(const Slit &slit);

/// Whether nothing stays of a slit of this width, mm, when the path runs half the kerf inside it. A
/// path of less than a micron is none.
bool isClosedBy(double kerf, double width);

/// One check a stock, in their order, about the sections that have such slits, at the narrowest: an
/// error of those that its kerf closes, or else, where its slits end round, a warning of those that
/// are narrower than its tool.
std::vector<Check> narrowSlits(const Analysis &analysis);

} // namespace fff
