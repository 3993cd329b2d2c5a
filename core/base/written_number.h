// A number as people write it, with its commas and points.
#pragma once

#include "core/base/expression.h"

#include <optional>
#include <string>

namespace fff {

/// digits  ASCII digits, points and commas. Where both stand the later one is before the decimals,
/// and the others are between thousands; so are several of one kind, and with Commas::Groups one
/// comma that can be. Nothing for what is no number ("1.2.3", "12,34.5").
std::optional<double> writtenNumber(std::string digits, Commas commas);

} // namespace fff
