#include "core/model/named_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool isSameName(std::string_view a, std::string_view b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

tl::unexpected<Error> unknown(std::string_view name)
{
    return failure(ErrorCode::UnknownReference, std::string(name), {std::string(name)});
}

tl::unexpected<Error> notAName(const std::string &name)
{
    return failure(ErrorCode::BadValue, "name", {name, "a word of letters and digits"});
}

} // namespace

bool isNumberName(std::string_view name)
{
    constexpr std::array<std::string_view, 7> kTaken{"t", "mm", "cm", "m", "in", "inch", "ft"};
    const auto isLetter = [](char c) { return (lower(c) >= 'a' && lower(c) <= 'z') || c == '_'; };
    return !name.empty() && name.size() <= kMaxNameLength && isLetter(name.front()) &&
           std::all_of(name.begin(), name.end(),
                       [&](char c) { return isLetter(c) || (c >= '0' && c <= '9'); }) &&
           std::none_of(kTaken.begin(), kTaken.end(),
                        [&](std::string_view taken) { return isSameName(name, taken); });
}

const NamedNumber *findNumber(const Document &document, std::string_view name)
{
    const auto found =
        std::find_if(document.numbers.begin(), document.numbers.end(),
                     [name](const NamedNumber &number) { return isSameName(number.name, name); });
    return found == document.numbers.end() ? nullptr : &*found;
}

Result<Document> setNumber(Document document, NamedNumber number)
{
    if (!isNumberName(number.name))
        return notAName(number.name);
    if (!std::isfinite(number.value))
        return failure(ErrorCode::BadValue, "value", {number.expression, "a number"});
    const NamedNumber *known = findNumber(document, number.name);
    if (!known) {
        document.numbers.push_back(std::move(number));
        return document;
    }
    NamedNumber &place =
        document.numbers[static_cast<std::size_t>(known - document.numbers.data())];
    place = std::move(number);
    return document;
}

Result<Document> removeNumber(Document document, std::string_view name)
{
    const NamedNumber *known = findNumber(document, name);
    if (!known)
        return unknown(name);
    document.numbers.erase(document.numbers.begin() + (known - document.numbers.data()));
    return document;
}

Result<Document> renameNumber(Document document, std::string_view name, std::string to)
{
    const NamedNumber *known = findNumber(document, name), *other = findNumber(document, to);
    if (!known)
        return unknown(name);
    if (!isNumberName(to) || (other && other != known))
        return notAName(to);
    document.numbers[static_cast<std::size_t>(known - document.numbers.data())].name =
        std::move(to);
    return document;
}

} // namespace fff
