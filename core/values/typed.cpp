#include "core/values/typed.h"

#include "core/base/letters.h"
#include "core/values/expression_words.h"
#include "core/values/renaming.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff {

namespace {

namespace said = expression_words;

constexpr double kLargestCount = 1e15; // beyond it not every whole number is one of a double

bool beginsExpression(std::string_view text)
{
    const auto isBlankByte = [](char c) { return c == ' ' || c == '\t'; };
    const auto first = std::find_if_not(text.begin(), text.end(), isBlankByte);
    return first != text.end() && *first == '=';
}

Worth textWorth(std::string text)
{
    Worth worth;
    worth.type = Worth::Type::Text;
    worth.text = std::move(text);
    return worth;
}

Powers powersOf(ValueKind kind)
{
    return kind == ValueKind::Length  ? kLengthPowers
           : kind == ValueKind::Angle ? kAnglePowers
           : kind == ValueKind::Mass  ? kMassPowers
                                      : Powers();
}

double ownUnit(ValueKind kind, const Reading &reading)
{
    return kind == ValueKind::Length  ? reading.lengthUnit
           : kind == ValueKind::Angle ? reading.angleUnit
           : kind == ValueKind::Mass  ? reading.massUnit
                                      : 1.0;
}

Understood<Worth> asWhole(Worth worth, const Formula &formula)
{
    const double whole = std::round(worth.number);
    const double slack = kSameNumber * std::max(1.0, std::abs(whole));
    const TextRange all{0, formula.text().size()};
    if (std::abs(worth.number - whole) > slack)
        return misunderstood(said::kNotWhole, all,
                             {quoted(formula.text(), all), argumentOf(worth)});
    if (std::abs(whole) > kLargestCount)
        return misunderstood(said::kTooLarge, all, {quoted(formula.text(), all)});
    worth.number = whole;
    return worth;
}

/// What the expression is, as one of the kind.
Understood<Worth> asKind(Worth worth, ValueKind kind, const Formula &formula)
{
    if (kind == ValueKind::Text)
        return textWorth(shownText(worth));
    const Worth::Type type = kind == ValueKind::Choice   ? Worth::Type::Text
                             : kind == ValueKind::Switch ? Worth::Type::Truth
                                                         : Worth::Type::Number;
    const Powers powers = powersOf(kind);
    const bool stands = worth.type == Worth::Type::Number && worth.powers.isNone() && worth.isBare;
    if (worth.type != type || (worth.powers != powers && !stands)) {
        const TextRange all{0, formula.text().size()};
        return misunderstood(said::kNeeds, all,
                             {quoted(formula.text(), all), nounOf(worth), nounOf(kind)});
    }
    if (worth.powers != powers) {
        worth.powers = powers;
        worth.number *= ownUnit(kind, formula.reading());
    }
    worth.isBare = kind == ValueKind::Number;
    return kind == ValueKind::Count ? asWhole(std::move(worth), formula) : worth;
}

} // namespace

Understood<Typed> Typed::read(std::string_view text, ValueKind kind, const Reading &reading)
{
    Typed typed;
    typed.m_kind = kind;
    const bool isExpression = beginsExpression(text);
    if (kind == ValueKind::Text && !isExpression) {
        auto content = TextTemplate::read(text, reading);
        if (!content)
            return tl::unexpected(std::move(content.error()));
        typed.m_content = *std::move(content);
        return typed;
    }
    if (kind == ValueKind::Choice && !isExpression) {
        typed.m_content = Literal{std::string(text), textWorth(std::string(text))};
        return typed;
    }
    if (const auto word = kind == ValueKind::Switch ? switchWord(text) : std::nullopt) {
        typed.m_content =
            Literal{std::string(text), {Worth::Type::Truth, {}, false, *word ? 1.0 : 0.0}};
        return typed;
    }
    auto content = Formula::read(text, reading);
    if (!content)
        return tl::unexpected(std::move(content.error()));
    typed.m_content = *std::move(content);
    return typed;
}

Understood<Worth> Typed::worth(const Names &names) const
{
    if (const Literal *literal = std::get_if<Literal>(&m_content))
        return literal->worth;
    if (const TextTemplate *text = std::get_if<TextTemplate>(&m_content))
        return text->worth(names);
    const Formula &formula = std::get<Formula>(m_content);
    Understood<Worth> worth = formula.worth(names);
    return worth ? asKind(*std::move(worth), m_kind, formula) : worth;
}

const std::string &Typed::text() const
{
    if (const Literal *literal = std::get_if<Literal>(&m_content))
        return literal->text;
    if (const TextTemplate *text = std::get_if<TextTemplate>(&m_content))
        return text->text();
    return std::get<Formula>(m_content).text();
}

const std::vector<std::string> &Typed::names() const
{
    static const std::vector<std::string> none;
    if (const TextTemplate *text = std::get_if<TextTemplate>(&m_content))
        return text->names();
    const Formula *formula = std::get_if<Formula>(&m_content);
    return formula ? formula->names() : none;
}

bool Typed::isConstant() const
{
    if (const TextTemplate *text = std::get_if<TextTemplate>(&m_content))
        return std::none_of(text->pieces().begin(), text->pieces().end(),
                            [](const TextTemplate::Piece &piece) { return piece.formula; });
    const Formula *formula = std::get_if<Formula>(&m_content);
    return !formula || std::all_of(formula->nodes().begin(), formula->nodes().end(),
                                   [](const FormulaNode &node) {
                                       return node.kind == FormulaNode::Kind::Number ||
                                              node.kind == FormulaNode::Kind::Unit ||
                                              node.kind == FormulaNode::Kind::Negate ||
                                              node.kind == FormulaNode::Kind::Text;
                                   });
}

TextRange Typed::placeOf(std::string_view name) const
{
    for (const TextRange &place : namePlaces(text(), m_kind))
        if (foldedName(std::string_view(text()).substr(place.begin, place.end - place.begin)) ==
            name)
            return place;
    return {0, text().size()};
}

std::string withoutName(const Typed &typed, std::string_view name, const Names &names)
{
    const auto has = [name](const std::vector<std::string> &all) {
        return std::find(all.begin(), all.end(), name) != all.end();
    };
    const TextTemplate *text = std::get_if<TextTemplate>(&typed.m_content);
    if (!has(typed.names()) || !typed.worth(names))
        return typed.text();
    if (!text)
        return exactText(*typed.worth(names), typed.kind());
    std::string result;
    for (const TextTemplate::Piece &piece : text->pieces()) {
        const auto [begin, end] = piece.place;
        if (piece.formula && has(piece.formula->names()))
            result += exactText(textWorth(shownText(*piece.formula->worth(names))), typed.kind());
        else
            result += text->text().substr(begin, end - begin);
    }
    return result;
}

} // namespace fff
