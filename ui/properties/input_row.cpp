#include "ui/properties/input_row.h"

#include "core/session/operation_text.h"
#include "ui/base/icon.h"
#include "ui/base/theme.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QPainter>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

struct InputRowTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::InputRow)
};

constexpr int kRowHeight = 24, kMostRows = 6; // of the list

/// Looks like a field: what is chosen, and the picker at its end. Pressed it asks in the view.
class PickerField : public QAbstractButton
{
public:
    explicit PickerField(QWidget *parent) : QAbstractButton(parent)
    {
        setCheckable(true);
        setFocusPolicy(Qt::StrongFocus);
        setAttribute(Qt::WA_Hover);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override { return {120, kFieldHeight}; }
    QSize minimumSizeHint() const override { return {60, kFieldHeight}; }

protected:
    void paintEvent(QPaintEvent *) override
    {
        constexpr int kIcon = 16, kPad = 7;
        const Theme &t = theme();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const double line = hasFocus() ? 2.0 : 1.0;
        const QRectF frame =
            QRectF(rect()).adjusted(0.5 * line, 0.5 * line, -0.5 * line, -0.5 * line);
        painter.setPen(QPen(hasFocus() || isChecked() ? t.accent : t.strong, line));
        painter.setBrush(isChecked() ? t.soft : underMouse() ? t.hover : t.panel);
        painter.drawRoundedRect(frame, 3.0, 3.0);
        const double ratio = devicePixelRatioF();
        const int top = (height() - kIcon) / 2;
        painter.drawPixmap(kPad, top,
                           tintedPixmap(QStringLiteral("section"), kIcon, t.muted, ratio));
        painter.drawPixmap(width() - kPad - kIcon, top,
                           tintedPixmap(QStringLiteral("pick"), kIcon, t.accent, ratio));
        const QRect words = rect().adjusted(2 * kPad + kIcon, 0, -2 * kPad - kIcon, 0);
        painter.setFont(font());
        painter.setPen(isChecked() ? t.accent : font().italic() ? t.problem : t.text);
        painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft,
                         fontMetrics().elidedText(text(), Qt::ElideMiddle, words.width()));
    }

private:
    static constexpr int kFieldHeight = 26; // px
};

} // namespace

InputRow::InputRow(const InputSpec &spec, Reactions reactions, QWidget *parent)
    : PropertyRow(operationText(spec.label), parent), m_spec(spec),
      m_reactions(std::move(reactions))
{
    if (spec.most == 1)
        makeField();
    else
        makeList();
}

void InputRow::makeField()
{
    m_field = new PickerField(this);
    m_field->installEventFilter(this);
    setEditor(m_field, m_spec.role, true);
    connect(m_field, &QAbstractButton::clicked, this, [this] { m_reactions.pick(); });
}

void InputRow::makeList()
{
    auto *box = new QWidget(this);
    m_list = new QListWidget(box);
    m_list->setObjectName(QLatin1String(m_spec.role));
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setAccessibleName(operationText(m_spec.label));
    m_list->setAccessibleDescription(InputRowTexts::tr(
        "Delete removes a section; drag, or Alt with an arrow key, changes the order."));
    m_list->setUniformItemSizes(true);
    m_list->setIconSize({16, 16});
    m_list->setMouseTracking(true);
    m_list->installEventFilter(this);
    m_list->viewport()->installEventFilter(this);
    m_pick = smallButton(QStringLiteral("pick"), "inputPick", operationText(m_spec.prompt), box);
    m_pick->setCheckable(true);
    m_takeOut =
        smallButton(QStringLiteral("trash"), "inputTakeOut", InputRowTexts::tr("Remove it"), box);
    auto *buttons = new QVBoxLayout;
    buttons->setSpacing(0);
    buttons->addWidget(m_pick);
    buttons->addWidget(m_takeOut);
    buttons->addStretch(1);
    auto *row = new QHBoxLayout(box);
    row->setContentsMargins(0, 2, 0, 2);
    row->setSpacing(4);
    row->addWidget(m_list, 1);
    row->addLayout(buttons);
    setEditor(box, m_spec.role, true);
    box->setFocusProxy(m_list);
    connect(m_pick, &QToolButton::clicked, this, [this] { m_reactions.pick(); });
    connect(m_takeOut, &QToolButton::clicked, this, [this] { takeOut(); });
    connect(m_list, &QListWidget::currentRowChanged, this,
            [this](int index) { m_takeOut->setEnabled(index >= 0); });
    connect(m_list, &QListWidget::itemEntered, this, [this](QListWidgetItem *item) {
        const auto index = static_cast<std::size_t>(m_list->row(item));
        if (index < m_inputs.size())
            outline(m_inputs[index].section);
    });
    connect(m_list, &QListWidget::viewportEntered, this, [this] { outline({}); });
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this, [this] { takeOrder(); });
}

/// An empty one: none is under the cursor any more.
void InputRow::outline(const SectionRef &section)
{
    const bool isOver = !(section == SectionRef());
    if (isOver || m_isOutlining)
        m_reactions.hovered(section);
    m_isOutlining = isOver;
}

bool InputRow::eventFilter(QObject *object, QEvent *event)
{
    if (event->type() == QEvent::Leave || event->type() == QEvent::Hide)
        outline({});
    if (object == m_field && event->type() == QEvent::Enter && !m_inputs.empty())
        outline(m_inputs.front().section);
    // Here Delete is for the list, not for what is selected in the view.
    if (object == m_list && event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent *>(event)->key() == Qt::Key_Delete) {
        event->accept();
        return true;
    }
    if (object == m_list && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        if (key == Qt::Key_Delete || key == Qt::Key_Backspace) {
            takeOut();
            return true;
        }
        const bool isArrow = key == Qt::Key_Up || key == Qt::Key_Down;
        if (isArrow && static_cast<QKeyEvent *>(event)->modifiers() == Qt::AltModifier) {
            moveCurrent(key == Qt::Key_Up ? -1 : 1);
            return true;
        }
    }
    return PropertyRow::eventFilter(object, event);
}

std::pair<QString, bool> InputRow::nameOf(const OperationInput &input, const Model &model)
{
    // A section that an operation takes the place of is there all the same.
    const Section *drawn = model.document.find(input.section.drawn);
    if (const Section *section = drawn ? drawn : model.find(input.section))
        return {QString::fromStdString(section->name), true};
    //: %1 is the name of a section
    return {InputRowTexts::tr("%1 (deleted)").arg(QString::fromStdString(input.name)), false};
}

void InputRow::show(const Operation &operation, const Model &model, bool picks)
{
    const bool doesCount = counts(m_spec, operation);
    setVisible(doesCount);
    if (!doesCount)
        return;
    const auto found = operation.inputs.find(m_spec.role);
    m_inputs = found == operation.inputs.end() ? std::vector<OperationInput>() : found->second;
    if (m_list) {
        showList(model);
        m_pick->setChecked(picks);
        return;
    }
    m_field->setChecked(picks);
    QString name = InputRowTexts::tr("Choose…");
    bool isThere = false;
    if (!m_inputs.empty())
        std::tie(name, isThere) = nameOf(m_inputs.front(), model);
    QFont words = font();
    words.setItalic(!isThere);
    m_field->setFont(words);
    m_field->setText(name);
    m_field->setToolTip(QStringLiteral("%1\n%2").arg(name, operationText(m_spec.prompt)));
    //: %1 is what an operation works on ("Along"), %2 the name of a section
    m_field->setAccessibleName(InputRowTexts::tr("%1: %2").arg(operationText(m_spec.label), name));
}

void InputRow::showList(const Model &model)
{
    const QScopedValueRollback filling(m_isFilling, true);
    while (m_list->count() > static_cast<int>(m_inputs.size()))
        delete m_list->takeItem(m_list->count() - 1);
    while (m_list->count() < static_cast<int>(m_inputs.size())) {
        auto *item = new QListWidgetItem(rowIcon(QStringLiteral("section")), QString(), m_list);
        item->setSizeHint({0, kRowHeight});
    }
    for (int i = 0; i < m_list->count(); ++i) {
        const auto [name, isThere] = nameOf(m_inputs[static_cast<std::size_t>(i)], model);
        QListWidgetItem *item = m_list->item(i);
        item->setText(name);
        item->setData(Qt::UserRole, i);
        QFont words = font();
        words.setItalic(!isThere);
        item->setFont(words);
    }
    const int rows = std::clamp(m_list->count(), 2, kMostRows);
    m_list->setFixedHeight(rows * kRowHeight + 2 * m_list->frameWidth());
    m_takeOut->setEnabled(m_list->currentRow() >= 0);
}

void InputRow::takeOut()
{
    const int index = m_list->currentRow();
    if (index < 0 || index >= static_cast<int>(m_inputs.size()))
        return;
    outline({});
    std::vector<OperationInput> next = m_inputs;
    next.erase(next.begin() + index);
    m_reactions.reordered(std::move(next));
}

void InputRow::moveCurrent(int by)
{
    const int from = m_list->currentRow(), to = from + by;
    if (from < 0 || to < 0 || to >= static_cast<int>(m_inputs.size()))
        return;
    std::vector<OperationInput> next = m_inputs;
    std::swap(next[static_cast<std::size_t>(from)], next[static_cast<std::size_t>(to)]);
    m_reactions.reordered(std::move(next));
    m_list->setCurrentRow(to);
}

void InputRow::takeOrder()
{
    if (m_isFilling || m_list->count() != static_cast<int>(m_inputs.size()))
        return;
    std::vector<OperationInput> next;
    for (int i = 0; i < m_list->count(); ++i)
        next.push_back(m_inputs[m_list->item(i)->data(Qt::UserRole).toULongLong()]);
    if (next == m_inputs)
        return;
    // Once the drag is over: the list still moves its items now.
    QMetaObject::invokeMethod(
        this, [this, next] { m_reactions.reordered(next); }, Qt::QueuedConnection);
}

} // namespace fff::ui
