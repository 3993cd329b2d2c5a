#include "core/model/materials.h"

#include <array>

namespace fff {

std::span<const SheetSize> commonSheets()
{
    // Beds by the device profiles of rayforge and MeerK40t; Glowforge's stock 12 × 20 in; largest
    // sheets of Snijlab and Laser Garage.
    static const std::array<SheetSize, 12> all{{{"A4", {297, 210}},
                                                {"A3", {420, 297}},
                                                {"Letter", {279.4, 215.9}},
                                                {"K40 laser", {300, 200}},
                                                {"12 × 20 in", {508, 304.8}},
                                                {"", {400, 400}},
                                                {"", {600, 300}},
                                                {"", {600, 400}},
                                                {"", {700, 500}},
                                                {"", {900, 600}},
                                                {"", {1200, 600}},
                                                {"Whole plywood board", {1525, 1525}}}};
    return all;
}

} // namespace fff
