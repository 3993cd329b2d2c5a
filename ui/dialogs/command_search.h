// "Find an action…": a field over the window, below it what fits the words typed so far, with menu
// and shortcut. Enter runs the chosen one; what cannot be done now says why.
#pragma once

#include "ui/actions/action_finder.h"

#include <QFrame>

class QLineEdit;
class QListWidget;
class QMenuBar;

namespace fff::ui {

class CommandSearch : public QFrame
{
    Q_OBJECT
public:
    /// Over the middle of `window`, near its top. Deletes itself when it is closed.
    CommandSearch(const QMenuBar &menus, QWidget *window);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void fill(const QString &query);
    void runCurrent();
    void step(int by);
    void place();

    QList<ListedAction> m_all;
    QLineEdit *m_field = nullptr;
    QListWidget *m_list = nullptr;
};

} // namespace fff::ui
