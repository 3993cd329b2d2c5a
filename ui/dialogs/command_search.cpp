#include "ui/dialogs/command_search.h"

#include "ui/actions/action_set.h"
#include "ui/base/theme.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kWidth = 600, kRowHeight = 40, kRows = 9, kMargin = 12, kIcon = 20, kEdge = 8; // px

enum Role { NameRole = Qt::UserRole, PathRole, KeysRole, ActionRole, EnabledRole };

/// Icon, name and below it the menu or why not; at the right the shortcut.
class Row : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override
    {
        return {kWidth / 2, kRowHeight};
    }

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override
    {
        const bool isCurrent = option.state & QStyle::State_Selected;
        const bool isEnabled = index.data(EnabledRole).toBool();
        const QColor text = isCurrent ? theme().onAccent : isEnabled ? theme().text : theme().muted;
        const QColor muted = isCurrent ? theme().onAccent : theme().muted;
        painter->save();
        painter->fillRect(option.rect, isCurrent ? theme().accent : theme().panel);
        QRect place = option.rect.adjusted(kMargin, 4, -kMargin, -4);
        const auto icon = index.data(Qt::DecorationRole).value<QIcon>();
        const QRect iconPlace(place.left(), option.rect.center().y() - kIcon / 2 + 1, kIcon, kIcon);
        icon.paint(painter, iconPlace, Qt::AlignCenter,
                   isCurrent   ? QIcon::Selected
                   : isEnabled ? QIcon::Normal
                               : QIcon::Disabled);
        place.setLeft(iconPlace.right() + kMargin);

        QFont small = option.font;
        small.setPointSizeF(option.font.pointSizeF() * 0.92);
        const QString keys = index.data(KeysRole).toString();
        const int keysWidth = QFontMetrics(small).horizontalAdvance(keys);
        painter->setFont(small);
        painter->setPen(muted);
        painter->drawText(place, Qt::AlignRight | Qt::AlignVCenter, keys);
        place.setRight(place.right() - keysWidth - (keysWidth > 0 ? kMargin : 0));

        painter->setFont(option.font);
        painter->setPen(text);
        const QFontMetrics metrics(option.font);
        const QRect upper(place.left(), place.top(), place.width(), place.height() / 2);
        painter->drawText(
            upper, Qt::AlignLeft | Qt::AlignVCenter,
            metrics.elidedText(index.data(NameRole).toString(), Qt::ElideRight, place.width()));
        painter->setFont(small);
        painter->setPen(muted);
        const QRect lower(place.left(), upper.bottom() + 1, place.width(), place.height() / 2);
        painter->drawText(lower, Qt::AlignLeft | Qt::AlignVCenter,
                          QFontMetrics(small).elidedText(index.data(PathRole).toString(),
                                                         Qt::ElideRight, place.width()));
        painter->restore();
    }
};

} // namespace

CommandSearch::CommandSearch(const QMenuBar &menus, QWidget *window)
    : QFrame(window, Qt::Popup), m_all(listedActions(menus))
{
    setObjectName(QStringLiteral("commandSearch"));
    setAttribute(Qt::WA_DeleteOnClose);
    setAccessibleName(tr("Find a command"));
    m_field = new QLineEdit(this);
    m_field->setObjectName(QStringLiteral("commandSearchField"));
    m_field->setPlaceholderText(tr("Type what you want to do"));
    m_field->setAccessibleName(tr("Find a command"));
    m_field->setMinimumHeight(32);
    m_field->installEventFilter(this);
    m_list = new QListWidget(this);
    m_list->setObjectName(QStringLiteral("commandSearchList"));
    m_list->setAccessibleName(tr("Matching commands"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setUniformItemSizes(true);
    m_list->setItemDelegate(new Row(m_list));
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setMouseTracking(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kEdge, kEdge, kEdge, kEdge);
    column->setSpacing(kEdge);
    column->addWidget(m_field);
    column->addWidget(m_list);

    connect(m_field, &QLineEdit::textChanged, this, &CommandSearch::fill);
    connect(m_list, &QListWidget::itemEntered, m_list,
            [this](QListWidgetItem *item) { m_list->setCurrentItem(item); });
    connect(m_list, &QListWidget::itemClicked, this, &CommandSearch::runCurrent);
    fill({});
    dress(this);
}

void CommandSearch::fill(const QString &query)
{
    m_list->clear();
    for (const ListedAction &found : foundActions(query, m_all)) {
        if (!found.action)
            continue;
        auto *row = new QListWidgetItem(m_list);
        const bool isEnabled = found.action->isEnabled();
        const QString why = isEnabled ? QString() : ActionSet::sentence(found.action);
        const QString keys = found.action->shortcut().toString(QKeySequence::NativeText);
        const QString mark = found.action->isChecked() ? QStringLiteral("\u2713\u2002") : QString();
        row->setData(NameRole, QString(mark + found.name));
        //: where an action is in the menus, and why it cannot be done now
        row->setData(PathRole,
                     why.isEmpty() ? found.menuPath : tr("%1: %2", "why").arg(found.menuPath, why));
        row->setData(KeysRole, keys);
        row->setData(EnabledRole, isEnabled);
        row->setData(ActionRole, QVariant::fromValue<QObject *>(found.action.data()));
        row->setData(Qt::DecorationRole, found.action->icon());
        row->setData(Qt::AccessibleTextRole,
                     QStringList{found.name, row->data(PathRole).toString(), keys}.join(
                         QStringLiteral(", ")));
    }
    if (m_list->count() == 0) {
        auto *none = new QListWidgetItem(m_list);
        none->setData(NameRole, tr("No matching commands"));
        none->setData(PathRole, tr("Try another word"));
        none->setFlags(Qt::NoItemFlags);
    }
    m_list->setCurrentRow(0);
    m_list->scrollToTop();
    place();
}

void CommandSearch::step(int by)
{
    const int last = m_list->count() - 1;
    m_list->setCurrentRow(std::clamp(m_list->currentRow() + by, 0, std::max(0, last)));
}

void CommandSearch::runCurrent()
{
    const QListWidgetItem *row = m_list->currentItem();
    auto *action =
        row ? qobject_cast<QAction *>(row->data(ActionRole).value<QObject *>()) : nullptr;
    if (!action || !action->isEnabled())
        return; // the row says why
    const QPointer<QAction> chosen(action);
    close();
    // When the focus is back where it was: some actions look at it.
    QTimer::singleShot(0, action, [chosen] { chosen->trigger(); });
}

bool CommandSearch::eventFilter(QObject *watched, QEvent *event)
{
    if (watched != m_field || event->type() != QEvent::KeyPress)
        return QFrame::eventFilter(watched, event);
    switch (static_cast<QKeyEvent *>(event)->key()) {
    case Qt::Key_Down:
        step(1);
        return true;
    case Qt::Key_Up:
        step(-1);
        return true;
    case Qt::Key_PageDown:
        step(kRows - 1);
        return true;
    case Qt::Key_PageUp:
        step(1 - kRows);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        runCurrent();
        return true;
    case Qt::Key_Escape:
        close();
        return true;
    default:
        return QFrame::eventFilter(watched, event);
    }
}

void CommandSearch::showEvent(QShowEvent *event)
{
    QFrame::showEvent(event);
    m_field->setFocus();
}

void CommandSearch::place()
{
    const QWidget *window = parentWidget();
    const int width = std::min(kWidth, window->width() - 4 * kMargin);
    const int rows = std::min(m_list->count(), kRows);
    const int listHeight = std::min(rows * kRowHeight + 2, window->height() / 2);
    const int height = kEdge + m_field->minimumHeight() + kEdge + listHeight + kEdge;
    const QPoint top = window->mapToGlobal(QPoint((window->width() - width) / 2, 90));
    setGeometry(top.x(), top.y(), width, height);
}

} // namespace fff::ui
