// The menu of the models that were open last. Those that are gone are named and can be taken off.
#pragma once

#include <QMenu>

namespace fff::ui {

class RecentMenu : public QMenu
{
    Q_OBJECT
public:
    explicit RecentMenu(QWidget *parent = nullptr);

Q_SIGNALS:
    /// Also for one that is gone.
    void chosen(const QString &path);

private:
    void rebuild();
};

} // namespace fff::ui
