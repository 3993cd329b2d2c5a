// A sheet material. Values of the built-in ones: fabrication data sheets, named beside each.
#pragma once

#include "core/base/ids.h"
#include "core/geometry/vector.h"

#include <optional>
#include <string>

namespace fff {

struct Stock
{
    StockId id;
    std::string name;
    double thickness = 3.0;                 // mm
    double density = 1190.0;                // kg/m³
    std::optional<double> tensileStrength;  // MPa; none: not rated
    std::optional<double> flexuralStrength; // MPa; none: not rated
    std::optional<double> modulus;          // MPa; none: not rated
    double kerf = 0.15;                     // mm, full width that the machine removes
    double clearance = 0.0;                 // mm, play of a slit; negative presses
    Vec2 sheet = {600.0, 400.0};            // mm, width and height of one plate

    bool operator==(const Stock &) const = default;
};

/// What a new document starts with: birch plywood, 3 mm.
Stock birchPlywood();
/// What FlatFab's files mean: acrylic, an eighth of an inch, 60 MPa (paper, section Verification).
Stock flatfabAcrylic();

} // namespace fff
