#include "core/base/written_number.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace fff {

namespace {

/// In threes, as one writes thousands: "1,234" and "12,345,678", not "0,125" and "12,34".
bool isGrouped(std::string_view digits, char separator)
{
    const std::size_t first = digits.find(separator);
    if (first == digits.npos || first == 0 || first > 3 || digits.front() == '0')
        return false;
    for (std::size_t at = first; at < digits.size(); at += 4)
        if (digits[at] != separator || digits.size() - at < 4 ||
            digits.substr(at + 1, 3).find(separator) != digits.npos)
            return false;
    return (digits.size() - first) % 4 == 0;
}

} // namespace

std::optional<double> writtenNumber(std::string digits, Commas commas)
{
    const std::size_t point = digits.rfind('.'), comma = digits.rfind(',');
    if (point != digits.npos && comma != digits.npos) {
        const char separator = point > comma ? ',' : '.';
        if (!isGrouped(std::string_view(digits).substr(0, std::max(point, comma)), separator))
            return std::nullopt;
        std::erase(digits, separator);
    } else if (comma != digits.npos && isGrouped(digits, ',') &&
               (commas == Commas::Groups || digits.find(',') != comma)) {
        std::erase(digits, ',');
    } else if (point != digits.npos && isGrouped(digits, '.') && digits.find('.') != point) {
        std::erase(digits, '.'); // one alone stands before decimals
    }
    std::replace(digits.begin(), digits.end(), ',', '.');
    double value = 0.0;
    const char *end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    return stop == end && error == std::errc() ? std::optional(value) : std::nullopt;
}

} // namespace fff
