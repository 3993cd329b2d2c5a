// Every action of a window: one for each command that has words for people. What it is called, when
// it can run and whether it is on the command says itself (core/interaction/commands.h). Menus and
// tool bar are lists of ids (menu_table.h). Shortcuts are the command's, or those that a person has
// set; a change of them is followed at once, in all windows.
#pragma once

#include <QAction>
#include <QHash>
#include <QKeySequence>
#include <QObject>

#include <functional>
#include <initializer_list>

class QMenu;
class QMenuBar;
class QToolBar;

namespace fff {
struct CommandWords;
}

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
    void fill(QMenuBar *bar, const std::function<void(const QString &id, QMenu *menu)> &own);
    /// The menu of the table with this key, without what cannot be done now; `own` as above.
    void fill(QMenu *menu, const char *key,
              const std::function<void(const QString &id, QMenu *menu)> &own = {});
    /// Single letters and digits work only while this widget has the focus.
    void addViewShortcuts(QWidget *view);

    /// Not one that the window has beside the commands: a dock's, a recent file's.
    static bool isOfCommand(const QAction *action);
    /// As the program has them, whatever a person has set.
    static QList<QKeySequence> ownShortcuts(const QAction *action);
    /// What an action does, or why it cannot be done now.
    static QString sentence(const QAction *action);

    /// What can be done now, what is checked, and what is shown at all (CommandRegistry::limit).
    void refresh();

Q_SIGNALS:
    void triggered(const QString &id);
    /// The key of a command that is not shown was pressed; why it is not.
    void refused(const QString &sentence);

private:
    struct Entry
    {
        QAction *action = nullptr;
        const CommandWords *words = nullptr;
        QString text;              // with its key in the menus
        QAction *answer = nullptr; // to its keys, while it is not shown; null: it always was
    };
    void giveKeys(const QList<QAction *> &menu);
    static QMenu *named(QMenu *menu, const MenuRow &row);
    void fill(QMenu *menu, const MenuRow &row,
              const std::function<void(const QString &id, QMenu *menu)> &own) const;
    void show(Entry &entry);
    void showAnswer(Entry &entry, bool answers);
    void applyShortcuts();
    static void setTip(QAction *action, const QString &sentence);

    Workbench &m_bench;
    QHash<QString, Entry> m_actions;
    QWidget *m_window = nullptr, *m_view = nullptr; // where keys are pressed
};

} // namespace fff::ui
