#include "ui/lengths.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace fff::ui {

namespace {

struct LengthText
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::LengthText)
};

constexpr double kInch = 25.4; // mm

struct Unit
{
    QLatin1StringView sign;
    double millimetres;
};
// Longer signs first: "mm" and "m" begin alike.
const std::array<Unit, 7> kUnits{{{QLatin1StringView("mm"), 1.0},
                                  {QLatin1StringView("cm"), 10.0},
                                  {QLatin1StringView("inch"), kInch},
                                  {QLatin1StringView("in"), kInch},
                                  {QLatin1StringView("ft"), 12.0 * kInch},
                                  {QLatin1StringView("m"), 1000.0},
                                  {QLatin1StringView("\""), kInch}}};

/// A plain number (power 0), a length in mm (1); anything else is no answer.
struct Quantity
{
    double value = 0.0;
    int power = 0;
    double unit = 0.0; // mm, of the number it ends with; 0: that had none
};

/// Recursive descent over: sum = term {± term}, term = factor {×÷ factor}, factor = [±] (number |
/// t | "(" sum ")") [unit].
class Parser
{
public:
    Parser(const QString &text, double ownUnit, const QLocale &locale, std::optional<double> t)
        : m_text(text), m_unit(ownUnit), m_locale(locale), m_t(t)
    {
    }

    std::optional<double> length()
    {
        const std::optional<Quantity> all = sum();
        skip();
        if (!all || m_at != m_text.size())
            return std::nullopt;
        const std::optional<Quantity> length = asLength(*all);
        return length && std::isfinite(length->value) ? std::optional(length->value) : std::nullopt;
    }

private:
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
    std::optional<Quantity> asLength(Quantity q) const
    {
        if (q.power == 0)
            return Quantity{q.value * m_unit, 1, m_unit};
        return q.power == 1 ? std::optional(q) : std::nullopt;
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
            const bool times = take(u"*\u00d7");
            if (!times && !take(u"/:\u00f7"))
                break;
            const std::optional<Quantity> right = factor();
            if (!right || (!times && right->value == 0.0))
                return std::nullopt;
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
            if (!q || !take(u")"))
                return std::nullopt;
            q->unit = 0.0;
        } else if (m_t && take(u"tT")) {
            return Quantity{*m_t, 1, 0.0};
        } else {
            q = number();
        }
        return q ? withUnit(*q) : q;
    }

    std::optional<Quantity> withUnit(Quantity q)
    {
        skip();
        for (const Unit &unit : kUnits) {
            if (!QStringView(m_text).mid(m_at).startsWith(unit.sign, Qt::CaseInsensitive))
                continue;
            if (q.power != 0)
                return std::nullopt;
            m_at += unit.sign.size();
            return Quantity{q.value * unit.millimetres, 1, unit.millimetres};
        }
        return q;
    }

    /// Digits, and "1 1/2" for one and a half.
    std::optional<Quantity> number()
    {
        const std::optional<double> whole = digits();
        if (!whole)
            return std::nullopt;
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
    double m_unit;
    const QLocale &m_locale;
    std::optional<double> m_t;
    qsizetype m_at = 0;
};

} // namespace

double millimetresPer(LengthUnit unit)
{
    return unit == LengthUnit::Centimetre ? 10.0 : unit == LengthUnit::Inch ? kInch : 1.0;
}

QString unitSign(LengthUnit unit)
{
    switch (unit) {
    case LengthUnit::Millimetre:
        return LengthText::tr("mm");
    case LengthUnit::Centimetre:
        return LengthText::tr("cm");
    case LengthUnit::Inch:
        return LengthText::tr("in");
    }
    return {};
}

QString unitName(LengthUnit unit)
{
    switch (unit) {
    case LengthUnit::Millimetre:
        return LengthText::tr("Millimetres");
    case LengthUnit::Centimetre:
        return LengthText::tr("Centimetres");
    case LengthUnit::Inch:
        return LengthText::tr("Inches");
    }
    return {};
}

QString numberText(double value, int least, int most, const QLocale &locale)
{
    QString text = locale.toString(value, 'f', most);
    for (int digits = most; digits > least && text.endsWith(locale.zeroDigit()); --digits)
        text.chop(1);
    if (least == 0 && most > 0 && text.endsWith(locale.decimalPoint()))
        text.chop(1);
    return text.replace(locale.negativeSign(), QChar(0x2212));
}

QString lengthNumber(double millimetres, int least, int most, const QLocale &locale)
{
    const LengthUnit unit = settings().unit();
    const int more = unit == LengthUnit::Millimetre ? 0 : 1;
    return numberText(millimetres / millimetresPer(unit), least + more, most + more, locale);
}

QString lengthText(double millimetres, int least, int most, const QLocale &locale)
{
    return QStringLiteral("%1\u202f%2")
        .arg(lengthNumber(millimetres, least, most, locale), unitSign(settings().unit()));
}

std::optional<double> parseLength(const QString &text, LengthUnit unit, const QLocale &locale,
                                  std::optional<double> t)
{
    return Parser(text, millimetresPer(unit), locale, t).length();
}

} // namespace fff::ui
