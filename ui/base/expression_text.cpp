#include "ui/base/expression_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace fff::ui {

namespace {

using Fault = Expression::Fault;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ExpressionText)
};

} // namespace

Commas commasOf(const QLocale &locale)
{
    return locale.decimalPoint() == QStringLiteral(".") ? Commas::Groups : Commas::Decimals;
}

QString refusalText(const Expression &expression)
{
    const QString piece = QString::fromStdString(expression.piece).toHtmlEscaped();
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
