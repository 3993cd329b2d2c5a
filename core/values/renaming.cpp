#include "core/values/renaming.h"

#include "core/base/letters.h"
#include "core/base/utf8.h"
#include "core/values/expression_words.h"
#include "core/values/function_names.h"
#include "core/values/text_template.h"
#include "core/values/tokens.h"
#include "core/values/unit_signs.h"

#include <algorithm>

namespace fff {

namespace {

std::string_view partOf(std::string_view text, TextRange place)
{
    return text.substr(place.begin, place.end - place.begin);
}

void addNamePlaces(std::vector<TextRange> &places, std::string_view text, TextRange within)
{
    const std::string_view part = partOf(text, within);
    const std::vector<ExpressionToken> tokens = tokensOf(part);
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        const TextRange place = tokens[i].place;
        const bool isFunction = tokens[i + 1].is(U'(');
        const bool isBehindNumber = i > 0 && (tokens[i - 1].kind == ExpressionToken::Kind::Digits ||
                                              tokens[i - 1].is(U')'));
        if (tokens[i].kind == ExpressionToken::Kind::Word && !isFunction &&
            !(isBehindNumber && findUnitSign(partOf(part, place)) >= 0))
            places.push_back({place.begin + within.begin, place.end + within.begin});
    }
}

bool isWord(const std::u32string &letters)
{
    return !letters.empty() && letters.size() <= kLongestName && isNameLetter(letters.front()) &&
           std::all_of(letters.begin(), letters.end(), [](char32_t c) {
               return c != U'\ufffd' && (isNameLetter(c) || isDigit(c));
           });
}

} // namespace

std::optional<bool> switchWord(std::string_view text)
{
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    const std::string word = foldedName(text);
    if (word == "yes" || word == "true" || word == "on")
        return true;
    if (word == "no" || word == "false" || word == "off")
        return false;
    return std::nullopt;
}

std::vector<TextRange> namePlaces(std::string_view text, ValueKind kind)
{
    std::vector<TextRange> places;
    const bool isWords = kind == ValueKind::Text || kind == ValueKind::Choice;
    const std::size_t first = text.find_first_not_of(" \t");
    const bool beginsExpression = first != text.npos && text[first] == '=';
    if (!isWords || beginsExpression) {
        if (kind != ValueKind::Switch || !switchWord(text))
            addNamePlaces(places, text, {0, text.size()});
        return places;
    }
    if (kind == ValueKind::Text)
        for (const TextRange &place : placesIn(text))
            addNamePlaces(places, text, place);
    return places;
}

std::string renamedIn(std::string_view text, ValueKind kind, const Renames &renames)
{
    std::string result;
    std::size_t at = 0;
    for (const TextRange &place : namePlaces(text, kind)) {
        const auto found = renames.find(foldedName(partOf(text, place)));
        if (found == renames.end())
            continue;
        result += partOf(text, {at, place.begin});
        result += found->second;
        at = place.end;
    }
    return result += text.substr(at);
}

Understood<void> checkName(std::string_view name)
{
    const TextRange all{0, name.size()};
    if (!isWord(decoded(name)))
        return misunderstood(expression_words::kNoName, all,
                             {quoted(name, all), static_cast<int>(kLongestName)});
    const std::string folded = foldedName(name);
    if (folded == "t" || folded == "pi" || folded == "π" || findUnitSign(folded) >= 0 ||
        findFunction(folded) >= 0 || switchWord(folded))
        return misunderstood(expression_words::kTakenName, all, {quoted(name, all)});
    return {};
}

std::string freeName(std::string_view name, const std::function<bool(const std::string &)> &isTaken)
{
    std::u32string letters = decoded(name);
    std::erase_if(letters,
                  [](char32_t c) { return c == U'\ufffd' || !(isNameLetter(c) || isDigit(c)); });
    if (letters.empty() || isDigit(letters.front()))
        letters.insert(letters.begin(), U'_');
    constexpr std::size_t kForNumber = 8;
    std::string free = encoded(letters.substr(0, kLongestName));
    const std::string stem = encoded(letters.substr(0, kLongestName - kForNumber));
    for (int number = 2; !checkName(free) || isTaken(foldedName(free)); ++number)
        free = stem + '_' + std::to_string(number);
    return free;
}

} // namespace fff
