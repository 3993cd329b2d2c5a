#include "ui/dialogs/shortcut_editor.h"

#include "ui/actions/action_set.h"
#include "ui/dialogs/key_recorder.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr int kRowHeight = 24; // px

bool isForView(const QAction &action)
{
    return action.shortcutContext() == Qt::WidgetShortcut;
}

QString inWords(const QList<QKeySequence> &keys)
{
    QStringList words;
    for (const QKeySequence &each : keys)
        words += each.toString(QKeySequence::NativeText);
    return words.join(QStringLiteral("  "));
}

} // namespace

ShortcutEditor::ShortcutEditor(const QList<ListedAction> &actions, QWidget *parent)
    : QWidget(parent), m_keys(actions)
{
    m_filter = new QLineEdit(this);
    m_filter->setObjectName(QStringLiteral("shortcutFilter"));
    m_filter->setPlaceholderText(tr("Filter by name or keys"));
    m_filter->setAccessibleName(tr("Filter by name or keys"));
    m_filter->setClearButtonEnabled(true);
    makeTree(actions);
    m_title = new QLabel(this);
    m_title->setTextFormat(Qt::PlainText);
    m_recorder = new KeyRecorder(this);
    m_recorder->setObjectName(QStringLiteral("shortcutRecorder"));
    m_title->setBuddy(m_recorder);
    m_remove = new QPushButton(tr("Remove"), this);
    m_remove->setObjectName(QStringLiteral("shortcutRemove"));
    m_remove->setToolTip(tr("No keys for this command"));
    m_reset = new QPushButton(tr("Reset"), this);
    m_reset->setObjectName(QStringLiteral("shortcutReset"));
    m_reset->setToolTip(tr("The original keys of this command"));
    auto *all = new QPushButton(tr("Reset all"), this);
    all->setObjectName(QStringLiteral("shortcutResetAll"));
    all->setToolTip(tr("The original keys of all commands"));
    m_note = new QLabel(this);
    m_note->setObjectName(QStringLiteral("shortcutNote"));
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    m_take = new QPushButton(tr("Use it here"), this);
    m_take->setObjectName(QStringLiteral("shortcutTake"));

    for (QPushButton *button : {m_remove, m_reset, all, m_take})
        button->setAutoDefault(false); // Enter in the field presses none of them

    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(m_filter, 0, 0, 1, 4);
    grid->addWidget(m_tree, 1, 0, 1, 4);
    grid->addWidget(m_title, 2, 0, 1, 4);
    grid->addWidget(m_recorder, 3, 0);
    grid->addWidget(m_remove, 3, 1);
    grid->addWidget(m_reset, 3, 2);
    grid->addWidget(all, 3, 3);
    grid->addWidget(m_note, 4, 0, 1, 3);
    grid->addWidget(m_take, 4, 3, Qt::AlignTop);
    grid->setRowMinimumHeight(4, 2 * fontMetrics().height() + 8);
    grid->setRowStretch(1, 1);
    grid->setColumnStretch(0, 1);

    connect(m_filter, &QLineEdit::textChanged, this, &ShortcutEditor::filter);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &ShortcutEditor::showCurrent);
    connect(m_tree, &QTreeWidget::itemActivated, m_recorder, [this] { m_recorder->setFocus(); });
    connect(m_recorder, &KeyRecorder::recorded, this, &ShortcutEditor::recorded);
    connect(m_remove, &QPushButton::clicked, this, [this] { assign({}); });
    connect(m_reset, &QPushButton::clicked, this, &ShortcutEditor::resetCurrent);
    connect(all, &QPushButton::clicked, this, &ShortcutEditor::resetAll);
    connect(m_take, &QPushButton::clicked, this, [this] { assign({m_wanted}); });
    refresh();
    if (QTreeWidgetItem *first = m_tree->topLevelItem(0))
        m_tree->setCurrentItem(first->child(0));
}

void ShortcutEditor::makeTree(const QList<ListedAction> &actions)
{
    m_tree = new QTreeWidget(this);
    m_tree->setObjectName(QStringLiteral("shortcutTree"));
    m_tree->setAccessibleName(tr("Commands and their shortcuts"));
    m_tree->setHeaderLabels({tr("Command"), tr("Shortcut"), tr("Works")});
    m_tree->setRootIsDecorated(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setMinimumHeight(160);
    QHash<QString, QTreeWidgetItem *> menus;
    for (const ListedAction &each : actions) {
        if (!each.action || !ActionSet::isOfCommand(each.action))
            continue;
        m_actions += each;
        QTreeWidgetItem *&menu = menus[each.menuPath];
        if (!menu) {
            menu = new QTreeWidgetItem(m_tree, {each.menuPath});
            menu->setFlags(Qt::ItemIsEnabled);
            menu->setFirstColumnSpanned(true);
            menu->setExpanded(true);
            menu->setSizeHint(0, {0, kRowHeight});
        }
        auto *item = new QTreeWidgetItem(menu);
        // Without what it would be done to just now: Undo, not Undo "Draw Body".
        item->setText(0, nameOf(each.id));
        item->setIcon(0, each.action->icon());
        item->setText(2, isForView(*each.action) ? tr("in the view") : tr("everywhere"));
        item->setData(0, kIdRole, each.id);
        item->setSizeHint(0, {0, kRowHeight});
    }
    m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    m_tree->header()->setStretchLastSection(false);
}

QString ShortcutEditor::nameOf(const QString &id) const
{
    for (const ListedAction &each : m_actions) {
        if (each.id == id &&
            (id == QStringLiteral("edit.undo") || id == QStringLiteral("edit.redo")))
            return each.action->iconText();
        if (each.id == id)
            return each.name;
    }
    return id;
}

void ShortcutEditor::filter(const QString &text)
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem *menu = m_tree->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < menu->childCount(); ++j) {
            QTreeWidgetItem *item = menu->child(j);
            const ListedAction listed{nullptr, item->text(0), menu->text(0),
                                      item->data(0, kIdRole).toString()};
            const bool fits =
                matchScore(text, listed) >= 0 || item->text(1).contains(text, Qt::CaseInsensitive);
            item->setHidden(!fits);
            any = any || fits;
        }
        menu->setHidden(!any);
    }
}

QString ShortcutEditor::currentId() const
{
    const QTreeWidgetItem *item = m_tree->currentItem();
    return item ? item->data(0, kIdRole).toString() : QString();
}

void ShortcutEditor::showCurrent()
{
    const QString id = currentId();
    const QList<QKeySequence> keys = m_keys.of(id);
    m_title->setText(id.isEmpty() ? tr("Choose a command") : tr("Keys for %1:").arg(nameOf(id)));
    m_recorder->setAccessibleName(m_title->text());
    m_recorder->setText(inWords(keys));
    m_recorder->setEnabled(!id.isEmpty());
    m_remove->setEnabled(!keys.isEmpty());
    m_reset->setEnabled(!id.isEmpty() && m_keys.isChanged(id));
    say({});
}

void ShortcutEditor::refresh()
{
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        QTreeWidgetItem *menu = m_tree->topLevelItem(i);
        for (int j = 0; j < menu->childCount(); ++j) {
            QTreeWidgetItem *item = menu->child(j);
            const QString id = item->data(0, kIdRole).toString();
            item->setText(1, inWords(m_keys.of(id)));
            QFont font = item->font(1);
            font.setBold(m_keys.isChanged(id));
            item->setFont(1, font);
            item->setToolTip(1, font.bold() ? tr("Changed by you") : QString());
        }
    }
}

void ShortcutEditor::recorded(const QKeySequence &keys)
{
    const QString id = currentId();
    const auto each = std::find_if(m_actions.begin(), m_actions.end(),
                                   [&id](const ListedAction &listed) { return listed.id == id; });
    if (each == m_actions.end())
        return;
    if (isTypingKey(keys) && !isForView(*each->action)) {
        say(tr("%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are "
               "for commands that work in the view.")
                .arg(keys.toString(QKeySequence::NativeText)));
        return;
    }
    const QString owner = m_keys.ownerOf(keys, id);
    if (!owner.isEmpty()) {
        say(tr("%1 belongs to “%2”.").arg(keys.toString(QKeySequence::NativeText), nameOf(owner)),
            keys);
        return;
    }
    assign({keys});
}

void ShortcutEditor::assign(const QList<QKeySequence> &keys)
{
    m_keys.assign(currentId(), keys);
    m_keys.store();
    refresh();
    showCurrent();
}

void ShortcutEditor::resetCurrent()
{
    m_keys.reset(currentId());
    m_keys.store();
    refresh();
    showCurrent();
}

void ShortcutEditor::resetAll()
{
    settings().resetShortcuts();
    m_keys = ShortcutKeys(m_actions); // these follow the settings at once
    refresh();
    showCurrent();
}

void ShortcutEditor::say(const QString &sentence, const QKeySequence &wanted)
{
    m_note->setText(sentence);
    m_wanted = wanted;
    m_take->setVisible(!wanted.isEmpty());
}

} // namespace fff::ui
