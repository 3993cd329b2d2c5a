// The numbers of what is selected, or of the model when nothing is; one page for each. Rows read
// from the session and write through edits, one undo step each (ui/properties/property_rows.h).
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "core/analysis/finding.h"

#include <QTimer>

namespace fff {
class CheckList;
}

namespace fff::ui {

class DrawingPage;
class JointPage;
class LoadPage;
class ModelPage;
class OperationPage;
class ProblemBox;
class PropertiesHeader;
class SectionPage;
class Workbench;

class PropertiesDock : public QDockWidget
{
    Q_OBJECT
public:
    PropertiesDock(Workbench &bench, const CheckList &list, QWidget *parent = nullptr);

    /// Reads everything again; also for another theme.
    void refresh();
    /// The problem that is looked at among the checks; nothing: none.
    void setChosen(const std::optional<fff::Finding> &finding);

Q_SIGNALS:
    /// The stock editor shall show this one.
    void stockWanted(fff::StockId stock);

private:
    void follow();
    void tellProblem();

    Workbench &m_bench;
    const CheckList &m_list;
    std::optional<Finding> m_chosen;
    PropertiesHeader *m_header = nullptr;
    ProblemBox *m_problem = nullptr; // of a single section
    ModelPage *m_modelPage = nullptr;
    SectionPage *m_sectionPage = nullptr;
    JointPage *m_jointPage = nullptr;
    LoadPage *m_loadPage = nullptr;
    OperationPage *m_operationPage = nullptr;
    DrawingPage *m_drawingPage = nullptr; // while a stroke is drawn
    QTimer m_soon;                        // refreshes once all that came at once is in
};

} // namespace fff::ui
