// Every action of a window, made from the one table (action_table.h). Menus and tool bar are lists
// of ids, which are those of the command registry. Shortcuts are the table's, or those that a
// person has set; a change of them is followed at once, in all windows.
#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QObject>
#include <QSet>

#include <functional>
#include <initializer_list>

class QMenu;
class QMenuBar;
class QToolBar;

namespace fff::ui {

class Workbench;
struct MenuRow;

class ActionSet : public QObject
{
    Q_OBJECT
public:
    explicit ActionSet(Workbench &bench, QObject *parent = nullptr);

    QAction *action(const char *id) const;
    /// An empty id is a separator.
    void fill(QMenu *menu, std::initializer_list<const char *> ids) const;
    void fill(QToolBar *bar, std::initializer_list<const char *> ids) const;
    /// The menus of the table; `own` adds what the window has for an id that begins with "@".
    void fill(QMenuBar *bar, const std::function<void(const QString &id, QMenu *menu)> &own) const;
    /// The menu of the table with this key, without what cannot be done now.
    void fill(QMenu *menu, const char *key) const;
    /// Single letters and digits work only while this widget has the focus.
    void addViewShortcuts(QWidget *view) const;

    /// As the program has them, and as they are set.
    static QList<QKeySequence> ownShortcuts(const QString &id);
    static QList<QKeySequence> shortcuts(const QString &id);
    /// What an action does, or why it cannot be done now.
    static QString sentence(const QAction *action);

    void setAble(const char *id, bool able, const QString &whyNot);
    /// What was asked for and is not there yet is checked, too: asking again takes it back.
    void setWaiting(const char *id, bool waits);
    /// What can be done now, and what is checked.
    void refresh();

Q_SIGNALS:
    void triggered(const QString &id);

private:
    void fill(QMenu *menu, const MenuRow &row,
              const std::function<void(const QString &id, QMenu *menu)> &own) const;
    void applyShortcuts();
    static void setTip(QAction *action, const QString &sentence);

    Workbench &m_bench;
    QHash<QString, QAction *> m_actions;
    QSet<QString> m_waiting;
};

} // namespace fff::ui
