// A number as people write it, with its commas and points.
#pragma once

#include "core/base/expression.h"

#include <optional>
#include <string>

namespace fff {

/// digits  ASCII digits, points and commas. Where both stand the later one is before the decimals.
/// Nothing for what is no number ("1.2.3").
std::optional<double> writtenNumber(std::string digits, Commas commas);

} // namespace fff
