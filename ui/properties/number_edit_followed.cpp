// What a field does with the expression that its number follows.
#include "core/base/letters.h"
#include "core/values/formula.h"
#include "ui/base/expression_text.h"
#include "ui/properties/formula_line.h"
#include "ui/properties/number_edit.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kMarkWidth = 11; // px

QString withEquals(const QString &expression)
{
    return QStringLiteral("= ") + expression;
}

QString withoutEquals(const QString &typed)
{
    const QString plain = typed.trimmed();
    return plain.startsWith(u'=') ? plain.mid(1).trimmed() : plain;
}

QString lastWord(const QString &text)
{
    qsizetype begin = text.size();
    while (begin > 0 && (text[begin - 1].isLetterOrNumber() || text[begin - 1] == u'_'))
        --begin;
    return begin < text.size() && text[begin].isLetter() ? text.mid(begin) : QString();
}

} // namespace

void NumberEdit::setFollowed(Followed followed)
{
    m_followed = std::move(followed);
    if (m_formula || !m_followed)
        return;
    m_formula = new FormulaLine(
        this, [this](const QString &typed) { return take(typed); },
        [this] { return m_followed.names(); });
    connect(m_formula, &FormulaLine::refused, this, &NumberEdit::refuse);
    m_mark = new QLabel(QStringLiteral("\u0192"), this);
    m_mark->setObjectName(QStringLiteral("followsMark"));
    m_mark->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_mark->setAlignment(Qt::AlignCenter);
    QFont italic = m_mark->font();
    italic.setItalic(true);
    m_mark->setFont(italic);
    connect(lineEdit(), &QLineEdit::textEdited, this, &NumberEdit::followNames);
    showMark();
}

bool NumberEdit::follows() const
{
    return m_followed && !m_followed.typed().isEmpty();
}

bool NumberEdit::isTypingFormula() const
{
    return m_formula && m_formula->isOpen();
}

QString NumberEdit::formulaTyped() const
{
    return isTypingFormula() ? m_formula->text() : QString();
}

void NumberEdit::openFormula(const QString &typed)
{
    takeBack();
    m_formula->open(typed);
}

/// A click into a field that has the focus anyway shows it, too.
bool NumberEdit::eventFilter(QObject *object, QEvent *event)
{
    if (object == lineEdit() && event->type() == QEvent::MouseButtonPress && hasFocus())
        showExpression();
    // All of the number: Qt takes what stands before or behind the point for a word.
    if (object == lineEdit() && event->type() == QEvent::MouseButtonDblClick) {
        selectAll();
        return true;
    }
    return QDoubleSpinBox::eventFilter(object, event);
}

void NumberEdit::focusInEvent(QFocusEvent *event)
{
    QDoubleSpinBox::focusInEvent(event);
    if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
        showExpression();
}

void NumberEdit::showExpression()
{
    if (!follows() || m_formula->isOpen() || m_formula->isClosing() || lineEdit()->isModified())
        return;
    openFormula(withEquals(m_followed.typed()));
    m_formula->selectAll();
}

/// "=" begins an expression; where there is one, so does all that is typed. While one is typed it
/// has the keys.
bool NumberEdit::takesKey(QKeyEvent *event)
{
    if (!m_formula)
        return false;
    if (!m_formula->isOpen()) {
        const bool isText = !event->text().isEmpty() && event->text().front().isPrint();
        const bool isFirst = lineEdit()->selectedText() == lineEdit()->text() ||
                             lineEdit()->selectedText() + suffix() == lineEdit()->text() ||
                             lineEdit()->text() == suffix();
        const bool begins = event->text() == QStringLiteral("=") && isFirst;
        if (!isText || !(begins || (follows() && !lineEdit()->isModified())))
            return false;
        openFormula({});
    }
    QCoreApplication::sendEvent(m_formula, event);
    return true;
}

/// The name of a value begins an expression without "=", too.
void NumberEdit::followNames(const QString &text)
{
    const QString typed = text.endsWith(suffix()) ? text.chopped(suffix().size()) : text;
    const QString word = lastWord(typed);
    const QStringList known = m_followed.names();
    const bool isName =
        !word.isEmpty() && std::any_of(known.begin(), known.end(), [&word](const QString &name) {
            return name.startsWith(word, Qt::CaseInsensitive);
        });
    if (!isName)
        return;
    openFormula(typed);
    m_formula->setModified(true);
}

/// What can not be read behind "=" is an expression, too: it is refused as one.
bool NumberEdit::isFormula(const QString &typed) const
{
    Reading reading;
    reading.commas = commasOf(locale());
    const Understood<Formula> formula = Formula::read(withoutEquals(typed).toStdString(), reading);
    const bool hasEquals = typed.trimmed().startsWith(u'=');
    if (!formula)
        return hasEquals;
    if (hasEquals)
        return !formula->names().empty();
    if (formula->names().empty())
        return !read(typed).value; // a function
    const QStringList known = m_followed.names();
    return std::any_of(formula->names().begin(), formula->names().end(),
                       [&known](const std::string &name) {
                           return std::any_of(known.begin(), known.end(), [&](const QString &one) {
                               return foldedName(one.toStdString()) == name;
                           });
                       });
}

/// An expression or a number, which ends one. Empty: it does; else why it cannot.
QString NumberEdit::take(const QString &typed)
{
    return isFormula(typed) ? m_followed.follow(withoutEquals(typed))
                            : takeNumber(read(withoutEquals(typed)));
}

QString NumberEdit::takeNumber(const Expression &number)
{
    if (number.fault == Expression::Fault::Empty)
        return {};
    if (const QString why = whyNot(number); !why.isEmpty())
        return why;
    if (follows() && m_shown && textFromValue(*number.value) == textFromValue(*m_shown)) {
        m_followed.release();
        return {};
    }
    setValue(*number.value);
    announce();
    return {};
}

void NumberEdit::showMark()
{
    if (!m_mark)
        return;
    const bool isShown = follows();
    m_mark->setVisible(isShown);
    if (isShown != (lineEdit()->textMargins().left() > 0))
        lineEdit()->setTextMargins(isShown ? kMarkWidth - 2 : 0, 0, 0, 0);
}

void NumberEdit::resizeEvent(QResizeEvent *event)
{
    QDoubleSpinBox::resizeEvent(event);
    if (!m_mark)
        return;
    m_mark->setGeometry(lineEdit()->x(), 0, kMarkWidth, height());
    if (m_formula->isOpen())
        m_formula->fit();
}

/// The tip of what it lies in is not covered while there is no expression.
bool NumberEdit::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip && follows())
        setToolTip(withEquals(m_followed.typed()));
    else if (event->type() == QEvent::ToolTip && toolTip().startsWith(withEquals({})))
        setToolTip({});
    // While nothing is typed, Ctrl+Z is the model's.
    if (event->type() == QEvent::ShortcutOverride && !lineEdit()->isModified()) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QDoubleSpinBox::event(event);
}

} // namespace fff::ui
