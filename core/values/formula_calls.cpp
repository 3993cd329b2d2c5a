// The functions that formulas call.
#include "core/values/expression_words.h"
#include "core/values/formula_evaluation.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace fff {

namespace {

constexpr double kInfinite = 1e12; // a tangent that is larger is that of 90°, rounded

/// In letters. Of UTF-8, what is no byte inside a letter begins one.
double longestLine(std::string_view text)
{
    int longest = 0, now = 0;
    for (const char c : text) {
        now = c == '\n' ? 0 : now + ((static_cast<unsigned char>(c) & 0xC0) == 0x80 ? 0 : 1);
        longest = std::max(longest, now);
    }
    return longest;
}

} // namespace

double FormulaEvaluation::floorOf(double value)
{
    return std::floor(value + slack(value, value));
}

double FormulaEvaluation::roundOf(double value)
{
    return std::copysign(floorOf(std::abs(value) + 0.5), value);
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::call(const FormulaNode &node)
{
    const Function function = functionNames()[static_cast<std::size_t>(node.index)].function;
    switch (function) {
    case Function::If:
        return choice(node);
    case Function::And:
    case Function::Or:
    case Function::Not:
        return logic(function, node);
    case Function::Len:
        return letters(node);
    default:
        break;
    }
    for (int i = 0; i < node.childCount; ++i)
        if (!isNumber(node, i))
            return std::nullopt;
    switch (function) {
    case Function::Min:
    case Function::Max:
        return extreme(function, node);
    case Function::Round:
    case Function::Floor:
    case Function::Ceil:
        return rounded(function, node);
    case Function::Sqrt:
        return root(node);
    case Function::Abs: {
        Cell result = cell(node, 0);
        result.number = std::abs(result.number);
        return result;
    }
    case Function::Sin:
    case Function::Cos:
    case Function::Tan:
        return ofAngle(function, node);
    default:
        return angleOf(function, node);
    }
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::choice(const FormulaNode &node)
{
    if (!isTruth(node, 0))
        return std::nullopt;
    const std::optional<std::vector<Cell>> both = alike(node, 1);
    if (!both)
        return std::nullopt;
    const Cell &condition = cell(node, 0);
    Cell result = condition.number != 0.0 ? both->front() : both->back();
    if (condition.fault >= 0)
        result.fault = condition.fault;
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::logic(Function function,
                                                                const FormulaNode &node)
{
    for (int i = 0; i < node.childCount; ++i)
        if (!isTruth(node, i))
            return std::nullopt;
    Cell result = cell(node, 0);
    if (function == Function::Not) {
        result.number = 1.0 - result.number;
        return result;
    }
    const double decisive = function == Function::Or ? 1.0 : 0.0;
    for (int i = 1; i < node.childCount; ++i)
        if (result.fault < 0 && result.number != decisive)
            result = cell(node, i);
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::letters(const FormulaNode &node)
{
    const Cell &of = cell(node, 0);
    if (of.type != Type::Text) {
        const FormulaNode &child = m_formula.child(node, 0);
        return fail(expression_words::kNeeds, child,
                    {quote(child), noun(of), nounOf(ValueKind::Text)});
    }
    Cell result{Type::Number, {}, false, longestLine(*of.text)};
    result.fault = of.fault;
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::extreme(Function function,
                                                                  const FormulaNode &node)
{
    const std::optional<std::vector<Cell>> all = alike(node, 0);
    if (!all)
        return std::nullopt;
    Cell result = all->front();
    for (const Cell &other : *all)
        result.number = function == Function::Min ? std::min(result.number, other.number)
                                                  : std::max(result.number, other.number);
    takeFault(result, node);
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::rounded(Function function,
                                                                  const FormulaNode &node)
{
    Cell result = cell(node, 0);
    double step = 1.0;
    if (node.childCount == 2) {
        const std::optional<std::vector<Cell>> both = alike(node, 0);
        if (!both)
            return std::nullopt;
        result = both->front();
        step = both->back().number;
    } else if (isOne(result.powers)) {
        step = unitFor(result.powers);
    }
    if (!takeFault(result, node) && !(step > 0.0))
        addFault(result, expression_words::kNoStep, m_formula.child(node, node.childCount - 1));
    if (result.fault >= 0)
        return result;
    const double steps = result.number / step;
    result.number = step * (function == Function::Round   ? roundOf(steps)
                            : function == Function::Floor ? floorOf(steps)
                                                          : -floorOf(-steps));
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::root(const FormulaNode &node)
{
    Cell result = cell(node, 0);
    const FormulaNode &of = m_formula.child(node, 0);
    const Powers &p = result.powers;
    if (p.length % 2 != 0 || p.mass % 2 != 0 || p.angle % 2 != 0)
        return fail(expression_words::kNoRoot, of, {quote(of), noun(result)});
    result.powers = {p.length / 2, p.mass / 2, p.angle / 2};
    if (result.fault < 0 && result.number < 0.0)
        addFault(result, expression_words::kRootOfNegative, of);
    result.number = result.fault < 0 ? std::sqrt(result.number) : 0.0;
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::ofAngle(Function function,
                                                                  const FormulaNode &node)
{
    Cell result = cell(node, 0);
    const FormulaNode &of = m_formula.child(node, 0);
    if (!result.powers.isNone() && result.powers != kAnglePowers)
        return fail(expression_words::kNeeds, of,
                    {quote(of), noun(result), nounOf(ValueKind::Angle)});
    const double angle =
        result.powers.isNone() ? result.number * m_formula.reading().angleUnit : result.number;
    result.powers = {};
    result.isBare = false;
    result.number = function == Function::Sin   ? std::sin(angle)
                    : function == Function::Cos ? std::cos(angle)
                                                : std::tan(angle);
    if (result.fault < 0 && std::abs(result.number) > kInfinite)
        addFault(result, expression_words::kNoTangent, of);
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::angleOf(Function function,
                                                                  const FormulaNode &node)
{
    Cell result = cell(node, 0);
    const FormulaNode &of = m_formula.child(node, 0);
    if (!result.powers.isNone())
        return fail(expression_words::kNeeds, of,
                    {quote(of), noun(result), nounOf(ValueKind::Number)});
    result.powers = kAnglePowers;
    result.isBare = false;
    if (function == Function::Atan) {
        result.number = std::atan(result.number);
        return result;
    }
    if (result.fault < 0 && isLess(1.0, std::abs(result.number)))
        addFault(result, expression_words::kBeyondOne, of);
    const double share = std::clamp(result.number, -1.0, 1.0);
    result.number = function == Function::Asin ? std::asin(share) : std::acos(share);
    return result;
}

} // namespace fff
