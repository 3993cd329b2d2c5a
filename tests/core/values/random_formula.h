// Made-up expressions, and what they come to by another way: straight from the tree that made them,
// without units in the text's own sense, tokens or nodes.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace fff::test {

/// Powers of a length; that is all that is made up here. NaN: it has no value.
struct MadeWorth
{
    double number = 0.0; // mm to that power
    int power = 0;
};

/// Named lengths and plain numbers.
using MadeNames = std::map<std::string, MadeWorth>;

/// A text and its worth, made together. Lengths always have units, so that nothing hangs on what a
/// bare number stands for.
class RandomFormula
{
public:
    RandomFormula(unsigned seed, MadeNames names) : m_random(seed), m_names(std::move(names)) {}

    struct Made
    {
        std::string text; // an operand: a number, a name, a call, or in parentheses
        MadeWorth worth;
    };

    Made make(int depth, int power)
    {
        const int kind = depth == 0 ? upTo(2) : upTo(13);
        if (kind <= 2)
            return leaf(power);
        switch (kind) {
        case 3:
        case 4: {
            const Made a = make(depth - 1, power), b = make(depth - 1, power);
            const bool plus = kind == 3;
            return inParentheses(
                a.text + blank() + (plus ? "+" : minus()) + blank() + b.text,
                plus ? a.worth.number + b.worth.number : a.worth.number - b.worth.number, power);
        }
        case 5:
        case 6: {
            const Made a = make(depth - 1, power), b = make(depth - 1, 0);
            return inParentheses(a.text + (upTo(1) ? "*" : " · ") + b.text,
                                 a.worth.number * b.worth.number, power);
        }
        case 7:
        case 8: {
            const Made a = make(depth - 1, power), b = make(depth - 1, kind == 7 ? 0 : 1);
            if (kind == 8)
                return quotient(make(depth - 1, power + 1), b, power);
            return quotient(a, b, power);
        }
        case 9: {
            const Made a = make(depth - 1, power);
            return inParentheses(minus() + a.text, -a.worth.number, power);
        }
        case 10: {
            const Made a = make(depth - 1, power), b = make(depth - 1, power);
            const bool least = upTo(1) == 0;
            return {(least ? "min(" : "MAX(") + a.text + "; " + b.text + ")",
                    {nanOr(a, b,
                           least ? std::min(a.worth.number, b.worth.number)
                                 : std::max(a.worth.number, b.worth.number)),
                     power}};
        }
        case 11: {
            const Made a = make(depth - 1, power);
            return {"abs(" + a.text + ")", {std::abs(a.worth.number), power}};
        }
        case 12: {
            const Made a = make(depth - 1, 0), b = make(depth - 1, 0);
            const Made yes = make(depth - 1, power), no = make(depth - 1, power);
            const double difference = a.worth.number - b.worth.number;
            const double chosen = std::isnan(difference) ? difference
                                  : difference < 0.0     ? yes.worth.number
                                                         : no.worth.number;
            return {"if(" + a.text + " < " + b.text + "; " + yes.text + "; " + no.text + ")",
                    {chosen, power}};
        }
        default: {
            const Made a = make(depth - 1, power);
            return {"sqrt(" + a.text + "*" + a.text + ")", {std::abs(a.worth.number), power}};
        }
        }
    }

private:
    int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(m_random); }
    std::string blank() { return std::string(static_cast<std::size_t>(upTo(2)), ' '); }
    std::string minus() { return upTo(1) ? "-" : "−"; }
    static double nanOr(const Made &a, const Made &b, double value)
    {
        const double sum = a.worth.number + b.worth.number;
        return std::isnan(sum) ? sum : value;
    }
    Made inParentheses(const std::string &text, double number, int power)
    {
        return {"(" + text + ")", {number, power}};
    }
    Made quotient(const Made &a, const Made &b, int power)
    {
        const double number =
            b.worth.number == 0.0 ? std::nan("") : a.worth.number / b.worth.number;
        return inParentheses(a.text + "/" + "(" + b.text + ")", number, power);
    }

    Made leaf(int power)
    {
        if (power == 0 || power == 1) {
            std::vector<std::pair<std::string, MadeWorth>> fitting;
            for (const auto &[name, worth] : m_names)
                if (worth.power == power)
                    fitting.emplace_back(name, worth);
            if (!fitting.empty() && upTo(1)) {
                const auto &[name, worth] =
                    fitting[static_cast<std::size_t>(upTo(static_cast<int>(fitting.size()) - 1))];
                return {name, worth};
            }
        }
        const int whole = upTo(40), tenths = upTo(9);
        const std::string digits = std::to_string(whole) + "." + std::to_string(tenths);
        const double number = whole + 0.1 * tenths;
        if (power == 0)
            return {digits, {number, 0}};
        if (power == 1) {
            static const std::vector<std::pair<std::string, double>> units{
                {" mm", 1.0}, {"cm", 10.0}, {" in", 25.4}, {"\"", 25.4}, {" ft", 304.8}};
            const auto &[sign, size] =
                units[static_cast<std::size_t>(upTo(static_cast<int>(units.size()) - 1))];
            return {"(" + digits + sign + ")", {number * size, 1}};
        }
        const Made one = leaf(1), rest = leaf(power - 1);
        return inParentheses(one.text + "*" + rest.text, one.worth.number * rest.worth.number,
                             power);
    }

    std::mt19937 m_random;
    MadeNames m_names;
};

} // namespace fff::test
