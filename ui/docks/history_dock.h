// Every step that was done, the newest at the bottom. A click goes back to any of them, or on
// again; what the step under the cursor changed is outlined in the view.
#pragma once

#include <QDockWidget>

class QLabel;
class QUndoView;

namespace fff::ui {

class Workbench;

class HistoryDock : public QDockWidget
{
    Q_OBJECT
public:
    explicit HistoryDock(Workbench &bench, QWidget *parent = nullptr);

    /// In the colours of the theme.
    void refreshColours();

Q_SIGNALS:
    /// What a jump did, for the status bar, with marks.
    void said(const QString &sentence);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void refresh();
    void hoverStep(int row);
    void leaveSteps();

    Workbench &m_bench;
    QUndoView *m_view = nullptr;
    QLabel *m_empty = nullptr;
};

} // namespace fff::ui
