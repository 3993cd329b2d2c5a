// What machines remove of a stock, by the machine.
#pragma once

#include "core/model/document.h"

#include <optional>
#include <string_view>

namespace fff {

/// None: nothing is known of that machine.
std::optional<double> kerfOn(const Stock &stock, std::string_view machine);
/// The stock's kerf from now on, and known of the machine where one is named.
void setKerf(Stock &stock, std::string_view machine, double kerf);
/// All stocks with the kerf of that machine, where it is known.
Document cutOn(Document document, std::string_view machine);

} // namespace fff
