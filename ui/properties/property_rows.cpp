#include "ui/properties/property_rows.h"

#include "ui/base/icon.h"
#include "ui/properties/slider_field.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kLabelWidth = 96, kRowHeight = 30; // px
constexpr int kNameAbove = 20;                   // px, of a name that stands above its editor

} // namespace

QToolButton *smallButton(const QString &icon, const char *objectName, const QString &tip,
                         QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setObjectName(QLatin1String(objectName));
    button->setIcon(themedIcon(icon));
    button->setIconSize({16, 16});
    button->setFixedSize(26, 26);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAutoRaise(true);
    return button;
}

PropertyRow::PropertyRow(const QString &name, QWidget *parent)
    : QWidget(parent), m_label(new QLabel(name, this)), m_pattern(name)
{
    m_label->setMinimumWidth(kLabelWidth);
    m_label->setTextFormat(Qt::PlainText); // it may name a section
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(m_label);
    setMinimumHeight(kRowHeight);
}

void PropertyRow::setEditor(QWidget *editor, const char *objectName, bool fills)
{
    m_editor = editor;
    editor->setObjectName(QLatin1String(objectName));
    tellEditor();
    m_label->setBuddy(editor);
    setFocusProxy(editor);
    auto *row = static_cast<QHBoxLayout *>(layout());
    row->addWidget(editor, fills ? 1 : 0);
    if (!fills)
        row->addStretch(1);
}

void PropertyRow::giveWholeRow()
{
    m_label->hide();
}

void PropertyRow::narrowLabel(int width)
{
    m_label->setMinimumWidth(width);
}

void PropertyRow::setName(const QString &pattern, const QString &of)
{
    if (m_pattern == pattern && m_of == of)
        return;
    m_pattern = pattern;
    m_of = of;
    tellEditor();
    showName();
}

void PropertyRow::setMarked(bool marked, const QString &tip)
{
    m_label->setToolTip(tip);
    m_editor->setAccessibleDescription(marked ? tip : QString());
    tellEditor();
    if (m_isMarked == marked)
        return;
    m_isMarked = marked;
    QFont words = font();
    words.setBold(marked);
    m_label->setFont(words);
    showName();
}

void PropertyRow::alignLabels(const std::vector<PropertyRow *> &rows)
{
    int width = kLabelWidth;
    for (const PropertyRow *row : rows) {
        row->m_label->ensurePolished();
        width = std::max(width, row->m_label->sizeHint().width());
    }
    for (PropertyRow *row : rows)
        row->m_label->setMinimumWidth(width);
}

void PropertyRow::giveNameTheRest()
{
    m_nameHasTheRest = true;
    m_label->setMinimumWidth(0);
    m_label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto *row = static_cast<QHBoxLayout *>(layout());
    row->setStretchFactor(m_label, 1);
    row->setStretchFactor(m_editor, 0);
}

void PropertyRow::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    placeName();
    if (!m_nameHasTheRest)
        return;
    layout()->activate();
    showName();
}

void PropertyRow::setLeastRoom(int width)
{
    m_leastRoom = width;
    placeName();
}

void PropertyRow::placeName()
{
    if (m_label->isHidden() || m_nameHasTheRest)
        return;
    int beside =
        std::max(m_label->minimumWidth(), m_label->sizeHint().width()) + layout()->spacing();
    for (int i = 0; i < layout()->count(); ++i)
        if (const QWidget *other = layout()->itemAt(i)->widget();
            other && other != m_label && other != m_editor)
            beside += other->width() + layout()->spacing();
    const bool isAbove = width() - beside < m_leastRoom;
    if (isAbove != m_isNameAbove) {
        m_isNameAbove = isAbove;
        auto *row = static_cast<QHBoxLayout *>(layout());
        if (isAbove)
            row->removeWidget(m_label);
        else
            row->insertWidget(0, m_label);
        row->setContentsMargins(0, isAbove ? kNameAbove : 0, 0, 0);
        setMinimumHeight(kRowHeight + (isAbove ? kNameAbove : 0));
    }
    if (isAbove)
        m_label->setGeometry(0, 0, width(), kNameAbove);
}

/// What is read out when it has the focus.
void PropertyRow::tellEditor()
{
    const QString name = m_of.isEmpty() ? m_pattern : m_pattern.arg(m_of);
    m_editor->setAccessibleName(name);
    if (auto *field = qobject_cast<SliderField *>(m_editor))
        field->setSpoken(name, m_editor->accessibleDescription());
}

void PropertyRow::showName()
{
    const QString mark = m_isMarked ? QStringLiteral(" \u2022") : QString();
    if (m_nameHasTheRest) {
        QString name =
            m_label->fontMetrics().elidedText(m_pattern, Qt::ElideRight, m_label->width());
        m_label->setToolTip(name == m_pattern ? QString() : m_pattern);
        name.replace(u'&', QStringLiteral("&&")); // no key of a shortcut
        m_label->setText(name);
        return;
    }
    if (m_of.isEmpty()) {
        m_label->setText(m_pattern + mark);
        return;
    }
    const QFontMetrics metrics(m_label->font());
    const int room = kLabelWidth - metrics.horizontalAdvance(m_pattern.arg(QString()) + mark);
    QString of = metrics.elidedText(m_of, Qt::ElideMiddle, room);
    of.replace(u'&', QStringLiteral("&&")); // no key of a shortcut
    m_label->setText(m_pattern.arg(of) + mark);
}

QToolButton *PropertyRow::addButton(const QString &icon, const char *objectName, const QString &tip,
                                    std::function<void()> act)
{
    QToolButton *button = smallButton(icon, objectName, tip, this);
    connect(button, &QToolButton::clicked, this, std::move(act));
    layout()->addWidget(button);
    return button;
}

TextRow::TextRow(const QString &name, const char *objectName, std::function<QString()> read,
                 QWidget *parent)
    : PropertyRow(name, parent), m_value(new QLabel(this)), m_read(std::move(read))
{
    m_value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_value->setTextFormat(Qt::PlainText);
    m_value->setWordWrap(true);
    setEditor(m_value, objectName, true);
}

void TextRow::refresh()
{
    const QString read = m_read();
    const bool isMixed = read.isNull();
    const QString text =
        isMixed ? QCoreApplication::translate("fff::ui::NumberEdit", "mixed") : read;
    if (m_value->text() == text)
        return;
    m_value->setText(text);
    QFont words = font();
    words.setItalic(isMixed);
    m_value->setFont(words);
    m_value->setForegroundRole(isMixed ? QPalette::PlaceholderText : QPalette::NoRole);
}

LengthRow::LengthRow(const QString &name, const char *objectName, const LengthEdit::Range &range,
                     std::function<std::optional<double>()> read, std::function<void(double)> write,
                     QWidget *parent)
    : PropertyRow(name, parent), m_edit(new LengthEdit(range, this)), m_read(std::move(read))
{
    setEditor(m_edit, objectName, true);
    connect(m_edit, &LengthEdit::lengthEdited, this,
            [this, write = std::move(write)](double value) {
                write(value);
                refresh(); // a refused value goes back to what it was
            });
}

void LengthRow::refresh()
{
    m_edit->setLength(m_read());
}

ChoiceRow::ChoiceRow(const QString &name, const char *objectName, std::function<Choices()> read,
                     std::function<void(int)> write, QWidget *parent)
    : PropertyRow(name, parent), m_box(new ChoiceBox(this)), m_read(std::move(read))
{
    m_box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_box->setMinimumContentsLength(8);
    setEditor(m_box, objectName, true);
    connect(m_box, &QComboBox::activated, this, [this, write = std::move(write)](int index) {
        write(index);
        refresh();
    });
}

void ChoiceRow::refresh()
{
    m_box->setChoices(m_read());
    setLeastRoom(m_box->widthForShown());
}

void ChoiceRow::resizeEvent(QResizeEvent *event)
{
    setLeastRoom(m_box->widthForShown());
    PropertyRow::resizeEvent(event);
}

EditorRow::EditorRow(const QString &name, const char *objectName, QWidget *editor,
                     std::function<void()> read, QWidget *parent)
    : PropertyRow(name, parent), m_read(std::move(read))
{
    if (editor) {
        editor->setParent(this);
        setEditor(editor, objectName, true);
    } else {
        hide();
    }
}

void EditorRow::refresh()
{
    if (m_read)
        m_read();
}

PropertyGroup::PropertyGroup(const QString &name, QWidget *parent)
    : QWidget(parent), m_name(name), m_title(new QPushButton(this)), m_rows(new QWidget(this))
{
    m_title->setObjectName(QStringLiteral("groupTitle"));
    m_title->setText(name);
    m_title->setAccessibleName(name);
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // a long one widens nothing
    m_title->setAutoDefault(false); // in a dialog Enter in a field would fold it
    m_title->setHidden(name.isEmpty());
    m_title->setIcon(themedIcon(QStringLiteral("chevron_down")));
    m_title->setIconSize({14, 14});
    auto *rows = new QVBoxLayout(m_rows);
    rows->setContentsMargins(0, 4, 0, 0);
    rows->setSpacing(0);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 16);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_rows);
    connect(m_title, &QPushButton::clicked, this, [this] { fold(!m_rows->isHidden()); });
}

void PropertyGroup::fold(bool folds)
{
    m_rows->setVisible(!folds);
    m_title->setIcon(
        themedIcon(folds ? QStringLiteral("chevron_right") : QStringLiteral("chevron_down")));
}

void PropertyGroup::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    constexpr int kBesideTitle = 26; // px: the arrow, and what a button leaves free
    const QString text =
        m_title->fontMetrics().elidedText(m_name, Qt::ElideRight, width() - kBesideTitle);
    m_title->setText(text);
    m_title->setToolTip(text == m_name ? QString() : m_name);
}

void PropertyGroup::add(QWidget *row)
{
    m_rows->layout()->addWidget(row);
}

} // namespace fff::ui
