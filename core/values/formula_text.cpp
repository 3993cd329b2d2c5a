#include "core/values/formula.h"
#include "core/values/function_names.h"
#include "core/values/number_text.h"
#include "core/values/unit_signs.h"

#include <utility>

namespace fff {

namespace {

using NodeKind = FormulaNode::Kind;

/// What binds tighter is larger; as in FormulaParser.
enum Binding { kComparison, kSum, kTerm, kSigned, kPower, kUnit, kOperand };

Binding bindingOf(NodeKind kind)
{
    switch (kind) {
    case NodeKind::Number:
    case NodeKind::Name:
    case NodeKind::Text:
    case NodeKind::Call:
        return kOperand;
    case NodeKind::Unit:
        return kUnit;
    case NodeKind::Power:
        return kPower;
    case NodeKind::Negate:
        return kSigned;
    case NodeKind::Multiply:
    case NodeKind::Divide:
        return kTerm;
    case NodeKind::Add:
    case NodeKind::Subtract:
        return kSum;
    default:
        return kComparison;
    }
}

const char *signOf(NodeKind kind)
{
    switch (kind) {
    case NodeKind::Add:
        return " + ";
    case NodeKind::Subtract:
        return " - ";
    case NodeKind::Multiply:
        return "*";
    case NodeKind::Divide:
        return "/";
    case NodeKind::Power:
        return "^";
    case NodeKind::Less:
        return " < ";
    case NodeKind::AtMost:
        return " <= ";
    case NodeKind::Greater:
        return " > ";
    case NodeKind::AtLeast:
        return " >= ";
    case NodeKind::Equal:
        return " = ";
    default:
        return " != ";
    }
}

std::string inQuotes(const std::string &text)
{
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

/// Node after node, each from the texts of its children.
class FormulaWriter
{
public:
    explicit FormulaWriter(const Formula &formula) : m_formula(formula) {}

    std::string all()
    {
        for (const FormulaNode &node : m_formula.nodes())
            m_texts.push_back(textOf(node));
        return std::move(m_texts.back());
    }

private:
    /// In parentheses if it binds less than that.
    std::string take(const FormulaNode &of, int which, int least)
    {
        std::string text =
            std::move(m_texts[static_cast<std::size_t>(m_formula.childIndex(of, which))]);
        if (bindingOf(m_formula.child(of, which).kind) >= least)
            return text;
        return '(' + std::move(text) + ')';
    }
    bool endsWithUnit(const FormulaNode &node) const
    {
        const FormulaNode *at = &node;
        while (at->kind == NodeKind::Negate)
            at = &m_formula.child(*at, 0);
        return at->kind == NodeKind::Unit;
    }

    std::string textOf(const FormulaNode &node)
    {
        const auto index = static_cast<std::size_t>(node.index);
        switch (node.kind) {
        case NodeKind::Number:
            return exactNumber(node.number);
        case NodeKind::Name:
            return m_formula.names()[index];
        case NodeKind::Text:
            return inQuotes(m_formula.texts()[index]);
        case NodeKind::Unit: {
            // A name would be beside a word, so that it has parentheses, too.
            const NodeKind of = m_formula.child(node, 0).kind;
            const bool isOperand = of == NodeKind::Number || of == NodeKind::Call;
            return take(node, 0, isOperand ? kOperand : kOperand + 1) + ' ' +
                   std::string(unitSigns()[index].sign);
        }
        case NodeKind::Negate:
            return '-' + take(node, 0, kSigned);
        case NodeKind::Call:
            return call(node, functionNames()[index].name);
        default:
            return binary(node);
        }
    }

    std::string call(const FormulaNode &node, std::string_view name)
    {
        std::string text(name);
        text += '(';
        for (int i = 0; i < node.childCount; ++i)
            text += (i > 0 ? "; " : "") + take(node, i, kComparison);
        return text + ')';
    }

    std::string binary(const FormulaNode &node)
    {
        const Binding own = bindingOf(node.kind);
        const bool isPower = node.kind == NodeKind::Power;
        int left = own, right = own + 1;
        if (own == kComparison) {
            left = kSum;
        } else if (isPower) {
            left = kOperand;
            right = kSigned;
        } else if (node.kind == NodeKind::Divide && !node.isFraction &&
                   endsWithUnit(m_formula.child(node, 1))) {
            right = kOperand;
        }
        std::string text = take(node, 0, left);
        text += signOf(node.kind);
        return text + take(node, 1, right);
    }

    const Formula &m_formula;
    std::vector<std::string> m_texts;
};

} // namespace

std::string writtenFormula(const Formula &formula)
{
    return FormulaWriter(formula).all();
}

} // namespace fff
