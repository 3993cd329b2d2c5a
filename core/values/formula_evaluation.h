// What a formula comes to, node by node. Internal to values.
#pragma once

#include "core/values/formula.h"
#include "core/values/function_names.h"

#include <optional>
#include <string>
#include <vector>

namespace fff {

/// All nodes in order, without recursion. What does not go together ends it.
class FormulaEvaluation
{
public:
    FormulaEvaluation(const Formula &formula, const Names &names);

    Understood<Worth> worth();

private:
    using Type = Worth::Type;
    using NodeKind = FormulaNode::Kind;

    /// Of a node. What it comes to may be a fault: `if` may choose the other branch.
    struct Cell
    {
        Type type = Type::Number;
        Powers powers = {};
        bool isBare = false;
        double number = 0.0;
        const std::string *text = nullptr;
        int fault = -1; // in the list of them

        bool isPlain() const { return type == Type::Number && powers.isNone(); }
    };

    /// By which two numbers may differ and be the same.
    static double slack(double a, double b);
    static bool isLess(double a, double b) { return b - a > slack(a, b); }
    static double floorOf(double value);
    static double roundOf(double value);
    Named quote(const FormulaNode &node) const { return quoted(m_formula.text(), node.place); }
    const Cell &cell(const FormulaNode &of, int which) const;
    static Text noun(const Cell &cell) { return nounOf(Worth{cell.type, cell.powers}); }

    std::nullopt_t fail(const Text &text, const FormulaNode &node, std::vector<Argument> arguments);
    void addFault(Cell &cell, const Text &text, const FormulaNode &node);
    /// The first fault of the node's children is its own.
    bool takeFault(Cell &result, const FormulaNode &node) const;

    /// One that is bare in place of a length, an angle or a mass.
    double unitFor(const Powers &powers) const;
    static bool isOne(const Powers &powers);

    bool isNumber(const FormulaNode &node, int which);
    bool isTruth(const FormulaNode &node, int which);

    /// Children from `first` on as cells of one type, bare ones in the unit of the others.
    std::optional<std::vector<Cell>> alike(const FormulaNode &node, int first);
    std::nullopt_t unlike(const FormulaNode &node, int a, int b);

    std::optional<Cell> cellOf(const FormulaNode &node);
    std::optional<Cell> named(const FormulaNode &node);
    std::optional<Cell> inUnit(const FormulaNode &node);
    std::optional<Cell> sum(const FormulaNode &node);
    std::optional<Cell> product(const FormulaNode &node);
    std::optional<Cell> quotient(const FormulaNode &node);
    double unitOf(const FormulaNode &node) const;
    std::optional<Cell> power(const FormulaNode &node);
    /// What kind a power of a length is must not change with a value.
    std::optional<int> exponentAsTyped(const FormulaNode &node) const;
    std::optional<Cell> comparison(const FormulaNode &node);
    static bool holds(NodeKind kind, const Cell &a, const Cell &b);

    // formula_calls.cpp
    std::optional<Cell> call(const FormulaNode &node);
    std::optional<Cell> choice(const FormulaNode &node);
    /// From left to right; what comes after the answer may have none.
    std::optional<Cell> logic(Function function, const FormulaNode &node);
    std::optional<Cell> letters(const FormulaNode &node);
    std::optional<Cell> extreme(Function function, const FormulaNode &node);
    std::optional<Cell> rounded(Function function, const FormulaNode &node);
    std::optional<Cell> root(const FormulaNode &node);
    std::optional<Cell> ofAngle(Function function, const FormulaNode &node);
    std::optional<Cell> angleOf(Function function, const FormulaNode &node);

    const Formula &m_formula;
    std::vector<const Worth *> m_named;
    std::vector<Cell> m_cells;
    std::vector<ExpressionError> m_faults;
    std::optional<ExpressionError> m_error;
};

} // namespace fff
