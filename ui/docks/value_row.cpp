#include "ui/docks/value_row.h"

#include "core/interaction/value_editing.h"
#include "core/session/message_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/docks/value_details.h"
#include "ui/docks/value_editor.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/property_rows.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

namespace fff::ui {

namespace {

enum ValueColumn { kValueName, kValueEditor, kValueMore, kValueColumns };
enum ValueLine { kValueItself, kValueNote, kValueProblem, kValueDetails };

constexpr int kValueNameWidth = 88, kValueHeight = 30, kBelowNote = 10; // px
constexpr int kBesideName = 4; // px that a line of text leaves free

} // namespace

ValueRow::ValueRow(Workbench &bench, ValueId value, QWidget *parent)
    : QWidget(parent), m_bench(bench), m_id(value)
{
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("valueName"));
    m_name->setFrame(false);
    m_name->setMinimumWidth(kValueNameWidth);
    m_name->setAccessibleName(tr("Name of the value"));
    connect(m_name, &QLineEdit::editingFinished, this, &ValueRow::rename);
    connect(m_name, &QLineEdit::textEdited, this, &ValueRow::forgetRefusal);
    m_name->installEventFilter(this);
    m_more =
        smallButton(QStringLiteral("chevron_right"), "valueMore", tr("Kind, range and note"), this);
    connect(m_more, &QToolButton::clicked, this,
            [this] { unfold(!m_details || m_details->isHidden()); });
    m_note = new QLabel(this);
    m_note->setObjectName(QStringLiteral("valueNote"));
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setForegroundRole(QPalette::PlaceholderText);
    m_note->setContentsMargins(0, 0, 0, kBelowNote); // it is of the row above it
    m_note->hide();
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("valueProblem"));
    m_problem->setWordWrap(true);
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->hide();
    m_grid = new QGridLayout(this);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(6);
    m_grid->setVerticalSpacing(0);
    m_grid->setRowMinimumHeight(kValueItself, kValueHeight);
    m_grid->setColumnStretch(kValueName, 2);
    m_grid->setColumnStretch(kValueEditor, 3);
    m_grid->addWidget(m_name, kValueItself, kValueName);
    m_grid->addWidget(m_more, kValueItself, kValueMore);
    m_grid->addWidget(m_note, kValueNote, kValueName, 1, kValueColumns);
    m_grid->addWidget(m_problem, kValueProblem, kValueName, 1, kValueColumns);
}

void ValueRow::setAdjustsOnly(bool only)
{
    m_adjustsOnly = only;
    m_name->setReadOnly(only);
    m_name->setFocusPolicy(only ? Qt::NoFocus : Qt::StrongFocus);
    m_more->setVisible(!only);
    if (only)
        unfold(false);
}

void ValueRow::beginNaming()
{
    m_name->setFocus(Qt::OtherFocusReason);
    m_name->selectAll();
}

void ValueRow::unfold(bool unfolds)
{
    m_more->setIcon(
        themedIcon(unfolds ? QStringLiteral("chevron_down") : QStringLiteral("chevron_right")));
    if (!m_details && unfolds) {
        m_details = new ValueDetails(m_bench, m_id, this);
        connect(m_details, &ValueDetails::refused, this, &ValueRow::say);
        m_grid->addWidget(m_details, kValueDetails, kValueName, 1, kValueColumns);
        m_details->refresh();
        dress(m_details);
    }
    if (m_details)
        m_details->setVisible(unfolds);
}

void ValueRow::rename()
{
    const Document &document = m_bench.session().committed().document;
    const Value *known = document.values.find(m_id);
    if (!m_name->isModified() || !known)
        return;
    // Whoever writes two words means one name.
    const std::string name = m_name->text().simplified().replace(u' ', u'_').toStdString();
    const QString why =
        name == known->name ? QString() : tryEdit(m_bench, valueRenamed(document, m_id, name));
    // What was refused stays to be mended, as long as somebody is at it.
    m_name->setModified(!why.isEmpty() && m_name->hasFocus());
    say(why);
}

/// A name that was refused and is left is given up.
bool ValueRow::eventFilter(QObject *object, QEvent *event)
{
    if (object == m_name && event->type() == QEvent::FocusOut)
        QMetaObject::invokeMethod(
            this,
            [this] {
                if (m_name->hasFocus() || !m_name->isModified() || !window()->isActiveWindow())
                    return;
                m_name->setModified(false);
                refresh();
            },
            Qt::QueuedConnection);
    return QWidget::eventFilter(object, event);
}

void ValueRow::forgetRefusal()
{
    if (m_refusal.isEmpty())
        return;
    m_refusal.clear();
    refresh();
}

void ValueRow::say(const QString &why)
{
    m_refusal = why;
    refresh();
}

/// From the name to the field, and then to what stands beside that: an editor with a focus proxy
/// alone would be passed over.
void ValueRow::orderTabs()
{
    QWidget *field = m_editor->focusProxy();
    QWidget *before = m_name;
    const auto comeNext = [&before](QWidget *widget) {
        setTabOrder(before, widget);
        before = widget;
    };
    if (field)
        comeNext(field);
    for (QWidget *widget : m_editor->findChildren<QWidget *>())
        if (widget != field && !widget->focusProxy() && (widget->focusPolicy() & Qt::TabFocus))
            comeNext(widget);
    comeNext(m_more);
}

void ValueRow::showEditor(const KnownValue &known)
{
    const bool isMade = !known.typed || !known.typed->isConstant();
    if (m_editor && m_editor->fits(known.value, isMade))
        return;
    const bool hadFocus = m_editor && m_editor->isAncestorOf(focusWidget());
    if (m_editor) { // it may be the one who asks
        m_editor->hide();
        m_editor->deleteLater();
    }
    m_editor = new ValueEditor(m_bench, known.value, isMade, this);
    m_editor->setObjectName(QStringLiteral("valueEditor"));
    connect(m_editor, &ValueEditor::refused, this, &ValueRow::say);
    m_grid->addWidget(m_editor, kValueItself, kValueEditor);
    orderTabs();
    dress(m_editor);
    m_editor->QWidget::show();
    if (hadFocus)
        m_editor->setFocus(Qt::OtherFocusReason);
}

void ValueRow::refresh()
{
    const Model &model = m_bench.session().model();
    const int index = model.document.values.indexOf(m_id);
    if (index < 0)
        return;
    const KnownValue &known = *model.document.values.list[static_cast<std::size_t>(index)];
    const QString name = QString::fromStdString(known.value.name);
    if (!(m_name->hasFocus() && m_name->isModified()) && m_name->text() != name) {
        m_name->setText(name);
        m_name->setCursorPosition(0); // a long one is seen from its beginning
    }
    if (!m_name->hasFocus()) {
        const int room = m_name->width() - 2 * kBesideName;
        m_name->setToolTip(fontMetrics().horizontalAdvance(name) > room ? name : QString());
    }
    const QString note = QString::fromStdString(known.value.note);
    setToolTip(m_adjustsOnly ? QString() : note.toHtmlEscaped());
    m_note->setVisible(m_adjustsOnly && !note.isEmpty());
    m_note->setText(note);
    showEditor(known);
    m_editor->show(known.value, model.evaluation.values.worth(m_id));
    // What is made of others is there to be read: a number typed over it would end that.
    m_editor->setEnabled(!m_adjustsOnly || (known.typed && known.typed->isConstant()));
    m_editor->setSpoken(name);
    if (m_details && !m_details->isHidden())
        m_details->refresh();
    const ExpressionError *error = model.evaluation.values.error(m_id);
    const QString wrong = !m_refusal.isEmpty() ? m_refusal
                          : error              ? messageText(error->message, unitsInUse())
                                               : QString();
    m_problem->setVisible(!wrong.isEmpty());
    if (m_problem->text() != wrong)
        m_problem->setText(wrong);
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, theme().problem);
    m_problem->setPalette(colours);
}

void ValueRow::enterEvent(QEnterEvent *)
{
    Q_EMIT hovered(true);
}

void ValueRow::leaveEvent(QEvent *)
{
    Q_EMIT hovered(false);
}

} // namespace fff::ui
