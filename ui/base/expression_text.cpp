#include "ui/base/expression_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace fff::ui {

namespace {

using Fault = Expression::Fault;

struct ExpressionTexts
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
        return ExpressionTexts::tr("A number is missing.");
    case Fault::Unreadable:
        return ExpressionTexts::tr("\u201c%1\u201d cannot be read here.").arg(piece);
    case Fault::Unfinished:
        return ExpressionTexts::tr("Something is missing after “%1”.").arg(piece);
    case Fault::OpenParenthesis:
        return ExpressionTexts::tr("A parenthesis is not closed.");
    case Fault::LooseParenthesis:
        return ExpressionTexts::tr("There is one closing parenthesis too many.");
    case Fault::DivisionByZero:
        return ExpressionTexts::tr("Nothing can be divided by 0.");
    case Fault::UnknownName:
        return ExpressionTexts::tr("There is no value named “%1”.").arg(piece);
    case Fault::NotALength:
        return ExpressionTexts::tr("This is not a length; multiply a length by a plain number.");
    case Fault::NotAMass:
        return ExpressionTexts::tr("This is not a mass; multiply a mass by a plain number.");
    case Fault::NoThickness:
        return ExpressionTexts::tr(
            "“t” is the thickness of the stock; there is no single stock here.");
    }
    return {};
}

} // namespace fff::ui
