#include "core/base/expression.h"

#include "core/base/letters.h"
#include "core/base/utf8.h"
#include "core/base/written_number.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fff {

namespace {

using Fault = Expression::Fault;

/// Parentheses and signs within each other, far more than anybody types: a file may have more.
constexpr int kMostNested = 200;

char32_t lower(char32_t c)
{
    return c >= U'A' && c <= U'Z' ? c - U'A' + U'a' : c;
}

/// Capitals or not, of ASCII.
bool isSame(char32_t a, char32_t b)
{
    return lower(a) == lower(b);
}

std::u32string_view trimmed(std::u32string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

struct Unit
{
    std::u32string sign;
    double size = 1.0; // mm or kg; of a plain number's sign, no matter
    int power = 0;     // 1: of a length or a mass
};

// Longer signs first: "mm" and "m" begin alike.
std::vector<Unit> lengthUnits()
{
    constexpr double kInch = 25.4;
    return {{U"mm", 1.0, 1},        {U"cm", 10.0, 1},  {U"inch", kInch, 1}, {U"in", kInch, 1},
            {U"ft", 12 * kInch, 1}, {U"m", 1000.0, 1}, {U"\"", kInch, 1}};
}

std::vector<Unit> massUnits()
{
    return {{U"kg", 1.0, 1}, {U"g", 1e-3, 1}, {U"oz", 0.028349523125, 1}, {U"lb", 0.45359237, 1}};
}

/// A plain number (power 0), a length in mm or a mass in kg (1); anything else is no answer.
struct Quantity
{
    double value = 0.0;
    int power = 0;
    double unit = 0.0; // mm or kg, of the number it ends with; 0: that had none
};

struct Grammar
{
    std::vector<Unit> units;
    enum class Wanted { Number, Length, Mass, Any };
    Wanted wanted = Wanted::Number;
    double ownUnit = 1.0; // mm or kg, of numbers without one, where lengths or masses are meant
    Commas commas = Commas::Decimals;
    std::optional<double> t;
    NumberNames names;

    bool hasLengths() const { return wanted == Wanted::Length || wanted == Wanted::Any; }
    Fault notWanted() const { return wanted == Wanted::Mass ? Fault::NotAMass : Fault::NotALength; }
};

/// Recursive descent over: sum = term {± term}, term = factor {×÷ factor}, factor = [±] (number |
/// t | name | "(" sum ")") [unit]. The first fault ends it.
class Parser
{
public:
    Parser(std::string_view text, const Grammar &grammar)
        : m_text(decoded(text)), m_grammar(grammar)
    {
    }

    Expression read()
    {
        if (trimmed(m_text).empty())
            return {{}, Fault::Empty};
        std::optional<Quantity> all = sum();
        skip();
        if (all && m_at != m_text.size()) {
            const bool isLoose = m_text[m_at] == U')';
            all = fail(isLoose ? Fault::LooseParenthesis : Fault::Unreadable, pieceHere());
        }
        if (all && (m_grammar.wanted == Grammar::Wanted::Length ||
                    m_grammar.wanted == Grammar::Wanted::Mass))
            all = inUnits(*all);
        if (all && (all->power < 0 || all->power > 1 ||
                    (all->power == 1 && m_grammar.wanted == Grammar::Wanted::Number)))
            all = fail(m_grammar.notWanted());
        if (!all)
            return m_failed;
        if (!std::isfinite(all->value))
            return {{}, Fault::Unreadable, encoded(trimmed(m_text))};
        return {all->value, Fault::None, {}, all->power == 1 && m_grammar.hasLengths()};
    }

private:
    std::nullopt_t fail(Fault fault, std::u32string_view piece = {})
    {
        if (m_failed.fault == Fault::None)
            m_failed = {{}, fault, encoded(piece)};
        return std::nullopt;
    }
    void skip()
    {
        while (m_at < m_text.size() && isBlank(m_text[m_at]))
            ++m_at;
    }
    bool take(std::u32string_view of)
    {
        skip();
        if (m_at == m_text.size() || of.find(m_text[m_at]) == of.npos)
            return false;
        ++m_at;
        return true;
    }
    /// The word or sign that stands here.
    std::u32string_view pieceHere() const
    {
        return std::u32string_view(m_text).substr(m_at, std::max<std::size_t>(1, wordLength()));
    }
    std::size_t wordLength() const
    {
        std::size_t end = m_at;
        while (end < m_text.size() && (isNameLetter(m_text[end]) || isDigit(m_text[end])))
            ++end;
        return end - m_at;
    }
    std::optional<Quantity> inUnits(Quantity q)
    {
        if (q.power == 0)
            return Quantity{q.value * m_grammar.ownUnit, 1, m_grammar.ownUnit};
        return q.power == 1 ? std::optional(q) : fail(m_grammar.notWanted());
    }

    std::optional<Quantity> sum()
    {
        std::optional<Quantity> left = term();
        while (left) {
            const bool plus = take(U"+");
            if (!plus && !take(U"-\u2212"))
                break;
            const std::optional<Quantity> right = term();
            if (!right)
                return std::nullopt;
            // Two numbers stay one; beside a length a number is one too.
            const bool isPlain = left->power == 0 && right->power == 0;
            const std::optional<Quantity> a = isPlain ? left : inUnits(*left),
                                          b = isPlain ? right : inUnits(*right);
            if (!a || !b)
                return std::nullopt;
            left = Quantity{plus ? a->value + b->value : a->value - b->value, a->power, 0.0};
        }
        return left;
    }

    std::optional<Quantity> term()
    {
        std::optional<Quantity> left = factor();
        while (left) {
            const bool times = take(U"*\u00d7\u00b7");
            if (!times && !take(U"/:\u00f7"))
                break;
            const std::optional<Quantity> right = factor();
            if (!right)
                return std::nullopt;
            if (!times && right->value == 0.0)
                return fail(Fault::DivisionByZero);
            if (times)
                left = Quantity{left->value * right->value, left->power + right->power, 0.0};
            else if (left->power == 0 && right->unit > 0.0)
                // "1/2 in": the unit is that of the fraction.
                left = Quantity{left->value / (right->value / right->unit) * right->unit, 1, 0.0};
            else
                left = Quantity{left->value / right->value, left->power - right->power, 0.0};
        }
        return left;
    }

    std::optional<Quantity> factor()
    {
        skip();
        if (m_nested == kMostNested)
            return fail(Fault::Unreadable, pieceHere());
        ++m_nested;
        const std::optional<Quantity> q = nestedFactor();
        --m_nested;
        return q;
    }

    std::optional<Quantity> nestedFactor()
    {
        if (take(U"-\u2212")) {
            std::optional<Quantity> q = factor();
            if (q)
                q->value = -q->value;
            return q;
        }
        if (take(U"+"))
            return factor();
        std::optional<Quantity> q;
        if (take(U"(")) {
            q = sum();
            if (!q)
                return std::nullopt;
            if (!take(U")"))
                return m_at == m_text.size() ? fail(Fault::OpenParenthesis)
                                             : fail(Fault::Unreadable, pieceHere());
            q->unit = 0.0;
        } else if (m_grammar.hasLengths() && takeThickness()) {
            return m_grammar.t ? std::optional(Quantity{*m_grammar.t, 1, 0.0})
                               : fail(Fault::NoThickness);
        } else if (const std::u32string_view name = takeName(); !name.empty()) {
            const std::optional<NamedValue> named = m_grammar.names(encoded(name));
            if (named && named->isLength && m_grammar.wanted == Grammar::Wanted::Mass)
                return fail(m_grammar.notWanted());
            return named ? std::optional(Quantity{named->value, named->isLength ? 1 : 0, 0.0})
                         : fail(Fault::UnknownName, name);
        } else {
            q = number();
        }
        return q ? withUnit(*q) : q;
    }

    /// "t" alone: "tt" is no product.
    bool takeThickness()
    {
        skip();
        if (wordLength() != 1 || !isSame(m_text[m_at], U't'))
            return false;
        ++m_at;
        return true;
    }

    /// A word, where there are names; empty: none begins here.
    std::u32string_view takeName()
    {
        skip();
        if (!m_grammar.names || m_at == m_text.size() || !isNameLetter(m_text[m_at]))
            return {};
        const std::u32string_view name = pieceHere();
        m_at += name.size();
        return name;
    }

    std::optional<Quantity> withUnit(Quantity q)
    {
        skip();
        const std::u32string_view rest = std::u32string_view(m_text).substr(m_at);
        for (const Unit &unit : m_grammar.units) {
            if (unit.sign.empty() || rest.size() < unit.sign.size() ||
                !std::equal(unit.sign.begin(), unit.sign.end(), rest.begin(), isSame))
                continue;
            if (q.power != 0)
                return fail(m_grammar.notWanted());
            m_at += unit.sign.size();
            return Quantity{q.value * unit.size, unit.power, unit.power == 0 ? 0.0 : unit.size};
        }
        return q;
    }

    /// Digits, and "1 1/2" for one and a half.
    std::optional<Quantity> number()
    {
        const std::optional<double> whole = digits();
        if (!whole) {
            skip();
            return m_at == m_text.size() ? fail(Fault::Unfinished, trimmed(m_text))
                                         : fail(Fault::Unreadable, pieceHere());
        }
        const std::size_t after = m_at;
        skip();
        if (m_at > after) {
            const std::optional<double> over = digits();
            if (over && take(U"/")) {
                skip();
                const std::optional<double> under = digits();
                if (under && *under != 0.0)
                    return Quantity{*whole + *over / *under, 0, 0.0};
            }
        }
        m_at = after;
        return Quantity{*whole, 0, 0.0};
    }

    std::optional<double> digits()
    {
        skip();
        const std::size_t from = m_at;
        std::string word;
        while (m_at < m_text.size() &&
               (isDigit(m_text[m_at]) || m_text[m_at] == U'.' || m_text[m_at] == U','))
            word += static_cast<char>(m_text[m_at++]);
        if (const std::optional<double> value = writtenNumber(word, m_grammar.commas))
            return value;
        m_at = from;
        return std::nullopt;
    }

    const std::u32string m_text;
    const Grammar &m_grammar;
    std::size_t m_at = 0;
    int m_nested = 0;
    Expression m_failed;
};

} // namespace

Expression readLength(std::string_view text, double unit, Commas commas, std::optional<double> t,
                      const NumberNames &names)
{
    return Parser(text, {lengthUnits(), Grammar::Wanted::Length, unit, commas, t, names}).read();
}

Expression readMass(std::string_view text, double unit, Commas commas, const NumberNames &names)
{
    return Parser(text, {massUnits(), Grammar::Wanted::Mass, unit, commas, {}, names}).read();
}

Expression readNumber(std::string_view text, std::string_view sign, Commas commas,
                      const NumberNames &names)
{
    return Parser(text, {{{decoded(sign)}}, Grammar::Wanted::Number, 1.0, commas, {}, names})
        .read();
}

Expression readAny(std::string_view text, Commas commas, const NumberNames &names)
{
    return Parser(text, {lengthUnits(), Grammar::Wanted::Any, 1.0, commas, {}, names}).read();
}

} // namespace fff
