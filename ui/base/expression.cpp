#include "ui/base/expression.h"

#include <QCoreApplication>

#include <cmath>
#include <vector>

namespace fff::ui {

namespace {

using Fault = Expression::Fault;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::Expression)
};

struct Unit
{
    QString sign;
    double size = 1.0; // mm; of a plain number's sign, no matter
    int power = 0;     // 1: of a length
};

// Longer signs first: "mm" and "m" begin alike.
std::vector<Unit> lengthUnits()
{
    constexpr double kInch = 25.4;
    return {{QStringLiteral("mm"), 1.0, 1},        {QStringLiteral("cm"), 10.0, 1},
            {QStringLiteral("inch"), kInch, 1},    {QStringLiteral("in"), kInch, 1},
            {QStringLiteral("ft"), 12 * kInch, 1}, {QStringLiteral("m"), 1000.0, 1},
            {QStringLiteral("\""), kInch, 1}};
}

/// A plain number (power 0), a length in mm (1); anything else is no answer.
struct Quantity
{
    double value = 0.0;
    int power = 0;
    double unit = 0.0; // mm, of the number it ends with; 0: that had none
};

struct Grammar
{
    std::vector<Unit> units;
    enum class Wanted { Number, Length, Any };
    Wanted wanted = Wanted::Number;
    double ownUnit = 1.0; // mm, of numbers without one, where lengths are meant
    std::optional<double> t;
    NumberNames names;

    bool hasLengths() const { return wanted != Wanted::Number; }
};

/// Recursive descent over: sum = term {± term}, term = factor {×÷ factor}, factor = [±] (number |
/// t | name | "(" sum ")") [unit]. The first fault ends it.
class Parser
{
public:
    Parser(const QString &text, const Grammar &grammar, const QLocale &locale)
        : m_text(text), m_grammar(grammar), m_locale(locale)
    {
    }

    Expression read()
    {
        if (m_text.trimmed().isEmpty())
            return {{}, Fault::Empty};
        std::optional<Quantity> all = sum();
        skip();
        if (all && m_at != m_text.size()) {
            const bool isLoose = m_text[m_at] == u')';
            all = fail(isLoose ? Fault::LooseParenthesis : Fault::Unreadable, pieceHere());
        }
        if (all && m_grammar.wanted == Grammar::Wanted::Length)
            all = asLength(*all);
        if (all && (all->power < 0 || all->power > 1 ||
                    (all->power == 1 && m_grammar.wanted == Grammar::Wanted::Number)))
            all = fail(Fault::NotALength);
        if (!all)
            return m_failed;
        if (!std::isfinite(all->value))
            return {{}, Fault::Unreadable, m_text.trimmed()};
        return {all->value, Fault::None, {}, all->power == 1};
    }

private:
    std::nullopt_t fail(Fault fault, const QString &piece = {})
    {
        if (m_failed.fault == Fault::None)
            m_failed = {{}, fault, piece};
        return std::nullopt;
    }
    void skip()
    {
        while (m_at < m_text.size() && m_text[m_at].isSpace())
            ++m_at;
    }
    bool take(QStringView of)
    {
        skip();
        if (m_at == m_text.size() || !of.contains(m_text[m_at]))
            return false;
        ++m_at;
        return true;
    }
    /// The word or sign that stands here.
    QString pieceHere() const
    {
        qsizetype end = m_at;
        while (end < m_text.size() && (m_text[end].isLetterOrNumber() || m_text[end] == u'_'))
            ++end;
        return m_text.mid(m_at, std::max<qsizetype>(1, end - m_at));
    }
    std::optional<Quantity> asLength(Quantity q)
    {
        if (q.power == 0)
            return Quantity{q.value * m_grammar.ownUnit, 1, m_grammar.ownUnit};
        return q.power == 1 ? std::optional(q) : fail(Fault::NotALength);
    }

    std::optional<Quantity> sum()
    {
        std::optional<Quantity> left = term();
        while (left) {
            const bool plus = take(u"+");
            if (!plus && !take(u"-\u2212"))
                break;
            const std::optional<Quantity> right = term();
            if (!right)
                return std::nullopt;
            // Two numbers stay one; beside a length a number is one too.
            const bool isPlain = left->power == 0 && right->power == 0;
            const std::optional<Quantity> a = isPlain ? left : asLength(*left),
                                          b = isPlain ? right : asLength(*right);
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
            const bool times = take(u"*\u00d7\u00b7");
            if (!times && !take(u"/:\u00f7"))
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
        if (take(u"-\u2212")) {
            std::optional<Quantity> q = factor();
            if (q)
                q->value = -q->value;
            return q;
        }
        if (take(u"+"))
            return factor();
        std::optional<Quantity> q;
        if (take(u"(")) {
            q = sum();
            if (!q)
                return std::nullopt;
            if (!take(u")"))
                return m_at == m_text.size() ? fail(Fault::OpenParenthesis)
                                             : fail(Fault::Unreadable, pieceHere());
            q->unit = 0.0;
        } else if (m_grammar.hasLengths() && takeThickness()) {
            return m_grammar.t ? std::optional(Quantity{*m_grammar.t, 1, 0.0})
                               : fail(Fault::NoThickness);
        } else if (const QString name = takeName(); !name.isEmpty()) {
            const std::optional<NamedValue> named = m_grammar.names(name);
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
        if (pieceHere().compare(u"t", Qt::CaseInsensitive) != 0)
            return false;
        ++m_at;
        return true;
    }

    /// A word, where there are names; empty: none begins here.
    QString takeName()
    {
        skip();
        qsizetype end = m_at;
        const auto isLetter = [this](qsizetype at) {
            return m_text[at].isLetter() || m_text[at] == u'_';
        };
        if (!m_grammar.names || end == m_text.size() || !isLetter(end))
            return {};
        while (end < m_text.size() && (isLetter(end) || m_text[end].isDigit()))
            ++end;
        const QString name = m_text.mid(m_at, end - m_at);
        m_at = end;
        return name;
    }

    std::optional<Quantity> withUnit(Quantity q)
    {
        skip();
        for (const Unit &unit : m_grammar.units) {
            if (unit.sign.isEmpty() ||
                !QStringView(m_text).mid(m_at).startsWith(unit.sign, Qt::CaseInsensitive))
                continue;
            if (q.power != 0)
                return fail(Fault::NotALength);
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
            return m_at == m_text.size() ? fail(Fault::Unfinished, m_text.trimmed())
                                         : fail(Fault::Unreadable, pieceHere());
        }
        const qsizetype after = m_at;
        skip();
        if (m_at > after) {
            const std::optional<double> over = digits();
            if (over && take(u"/")) {
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
        const qsizetype from = m_at;
        while (m_at < m_text.size() &&
               (m_text[m_at].isDigit() || m_text[m_at] == u'.' || m_text[m_at] == u','))
            ++m_at;
        QString word = m_text.mid(from, m_at - from);
        const qsizetype point = word.lastIndexOf(u'.'), comma = word.lastIndexOf(u',');
        if (point >= 0 && comma >= 0) { // the later one stands before the decimals
            word.remove(point > comma ? u',' : u'.');
        } else if (comma >= 0 && m_locale.decimalPoint() == QStringLiteral(".") &&
                   word.size() - comma == 4) {
            word.remove(u','); // "1,000" is a thousand where nobody writes decimals so
        }
        word.replace(u',', u'.');
        bool isNumber = false;
        const double value = QLocale::c().toDouble(word, &isNumber);
        if (isNumber)
            return value;
        m_at = from;
        return std::nullopt;
    }

    const QString &m_text;
    const Grammar &m_grammar;
    const QLocale &m_locale;
    qsizetype m_at = 0;
    Expression m_failed;
};

} // namespace

Expression readLength(const QString &text, LengthUnit unit, const QLocale &locale,
                      std::optional<double> t, const NumberNames &names)
{
    const Grammar grammar{lengthUnits(), Grammar::Wanted::Length, millimetresPer(unit), t, names};
    return Parser(text, grammar, locale).read();
}

Expression readNumber(const QString &text, const QString &sign, const QLocale &locale,
                      const NumberNames &names)
{
    const Grammar grammar{{{sign}}, Grammar::Wanted::Number, 1.0, {}, names};
    return Parser(text, grammar, locale).read();
}

Expression readAny(const QString &text, const QLocale &locale, const NumberNames &names)
{
    const Grammar grammar{lengthUnits(), Grammar::Wanted::Any, 1.0, {}, names};
    return Parser(text, grammar, locale).read();
}

QString refusalText(const Expression &expression)
{
    const QString piece = expression.piece.toHtmlEscaped();
    switch (expression.fault) {
    case Fault::None:
        return {};
    case Fault::Empty:
        return Words::tr("A number is missing.");
    case Fault::Unreadable:
        return Words::tr("\u201c%1\u201d cannot be read here.").arg(piece);
    case Fault::Unfinished:
        return Words::tr("Something is missing behind \u201c%1\u201d.").arg(piece);
    case Fault::OpenParenthesis:
        return Words::tr("A parenthesis is not closed.");
    case Fault::LooseParenthesis:
        return Words::tr("There is one closing parenthesis too many.");
    case Fault::DivisionByZero:
        return Words::tr("Nothing can be divided by 0.");
    case Fault::UnknownName:
        return Words::tr("No number is called \u201c%1\u201d.").arg(piece);
    case Fault::NotALength:
        return Words::tr("This makes no length; multiply a length by a plain number.");
    case Fault::NoThickness:
        return Words::tr(
            "\u201ct\u201d is the thickness of the stock; there is not one stock here.");
    }
    return {};
}

} // namespace fff::ui
