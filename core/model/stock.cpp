#include "core/model/stock.h"

#include <cmath>

namespace fff {

bool cutsTheSameSlits(const Stock &a, const Stock &b)
{
    return a.thickness == b.thickness && a.clearance == b.clearance && a.slitEnd == b.slitEnd &&
           (a.toolDiameter == b.toolDiameter || a.slitEnd == SlitEnd::Square) &&
           a.leadIn == b.leadIn && a.bumps == b.bumps;
}

void setThickness(Stock &stock, double mm, bool isMeasured)
{
    // What cast acrylic may be off by (ISO 7823-1), more than any board is.
    constexpr double kOff = 0.4, kOffShare = 0.1; // mm; of what it is sold as
    const double sold = stock.nominalThickness.value_or(stock.thickness);
    const bool isOfThat =
        isMeasured || stock.nominalThickness || std::abs(mm - sold) <= kOff + kOffShare * sold;
    stock.thickness = mm;
    stock.nominalThickness = isOfThat && sold != mm ? std::optional(sold) : std::nullopt;
}

Stock birchPlywood()
{
    Stock stock;
    stock.name = "Birch plywood";
    stock.thickness = 3.0;
    stock.density = 660.0;
    // Across the grain, the weaker way, of film-faced birch plywood.
    stock.tensileStrength = 25.0;
    stock.flexuralStrength = 30.0;
    stock.modulus = 4000.0;
    stock.kerf = 0.20;
    return stock;
}

Stock flatfabAcrylic()
{
    Stock stock;
    stock.name = "Acrylic";
    stock.thickness = 3.175;
    stock.density = 1190.0;
    stock.tensileStrength = 60.0;
    stock.flexuralStrength = 60.0;
    stock.modulus = 2800.0;
    stock.lastingShare = kAcrylicForMonths;
    // The files name no machine: until a person does, parts are cut as they were designed.
    stock.kerf = 0.0;
    return stock;
}

} // namespace fff
