// The parts of a model for printers: 3MF.
#pragma once

#include "core/io/formats.h"
#include "core/io/solids.h"

#include <string>

namespace fff::io {

/// An object a part, under its section's name, each of them built where it is (solids.h); mm, Z up.
/// Coordinates to 1e-6 mm. Same bytes for same input. Errors  as partSolids(); BadCount for more
/// than a packed file holds.
/// Source  3MF Consortium, Core Specification 1.3, sections 2 to 4.
Result<std::string> writeThreeMf(const Model &model, const Bodies &bodies, Lying lying = {});

const Format &threeMfFormat();

} // namespace fff::io
