// The page of the settings where shortcuts are looked up and changed. A change is there at once, in
// all windows. Keys that another action has are never taken without saying from which.
#pragma once

#include "ui/actions/action_finder.h"
#include "ui/dialogs/shortcut_keys.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace fff::ui {

class KeyRecorder;

class ShortcutEditor : public QWidget
{
    Q_OBJECT
public:
    /// Names and order are those of the menus.
    explicit ShortcutEditor(const QList<ListedAction> &actions, QWidget *parent = nullptr);

private:
    void makeTree(const QList<ListedAction> &actions);
    void filter(const QString &text);
    void showCurrent();
    void refresh();
    void recorded(const QKeySequence &keys);
    void assign(const QList<QKeySequence> &keys);
    void resetCurrent();
    void resetAll();
    void say(const QString &sentence, const QKeySequence &wanted = {});
    QString currentId() const;
    QString nameOf(const QString &id) const;

    ShortcutKeys m_keys;
    QList<ListedAction> m_actions; // those of commands
    QLineEdit *m_filter = nullptr;
    QTreeWidget *m_tree = nullptr;
    QLabel *m_title = nullptr;
    KeyRecorder *m_recorder = nullptr;
    QPushButton *m_remove = nullptr, *m_reset = nullptr;
    QLabel *m_note = nullptr;
    QPushButton *m_take = nullptr;
    QKeySequence m_wanted; // of which m_note says who has it
};

} // namespace fff::ui
