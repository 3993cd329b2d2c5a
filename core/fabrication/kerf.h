// Cutting paths that make up for what the machine removes.
#pragma once

#include "core/fabrication/part.h"

namespace fff {

/// The path of the cut's middle that leaves the region as designed: outer boundary moved outwards
/// by half the kerf, holes inwards. A slit is part of the outer boundary and becomes narrower by
/// the kerf.
/// kerf   full width of the cut, mm; 0 (or less) gives the region back untouched
/// Errors  CannotOffset, see grow().
Result<CurvedRegion> compensateKerf(const CurvedRegion &region, double kerf);

/// The parts with their outlines compensated for the kerf of each one's stock. Marks stay.
/// parts   all that makeParts makes of these bodies, in its order; their cuts keep the outlines
/// Errors  CannotOffset, with the name of the first section that has a part without a path.
Result<std::vector<Part>> compensateKerf(std::vector<Part> parts, const Model &model,
                                         const Bodies &bodies);

/// A length for the arguments of an error: millimetres to two digits.
std::string millimetres(double length);

} // namespace fff
