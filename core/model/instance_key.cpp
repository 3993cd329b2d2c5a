#include "core/model/instance_key.h"

#include <charconv>
#include <optional>

namespace fff {

namespace {

/// The part before the next "/", which goes from `rest`.
std::string_view nextPart(std::string_view &rest)
{
    const std::size_t end = rest.find('/');
    const std::string_view part = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return part;
}

std::optional<long> numberIn(std::string_view part)
{
    long number = 0;
    const char *end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// "o12" begins with "o".
std::string_view stemOf(std::string_view word)
{
    const std::size_t last = word.find_last_not_of("0123456789");
    return word.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Negative, 0 or positive.
int comparedParts(std::string_view a, std::string_view b)
{
    std::optional<long> x = numberIn(a), y = numberIn(b);
    if (x.has_value() != y.has_value())
        return x ? -1 : 1;
    if (!x) {
        const std::string_view stem = stemOf(a);
        if (const int order = stem.compare(stemOf(b)); order != 0)
            return order;
        x = numberIn(a.substr(stem.size()));
        y = numberIn(b.substr(stem.size()));
        if (x.has_value() != y.has_value())
            return x ? 1 : -1;
    }
    if (x && *x != *y)
        return *x < *y ? -1 : 1;
    return a.compare(b); // of equal numbers, too: "1" and "01" are two keys
}

} // namespace

bool isKeyBefore(std::string_view a, std::string_view b)
{
    while (!a.empty() && !b.empty()) {
        const int order = comparedParts(nextPart(a), nextPart(b));
        if (order != 0)
            return order < 0;
    }
    return a.empty() && !b.empty();
}

std::string keyBelow(std::string_view key, std::string_view part)
{
    std::string result(key);
    if (!result.empty())
        result += '/';
    return result.append(part);
}

std::string keyBelow(std::string_view key, long part)
{
    return keyBelow(key, std::to_string(part));
}

} // namespace fff
