// F1 where the window's own keys do not reach: over a dialog that waits for an answer, or in an
// open menu. The help opens over it, about what is under the cursor.
#pragma once

#include "ui/help/help_pages.h"

#include <QObject>

#include <functional>

namespace fff::ui {

class HelpKey : public QObject
{
    Q_OBJECT
public:
    using Show = std::function<void(const HelpTopic &topic, QWidget *over)>;

    /// Of what belongs to this window.
    HelpKey(QWidget &window, Show show);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    QWidget &m_window;
    const Show m_show;
};

/// Under the cursor, or with the focus where that is elsewhere; null: nothing of this window.
QWidget *pointedAt(const QWidget &window);

} // namespace fff::ui
