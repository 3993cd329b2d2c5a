// Every action of the window, made from one table: id, text, shortcut, icon. Menus and tool bar are
// lists of ids. The ids are those of the command registry (core/interaction/commands.h).
#pragma once

#include <QAction>
#include <QHash>
#include <QObject>

#include <initializer_list>

class QMenu;
class QToolBar;

namespace fff::ui {

class Workbench;

class ActionSet : public QObject
{
    Q_OBJECT
public:
    explicit ActionSet(Workbench &bench, QObject *parent = nullptr);

    QAction *action(const char *id) const;
    /// An empty id is a separator.
    void fill(QMenu *menu, std::initializer_list<const char *> ids) const;
    void fill(QToolBar *bar, std::initializer_list<const char *> ids) const;
    /// Single letters and digits work only while this widget has the focus.
    void addViewShortcuts(QWidget *view) const;

Q_SIGNALS:
    void triggered(const QString &id);

private:
    void refresh();
    void setAble(const char *id, bool able, const QString &whyNot);

    Workbench &m_bench;
    QHash<QString, QAction *> m_actions;
};

} // namespace fff::ui
