// Files that are dragged onto a window.
#pragma once

#include <QObject>
#include <QStringList>

class QWidget;

namespace fff::ui {

class FileDrop : public QObject
{
    Q_OBJECT
public:
    /// Anywhere on the window where nothing else takes them.
    explicit FileDrop(QWidget &window);

Q_SIGNALS:
    void dropped(const QStringList &paths);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace fff::ui
