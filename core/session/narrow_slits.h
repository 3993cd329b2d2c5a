// Slits that the mill's tool does not go into.
#pragma once

#include "core/session/checks.h"

namespace fff {

/// How wide a slit is at its narrowest, mm: between its bumps, or a short closed one along itself.
double narrowest(const Slit &slit);

/// One check a stock whose slits end round, of those of its slits that are narrower than its tool:
/// about the sections that have them, at the narrowest. In the order of the stocks.
std::vector<Check> narrowSlits(const Analysis &analysis);

} // namespace fff
