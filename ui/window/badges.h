// The verdicts as pills over the view, at its upper left: a click shows the row in the Checks dock.
// They are widgets of their own, so that a change of them costs the view no frame.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/analysis/finding.h"

#include <vector>

namespace fff {
class CheckList;
}

namespace fff::ui {

class Badge;
class Workbench;

class Badges : public QWidget
{
    Q_OBJECT
public:
    /// What stands under them begins there, px.
    static constexpr int kBelow = 43;

    /// Stands over `view` and follows its size.
    Badges(Workbench &bench, const CheckList &list, QWidget *view);

    /// In the colours of the theme.
    void refreshColours();

Q_SIGNALS:
    /// sentence  that says it in full
    void clicked(fff::Subject subject, const QString &sentence);

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void refresh();
    void order();
    void fold();

    Workbench &m_bench;
    const CheckList &m_list;
    std::vector<Badge *> m_badges; // one a subject
    std::vector<Badge *> m_row;    // the same as they stand there
    bool m_isDrawing = false;      // a stroke: the verdicts are on what it would make
};

} // namespace fff::ui
