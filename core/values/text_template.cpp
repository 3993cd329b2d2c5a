#include "core/values/text_template.h"

#include "core/values/expression_words.h"

#include <algorithm>

namespace fff {

namespace {

ExpressionError movedBy(ExpressionError error, std::size_t bytes)
{
    error.place.begin += bytes;
    error.place.end += bytes;
    return error;
}

/// What a text falls into: from a "{" until behind its "}", and what is between those.
struct TemplatePiece
{
    TextRange place;
    bool isPlace = false;
    bool isOpen = false; // no "}" follows
};

std::vector<TemplatePiece> piecesOf(std::string_view text)
{
    std::vector<TemplatePiece> pieces;
    std::size_t begin = 0, at = 0;
    const auto endLiteral = [&] {
        if (at > begin)
            pieces.push_back({{begin, at}});
    };
    while (at < text.size()) {
        const bool isDoubled = at + 1 < text.size() && text[at + 1] == text[at];
        if (text[at] != '{' || isDoubled) {
            at += (text[at] == '{' || text[at] == '}') && isDoubled ? 2 : 1;
            continue;
        }
        endLiteral();
        const std::size_t close = text.find('}', at);
        const bool isOpen = close == text.npos;
        pieces.push_back({{at, isOpen ? text.size() : close + 1}, true, isOpen});
        begin = at = pieces.back().place.end;
    }
    endLiteral();
    return pieces;
}

std::string withoutDoubledBraces(std::string_view text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        if ((text[i] == '{' || text[i] == '}') && i + 1 < text.size() && text[i + 1] == text[i])
            ++i;
    }
    return result;
}

} // namespace

Understood<TextTemplate> TextTemplate::read(std::string_view text, const Reading &reading)
{
    if (text.size() > kLongestExpression)
        return misunderstood(expression_words::kTooLong, {0, text.size()},
                             {static_cast<int>(kLongestExpression)});
    TextTemplate result;
    result.m_text = text;
    for (const TemplatePiece &piece : piecesOf(text)) {
        const auto [begin, end] = piece.place;
        if (piece.isOpen)
            return misunderstood(expression_words::kOpenBrace, piece.place,
                                 {quoted(text, piece.place)});
        if (!piece.isPlace) {
            result.m_pieces.push_back(
                {piece.place, withoutDoubledBraces(text.substr(begin, end - begin)), {}});
            continue;
        }
        Understood<Formula> formula =
            Formula::read(text.substr(begin + 1, end - begin - 2), reading);
        if (!formula)
            return tl::unexpected(movedBy(formula.error(), begin + 1));
        for (const std::string &name : formula->names())
            if (std::find(result.m_names.begin(), result.m_names.end(), name) ==
                result.m_names.end())
                result.m_names.push_back(name);
        result.m_pieces.push_back({piece.place, {}, *std::move(formula)});
    }
    return result;
}

Understood<Worth> TextTemplate::worth(const Names &names, const NumberStyle &style) const
{
    Worth result;
    result.type = Worth::Type::Text;
    for (const Piece &piece : m_pieces) {
        if (!piece.formula) {
            result.text += piece.literal;
            continue;
        }
        const Understood<Worth> worth = piece.formula->worth(names);
        if (!worth)
            return tl::unexpected(movedBy(worth.error(), piece.place.begin + 1));
        result.text += shownText(*worth, style);
        if (result.text.size() > kLongestExpression) // texts of texts would double each time
            return misunderstood(
                expression_words::kTooLongText, piece.place,
                {quoted(m_text, piece.place), static_cast<int>(kLongestExpression)});
    }
    return result;
}

std::vector<TextRange> placesIn(std::string_view text)
{
    std::vector<TextRange> places;
    for (const TemplatePiece &piece : piecesOf(text))
        if (piece.isPlace)
            places.push_back({piece.place.begin + 1, piece.place.end - (piece.isOpen ? 0 : 1)});
    return places;
}

} // namespace fff
