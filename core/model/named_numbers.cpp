#include "core/model/named_numbers.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>

namespace fff {

namespace {

char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lower(std::string_view name)
{
    std::string result(name);
    std::transform(name.begin(), name.end(), result.begin(), [](char c) { return lower(c); });
    return result;
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

NumberNames namesBefore(const Document &document, std::size_t index)
{
    std::map<std::string, NamedValue> known; // by the name in lower case
    const auto valueOf = [](const std::map<std::string, NamedValue> &values,
                            std::string_view name) {
        const auto found = values.find(lower(name));
        return found == values.end() ? std::optional<NamedValue>() : found->second;
    };
    for (std::size_t i = 0; i < std::min(index, document.numbers.size()); ++i) {
        const NamedNumber &number = document.numbers[i];
        // Whether it is a length follows from those before.
        const Expression read =
            readAny(number.expression, Commas::Groups,
                    [&](std::string_view name) { return valueOf(known, name); });
        known.try_emplace(lower(number.name), NamedValue{number.value, read.isLength});
    }
    return
        [known = std::move(known), valueOf](std::string_view name) { return valueOf(known, name); };
}

tl::expected<Document, Expression> setExpression(Document document, const std::string &name,
                                                 const std::string &expression, Commas commas)
{
    assert(isNumberName(name) && "who asks for it has looked");
    const NamedNumber *known = findNumber(document, name);
    const auto index =
        known ? static_cast<std::size_t>(known - document.numbers.data()) : document.numbers.size();
    if (!known)
        document.numbers.push_back({name, {}, 0.0});
    const auto read = [&](std::size_t i, const std::string &text) {
        return readAny(text, commas, namesBefore(document, i));
    };
    const Expression own = read(index, expression);
    if (!own.value)
        return tl::unexpected(own);
    document.numbers[index].expression = expression;
    document.numbers[index].value = *own.value;
    for (std::size_t i = index + 1; i < document.numbers.size(); ++i)
        if (const Expression again = read(i, document.numbers[i].expression); again.value)
            document.numbers[i].value = *again.value;
    return document;
}

} // namespace fff
