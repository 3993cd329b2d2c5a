#include "core/base/letters.h"
#include "core/base/written_number.h"
#include "core/values/expression_words.h"
#include "core/values/formula.h"
#include "core/values/function_names.h"
#include "core/values/tokens.h"
#include "core/values/unit_signs.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fff {

/// Recursive descent; the first fault ends it. Each level gives the index of its node.
///
///     comparison = sum [sign sum]            sum   = term {± term}
///     term       = signed {*/ signed}        signed = {±} power
///     power      = operand ["^" signed]
///     operand    = number [unit] | "(" comparison ")" [unit] | function(…) [unit] | name | text
class FormulaParser
{
public:
    FormulaParser(std::string_view text, const Reading &reading)
    {
        m_formula.m_text = text;
        m_formula.m_reading = reading;
    }

    Understood<Formula> read()
    {
        const std::string &text = m_formula.m_text;
        if (text.size() > kLongestExpression)
            return misunderstood(expression_words::kTooLong, {0, text.size()},
                                 {static_cast<int>(kLongestExpression)});
        m_tokens = tokensOf(text);
        if (here().is(U'=') && here().place.end == here().place.begin + 1) // "==" compares
            ++m_at;
        if (here().kind == Kind::End)
            return misunderstood(expression_words::kEmpty, {0, text.size()});
        const std::optional<int> whole = comparison();
        if (whole && here().kind != Kind::End)
            failBehind();
        if (m_error)
            return tl::unexpected(*std::move(m_error));
        return std::move(m_formula);
    }

private:
    using Kind = ExpressionToken::Kind;
    using NodeKind = FormulaNode::Kind;
    /// What commas are within the parentheses that one is in.
    enum class Comma { Decimal, Either, NotSeparating };

    const ExpressionToken &here() const { return m_tokens[m_at]; }
    const ExpressionToken &after() const
    {
        return m_tokens[std::min(m_at + 1, m_tokens.size() - 1)];
    }
    std::string_view pieceOf(TextRange place) const
    {
        return std::string_view(m_formula.m_text).substr(place.begin, place.end - place.begin);
    }
    Named quote(TextRange place) const { return quoted(m_formula.m_text, place); }
    TextRange placeOf(int node) const
    {
        return m_formula.m_nodes[static_cast<std::size_t>(node)].place;
    }
    TextRange placeBefore() const { return m_at > 0 ? m_tokens[m_at - 1].place : TextRange{0, 0}; }

    std::nullopt_t fail(const Text &text, TextRange place, std::vector<Argument> arguments)
    {
        if (!m_error)
            m_error = ExpressionError{{text, std::move(arguments)}, place};
        return std::nullopt;
    }
    std::nullopt_t fail(const Text &text, TextRange place)
    {
        return fail(text, place, {quote(place)});
    }

    /// What stands behind something that is whole.
    std::nullopt_t failBehind()
    {
        const ExpressionToken &token = here();
        if (token.is(U')'))
            return fail(expression_words::kLooseParenthesis, token.place, {quote(placeBefore())});
        if (token.kind == Kind::OpenText)
            return fail(expression_words::kOpenText, token.place);
        const bool isOperand = token.kind == Kind::Digits || token.kind == Kind::Word ||
                               token.kind == Kind::Text || token.is(U'(');
        if (isOperand)
            return fail(expression_words::kNothingBetween, token.place,
                        {quote(placeBefore()), quote(token.place)});
        return fail(expression_words::kUnreadable, token.place);
    }

    std::optional<int> add(NodeKind kind, TextRange place, std::initializer_list<int> children,
                           int index = -1)
    {
        return add(kind, place, std::vector<int>(children), index);
    }
    std::optional<int> add(NodeKind kind, TextRange place, const std::vector<int> &children,
                           int index = -1)
    {
        if (m_formula.m_nodes.size() >= std::size_t(kMostExpressionNodes))
            return fail(expression_words::kTooMuch, placeBefore(),
                        {quote(placeBefore()), kMostExpressionNodes});
        FormulaNode node;
        node.kind = kind;
        node.place = place;
        node.index = index;
        node.firstChild = static_cast<int>(m_formula.m_children.size());
        node.childCount = static_cast<int>(children.size());
        m_formula.m_children.insert(m_formula.m_children.end(), children.begin(), children.end());
        m_formula.m_nodes.push_back(node);
        return static_cast<int>(m_formula.m_nodes.size()) - 1;
    }
    FormulaNode &node(int index) { return m_formula.m_nodes[static_cast<std::size_t>(index)]; }
    /// From the one's beginning to what was read last.
    TextRange from(std::size_t begin) const { return {begin, placeBefore().end}; }

    static std::optional<NodeKind> comparisonOf(const ExpressionToken &token)
    {
        if (token.kind != Kind::Sign)
            return std::nullopt;
        switch (token.sign) {
        case U'<':
            return NodeKind::Less;
        case U'\u2264':
            return NodeKind::AtMost;
        case U'>':
            return NodeKind::Greater;
        case U'\u2265':
            return NodeKind::AtLeast;
        case U'=':
            return NodeKind::Equal;
        case U'\u2260':
            return NodeKind::Unequal;
        default:
            return std::nullopt;
        }
    }

    std::optional<int> comparison()
    {
        const std::size_t begin = here().place.begin;
        const std::optional<int> left = sum();
        const std::optional<NodeKind> kind = left ? comparisonOf(here()) : std::nullopt;
        if (!kind)
            return left;
        ++m_at;
        const std::optional<int> right = sum();
        if (!right)
            return std::nullopt;
        if (comparisonOf(here()))
            return fail(expression_words::kTwoComparisons, here().place);
        return add(*kind, from(begin), {*left, *right});
    }

    std::optional<int> sum()
    {
        const std::size_t begin = here().place.begin;
        std::optional<int> left = term();
        while (left && (here().is(U'+') || here().is(U'-'))) {
            const NodeKind kind = here().is(U'+') ? NodeKind::Add : NodeKind::Subtract;
            ++m_at;
            const std::optional<int> right = term();
            left = right ? add(kind, from(begin), {*left, *right}) : std::nullopt;
        }
        return left;
    }

    std::optional<int> term()
    {
        const std::size_t begin = here().place.begin;
        std::optional<int> left = signedPower();
        while (left && (here().is(U'*') || here().is(U'/'))) {
            const NodeKind kind = here().is(U'*') ? NodeKind::Multiply : NodeKind::Divide;
            ++m_at;
            const std::optional<int> right = signedPower();
            if (!right)
                return std::nullopt;
            left = add(kind, from(begin), {*left, *right});
            if (left && kind == NodeKind::Divide)
                node(*left).isFraction = m_openUnit == *right;
        }
        return left;
    }

    std::optional<int> signedPower()
    {
        if (!here().is(U'+') && !here().is(U'-'))
            return power();
        const std::size_t begin = here().place.begin;
        const bool isNegative = here().is(U'-');
        if (!descend())
            return std::nullopt;
        ++m_at;
        const std::optional<int> of = signedPower();
        --m_depth;
        if (!of || !isNegative)
            return of;
        const bool isOpen = m_openUnit == *of;
        const std::optional<int> negated = add(NodeKind::Negate, from(begin), {*of});
        if (isOpen)
            m_openUnit = negated;
        return negated;
    }

    std::optional<int> power()
    {
        const std::size_t begin = here().place.begin;
        const std::optional<int> base = operand();
        if (!base || !here().is(U'^'))
            return base;
        if (m_openUnit == *base)
            return fail(expression_words::kRaisedUnit, {begin, here().place.end},
                        {quote({begin, after().place.end}), quote(placeOf(*base))});
        if (!descend())
            return std::nullopt;
        ++m_at;
        const std::optional<int> exponent = signedPower();
        --m_depth;
        return exponent ? add(NodeKind::Power, from(begin), {*base, *exponent}) : std::nullopt;
    }

    bool descend()
    {
        if (m_depth == kDeepestExpression) {
            fail(expression_words::kTooDeep, here().place,
                 {quote(here().place), kDeepestExpression});
            return false;
        }
        ++m_depth;
        return true;
    }

    std::optional<int> operand()
    {
        const ExpressionToken &token = here();
        switch (token.kind) {
        case Kind::Digits:
            return withUnit(number());
        case Kind::Word:
            return after().is(U'(') ? withUnit(call()) : name();
        case Kind::Text:
            ++m_at;
            m_formula.m_texts.push_back(token.text);
            return add(NodeKind::Text, token.place, {},
                       static_cast<int>(m_formula.m_texts.size()) - 1);
        case Kind::OpenText:
            return fail(expression_words::kOpenText, token.place);
        case Kind::Unknown:
            return fail(expression_words::kUnreadable, token.place);
        case Kind::End:
            return fail(expression_words::kNothingBehind, placeBefore());
        case Kind::Sign:
            break;
        }
        return token.is(U'(') ? withUnit(parenthesis()) : failAtSign();
    }

    std::nullopt_t failAtSign()
    {
        const bool isFirst = m_at == 0 || m_tokens[m_at - 1].is(U'(');
        if (isFirst || here().is(U'=') || m_tokens[m_at - 1].is(U'='))
            return fail(expression_words::kNothingBefore, here().place);
        return fail(expression_words::kNothingBehind, placeBefore());
    }

    std::optional<double> digits()
    {
        const ExpressionToken &token = here();
        const std::string_view piece = pieceOf(token.place);
        if (m_comma == Comma::Either && piece.find(',') != piece.npos)
            return fail(expression_words::kOneNumberOrTwo, token.place);
        const std::optional<double> value =
            writtenNumber(std::string(piece), m_formula.m_reading.commas);
        if (!value)
            return fail(expression_words::kUnreadable, token.place);
        ++m_at;
        return value;
    }

    /// Digits, and "1 1/2" for one and a half.
    std::optional<int> number()
    {
        const std::size_t begin = here().place.begin;
        std::optional<double> value = digits();
        if (value && here().kind == Kind::Digits && after().is(U'/') &&
            m_at + 2 < m_tokens.size() && m_tokens[m_at + 2].kind == Kind::Digits) {
            const std::optional<double> over = digits();
            ++m_at;
            const TextRange place = here().place;
            const std::optional<double> under = over ? digits() : std::nullopt;
            if (!under)
                return std::nullopt;
            if (*under == 0.0)
                return fail(expression_words::kDividedByNothing, place);
            *value += *over / *under;
        }
        const std::optional<int> added =
            value ? add(NodeKind::Number, from(begin), {}) : std::nullopt;
        if (added)
            node(*added).number = *value;
        return added;
    }

    std::optional<int> withUnit(std::optional<int> of)
    {
        if (!of)
            return of;
        m_openUnit.reset();
        const bool isWord = here().kind == Kind::Word && !after().is(U'(');
        const bool isSign = here().is(U'%') || here().is(U'\u00b0') || here().is(U'"');
        const int unit = isWord || isSign ? findUnitSign(pieceOf(here().place)) : -1;
        if (unit < 0)
            return of;
        const bool isShare = here().is(U'%'); // of a hundred, of whatever stands before it alone
        ++m_at;
        const std::optional<int> node = add(NodeKind::Unit, from(placeOf(*of).begin), {*of}, unit);
        if (!isShare)
            m_openUnit = node;
        return node;
    }

    std::optional<int> name()
    {
        const TextRange place = here().place;
        const std::string folded = foldedName(pieceOf(place));
        ++m_at;
        std::vector<std::string> &names = m_formula.m_names;
        const auto known = std::find(names.begin(), names.end(), folded);
        const auto index = static_cast<int>(known - names.begin());
        if (known == names.end())
            names.push_back(folded);
        return add(NodeKind::Name, place, {}, index);
    }

    /// The node's place has the parentheses, as a person would select it.
    std::optional<int> parenthesis()
    {
        const std::size_t begin = here().place.begin;
        if (!descend())
            return std::nullopt;
        ++m_at;
        const Comma outside = std::exchange(m_comma, Comma::Decimal);
        const std::optional<int> inside = comparison();
        m_comma = outside;
        --m_depth;
        if (!inside || !close(begin))
            return std::nullopt;
        node(*inside).place = from(begin);
        return inside;
    }

    bool close(std::size_t begin)
    {
        if (here().is(U')')) {
            ++m_at;
            return true;
        }
        if (here().kind == Kind::End)
            fail(expression_words::kOpenParenthesis, {begin, m_formula.m_text.size()});
        else
            failBehind();
        return false;
    }

    std::optional<int> call()
    {
        const TextRange word = here().place;
        const int function = findFunction(pieceOf(word));
        if (function < 0)
            return fail(findUnitSign(pieceOf(word)) < 0 ? expression_words::kNoFunction
                                                        : expression_words::kUnitAlone,
                        word);
        ++m_at;
        const std::size_t opened = here().place.begin;
        const bool hasSemicolons = semicolonsWithin(m_at);
        if (!descend())
            return std::nullopt;
        ++m_at;
        const Comma outside =
            std::exchange(m_comma, hasSemicolons ? Comma::NotSeparating : Comma::Either);
        const std::optional<std::vector<int>> given = arguments();
        m_comma = outside;
        --m_depth;
        if (!given || !close(opened) || !isCount(function, word, static_cast<int>(given->size())))
            return std::nullopt;
        return add(NodeKind::Call, from(word.begin), *given, function);
    }

    std::optional<std::vector<int>> arguments()
    {
        std::vector<int> given;
        if (here().is(U')'))
            return given;
        while (true) {
            const std::optional<int> argument = comparison();
            if (!argument)
                return std::nullopt;
            given.push_back(*argument);
            const bool isNext = here().is(U';') || (here().is(U',') && m_comma == Comma::Either);
            if (!isNext)
                return given;
            ++m_at;
        }
    }

    /// Between the parenthesis at `open` and the one that closes it, in no other.
    bool semicolonsWithin(std::size_t open) const
    {
        int depth = 0;
        for (std::size_t i = open; i < m_tokens.size(); ++i) {
            depth += m_tokens[i].is(U'(') ? 1 : m_tokens[i].is(U')') ? -1 : 0;
            if (depth == 0)
                return false;
            if (depth == 1 && m_tokens[i].is(U';'))
                return true;
        }
        return false;
    }

    bool isCount(int function, TextRange word, int count)
    {
        const FunctionName &wanted = functionNames()[static_cast<std::size_t>(function)];
        if (count >= wanted.least && count <= wanted.most)
            return true;
        const bool isExact = wanted.least == wanted.most;
        const bool isFew = count < wanted.least;
        fail(isExact ? expression_words::kNeedsExactly
             : isFew ? expression_words::kNeedsAtLeast
                     : expression_words::kNeedsAtMost,
             from(word.begin), {quote(word), isFew ? wanted.least : wanted.most, count});
        return false;
    }

    Formula m_formula;
    std::vector<ExpressionToken> m_tokens;
    std::size_t m_at = 0;
    int m_depth = 0;
    Comma m_comma = Comma::Decimal;
    std::optional<int> m_openUnit; // the node that ends with a unit, not in parentheses
    std::optional<ExpressionError> m_error;
};

Understood<Formula> Formula::read(std::string_view text, const Reading &reading)
{
    return FormulaParser(text, reading).read();
}

} // namespace fff
