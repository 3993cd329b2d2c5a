#include "core/values/expression_words.h"
#include "core/values/formula_evaluation.h"
#include "core/values/unit_signs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fff {

namespace {

namespace words = expression_words;

constexpr int kHighestPower = 9; // of a length, an angle or a mass, and exponents of these

Powers sumOf(const Powers &a, const Powers &b, int sign)
{
    return {a.length + sign * b.length, a.mass + sign * b.mass, a.angle + sign * b.angle};
}

bool isTooHigh(const Powers &p)
{
    return std::max({std::abs(p.length), std::abs(p.mass), std::abs(p.angle)}) > kHighestPower;
}

} // namespace

double FormulaEvaluation::slack(double a, double b)
{
    return kSameNumber * std::max({1.0, std::abs(a), std::abs(b)});
}

FormulaEvaluation::FormulaEvaluation(const Formula &formula, const Names &names)
    : m_formula(formula)
{
    m_named.reserve(formula.names().size());
    for (const std::string &name : formula.names())
        m_named.push_back(names ? names(name) : nullptr);
}

Understood<Worth> FormulaEvaluation::worth()
{
    m_cells.reserve(m_formula.nodes().size());
    for (const FormulaNode &node : m_formula.nodes()) {
        std::optional<Cell> cell = cellOf(node);
        if (!cell)
            return tl::unexpected(*std::move(m_error));
        if (cell->fault < 0 && cell->type == Type::Number && !std::isfinite(cell->number))
            addFault(*cell, words::kTooLarge, node);
        m_cells.push_back(*cell);
    }
    const Cell &whole = m_cells.back();
    if (whole.fault >= 0)
        return tl::unexpected(m_faults[static_cast<std::size_t>(whole.fault)]);
    return Worth{whole.type, whole.powers, whole.isBare, whole.number,
                 whole.text ? *whole.text : std::string()};
}

const FormulaEvaluation::Cell &FormulaEvaluation::cell(const FormulaNode &of, int which) const
{
    return m_cells[static_cast<std::size_t>(m_formula.childIndex(of, which))];
}

std::nullopt_t FormulaEvaluation::fail(const Text &text, const FormulaNode &node,
                                       std::vector<Argument> arguments)
{
    m_error = ExpressionError{{text, std::move(arguments)}, node.place};
    return std::nullopt;
}

void FormulaEvaluation::addFault(Cell &cell, const Text &text, const FormulaNode &node)
{
    cell.fault = static_cast<int>(m_faults.size());
    m_faults.push_back({{text, {quote(node)}}, node.place});
}

bool FormulaEvaluation::takeFault(Cell &result, const FormulaNode &node) const
{
    for (int i = 0; i < node.childCount && result.fault < 0; ++i)
        result.fault = cell(node, i).fault;
    return result.fault >= 0;
}

double FormulaEvaluation::unitFor(const Powers &powers) const
{
    const Reading &reading = m_formula.reading();
    return powers == kLengthPowers  ? reading.lengthUnit
           : powers == kAnglePowers ? reading.angleUnit
                                    : reading.massUnit;
}

bool FormulaEvaluation::isOne(const Powers &powers)
{
    return powers == kLengthPowers || powers == kAnglePowers || powers == kMassPowers;
}

bool FormulaEvaluation::isNumber(const FormulaNode &node, int which)
{
    if (cell(node, which).type == Type::Number)
        return true;
    const FormulaNode &child = m_formula.child(node, which);
    fail(words::kNotANumber, child, {quote(child), noun(cell(node, which))});
    return false;
}

bool FormulaEvaluation::isTruth(const FormulaNode &node, int which)
{
    if (cell(node, which).type == Type::Truth)
        return true;
    const FormulaNode &child = m_formula.child(node, which);
    fail(words::kNeeds, child, {quote(child), noun(cell(node, which)), nounOf(ValueKind::Switch)});
    return false;
}

std::optional<std::vector<FormulaEvaluation::Cell>>
FormulaEvaluation::alike(const FormulaNode &node, int first)
{
    std::vector<Cell> cells;
    for (int i = first; i < node.childCount; ++i)
        cells.push_back(cell(node, i));
    // Whose kind counts: the first that is no bare number.
    std::size_t leader = 0;
    while (leader + 1 < cells.size() && cells[leader].isPlain() && cells[leader].isBare)
        ++leader;
    const Cell lead = cells[leader];
    bool isBare = true;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        isBare = isBare && cells[i].isBare;
        if (cells[i].type == lead.type && cells[i].powers == lead.powers)
            continue;
        if (!cells[i].isPlain() || !cells[i].isBare || lead.type != Type::Number ||
            !isOne(lead.powers))
            return unlike(node, first + static_cast<int>(std::min(i, leader)),
                          first + static_cast<int>(std::max(i, leader)));
        cells[i].powers = lead.powers;
        cells[i].number *= unitFor(lead.powers);
    }
    for (Cell &c : cells)
        c.isBare = isBare;
    return cells;
}

std::nullopt_t FormulaEvaluation::unlike(const FormulaNode &node, int a, int b)
{
    const FormulaNode &left = m_formula.child(node, a), &right = m_formula.child(node, b);
    FormulaNode both;
    both.place = {left.place.begin, right.place.end};
    return fail(words::kUnlike, both,
                {quote(left), noun(cell(node, a)), quote(right), noun(cell(node, b))});
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::cellOf(const FormulaNode &node)
{
    switch (node.kind) {
    case NodeKind::Number:
        return Cell{Type::Number, {}, true, node.number};
    case NodeKind::Name:
        return named(node);
    case NodeKind::Text: {
        Cell text{Type::Text};
        text.text = &m_formula.texts()[static_cast<std::size_t>(node.index)];
        return text;
    }
    case NodeKind::Unit:
        return inUnit(node);
    case NodeKind::Negate: {
        if (!isNumber(node, 0))
            return std::nullopt;
        Cell result = cell(node, 0);
        result.number = -result.number;
        return result;
    }
    case NodeKind::Add:
    case NodeKind::Subtract:
        return sum(node);
    case NodeKind::Multiply:
        return product(node);
    case NodeKind::Divide:
        return quotient(node);
    case NodeKind::Power:
        return power(node);
    case NodeKind::Call:
        return call(node);
    default:
        return comparison(node);
    }
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::named(const FormulaNode &node)
{
    const auto index = static_cast<std::size_t>(node.index);
    const std::string &name = m_formula.names()[index];
    const Worth *worth = m_named[index];
    if (worth)
        return Cell{worth->type, worth->powers, worth->isBare, worth->number, &worth->text};
    if (name == "pi" || name == "π")
        return Cell{Type::Number, {}, false, std::numbers::pi};
    if (findUnitSign(name) >= 0)
        return fail(words::kUnitAlone, node, {quote(node)});
    return fail(name == "t" ? words::kNoThickness : words::kUnknownName, node, {quote(node)});
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::inUnit(const FormulaNode &node)
{
    if (!isNumber(node, 0))
        return std::nullopt;
    Cell result = cell(node, 0);
    if (!result.powers.isNone())
        return fail(words::kHasUnit, node, {quote(m_formula.child(node, 0)), noun(result)});
    const UnitSign &unit = unitSigns()[static_cast<std::size_t>(node.index)];
    result.number *= unit.size;
    result.powers = unit.powers;
    result.isBare = false;
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::sum(const FormulaNode &node)
{
    if (!isNumber(node, 0) || !isNumber(node, 1))
        return std::nullopt;
    const std::optional<std::vector<Cell>> both = alike(node, 0);
    if (!both)
        return std::nullopt;
    Cell result = both->front();
    const double right = both->back().number;
    result.number += node.kind == NodeKind::Add ? right : -right;
    takeFault(result, node);
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::product(const FormulaNode &node)
{
    if (!isNumber(node, 0) || !isNumber(node, 1))
        return std::nullopt;
    const Cell &left = cell(node, 0), &right = cell(node, 1);
    Cell result{Type::Number, sumOf(left.powers, right.powers, 1), left.isBare || right.isBare,
                left.number * right.number};
    if (isTooHigh(result.powers))
        return fail(words::kTooManyPowers, node, {quote(node)});
    result.isBare = result.isBare && result.powers.isNone();
    takeFault(result, node);
    return result;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::quotient(const FormulaNode &node)
{
    if (!isNumber(node, 0) || !isNumber(node, 1))
        return std::nullopt;
    const Cell &left = cell(node, 0), &right = cell(node, 1);
    Cell result{Type::Number, sumOf(left.powers, right.powers, -1), left.isBare || right.isBare,
                left.number / right.number};
    if (node.isFraction && left.powers.isNone()) {
        // "1/2 in": the unit is that of the fraction.
        const double unit = unitOf(m_formula.child(node, 1));
        result = {Type::Number, right.powers, false, left.number / (right.number / unit) * unit};
    }
    if (isTooHigh(result.powers))
        return fail(words::kTooManyPowers, node, {quote(node)});
    result.isBare = result.isBare && result.powers.isNone();
    if (!takeFault(result, node) && right.number == 0.0)
        addFault(result, words::kDividedByNothing, m_formula.child(node, 1));
    return result;
}

double FormulaEvaluation::unitOf(const FormulaNode &node) const
{
    const FormulaNode *at = &node;
    while (at->kind == NodeKind::Negate)
        at = &m_formula.child(*at, 0);
    return unitSigns()[static_cast<std::size_t>(at->index)].size;
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::power(const FormulaNode &node)
{
    if (!isNumber(node, 0) || !isNumber(node, 1))
        return std::nullopt;
    const Cell &base = cell(node, 0), &exponent = cell(node, 1);
    const FormulaNode &raised = m_formula.child(node, 0), &by = m_formula.child(node, 1);
    if (!exponent.powers.isNone())
        return fail(words::kNeeds, by, {quote(by), noun(exponent), nounOf(ValueKind::Number)});
    Cell result{Type::Number, {}, base.isBare, std::pow(base.number, exponent.number)};
    if (!base.powers.isNone()) {
        const std::optional<int> times = exponentAsTyped(by);
        if (!times)
            return fail(words::kNoExponent, node, {quote(raised), noun(base), quote(by)});
        result.powers = {base.powers.length * *times, base.powers.mass * *times,
                         base.powers.angle * *times};
        if (isTooHigh(result.powers))
            return fail(words::kTooManyPowers, node, {quote(node)});
    }
    if (!takeFault(result, node) && !std::isfinite(result.number)) {
        const bool isNone =
            std::isnan(result.number) || (base.number == 0.0 && exponent.number < 0.0);
        addFault(result, isNone ? words::kNoPower : words::kTooLarge, node);
    }
    return result;
}

std::optional<int> FormulaEvaluation::exponentAsTyped(const FormulaNode &node) const
{
    const bool isNegative = node.kind == NodeKind::Negate;
    const FormulaNode &number = isNegative ? m_formula.child(node, 0) : node;
    if (number.kind != NodeKind::Number || number.number > kHighestPower ||
        number.number != std::floor(number.number))
        return std::nullopt;
    return static_cast<int>(isNegative ? -number.number : number.number);
}

std::optional<FormulaEvaluation::Cell> FormulaEvaluation::comparison(const FormulaNode &node)
{
    const bool isEquality = node.kind == NodeKind::Equal || node.kind == NodeKind::Unequal;
    if (!isEquality && (!isNumber(node, 0) || !isNumber(node, 1)))
        return std::nullopt;
    const std::optional<std::vector<Cell>> both = alike(node, 0);
    if (!both)
        return std::nullopt;
    Cell result{Type::Truth};
    result.number = holds(node.kind, both->front(), both->back()) ? 1.0 : 0.0;
    takeFault(result, node);
    return result;
}

bool FormulaEvaluation::holds(NodeKind kind, const Cell &a, const Cell &b)
{
    if (a.type == Type::Text)
        return (*a.text == *b.text) == (kind == NodeKind::Equal);
    const bool less = isLess(a.number, b.number), greater = isLess(b.number, a.number);
    switch (kind) {
    case NodeKind::Less:
        return less;
    case NodeKind::AtMost:
        return !greater;
    case NodeKind::Greater:
        return greater;
    case NodeKind::AtLeast:
        return !less;
    case NodeKind::Equal:
        return !less && !greater;
    default:
        return less || greater;
    }
}

Understood<Worth> Formula::worth(const Names &names) const
{
    return FormulaEvaluation(*this, names).worth();
}

} // namespace fff
