#include "core/base/written_number.h"

#include <algorithm>
#include <charconv>

namespace fff {

std::optional<double> writtenNumber(std::string digits, Commas commas)
{
    const std::size_t point = digits.rfind('.'), comma = digits.rfind(',');
    if (point != digits.npos && comma != digits.npos)
        std::erase(digits, point > comma ? ',' : '.');
    else if (comma != digits.npos && commas == Commas::Groups && digits.size() - comma == 4)
        std::erase(digits, ',');
    std::replace(digits.begin(), digits.end(), ',', '.');
    double value = 0.0;
    const char *end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    return stop == end && error == std::errc() ? std::optional(value) : std::nullopt;
}

} // namespace fff
