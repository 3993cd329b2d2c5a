// The Export panel: what is cut, from which sheets, into which file, and where that goes; the
// sheets as they will be cut; what is to be looked out for. It only asks: who opens it writes the
// file.
//
// What is the document's (thickness, kerf, clearance, sheet) is changed there at once, so that
// slits, checks and sheets follow; all of it is one step of the history, and Cancel takes it back.
#pragma once

#include <QDialog> // first: moc stumbles over some standard headers

#include "core/analysis/finding.h"
#include "ui/dialogs/cut_time.h"
#include "ui/dialogs/export_choices.h"

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QScrollArea;

namespace fff {
class CheckList;
}

namespace fff::ui {

class ExportPlace;
class ExportPreview;
class ExportQuestions;
class ExportRows;
struct ExportRemark;
class RemarkRows;
class StockEdits;
class Workbench;

class ExportDialog : public QDialog
{
    Q_OBJECT
public:
    /// files  at least one
    ExportDialog(Workbench &bench, const CheckList &checks, std::vector<ExportFile> files,
                 ExportPlace &place, QWidget *parent);
    ~ExportDialog() override;

    /// Once it was accepted. The choices are kept for the next time.
    const ExportFile &file() const;
    const ExportChoices &choices() const { return m_choices; }

    /// What is to be shown of the model in its place: a problem, or sections.
    const std::optional<Finding> &problem() const { return m_problem; }
    const std::vector<SectionRef> &sections() const { return m_sections; }

    void reject() override;
    /// What came of it.
    void tellOfCoupon(const QString &sentence);

Q_SIGNALS:
    void couponWanted();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    QWidget *makeChoices(std::vector<ExportFile> files);
    QWidget *makeFoot();
    void refresh();
    void refreshFoot();
    QString afterIt();
    void takeLeastWidth();
    void takeLook();
    void takeFile();
    void showPlace();
    void changePlace();
    void showOf(const ExportRemark &remark);
    void goOn();

    Workbench &m_bench;
    const CheckList &m_checks;
    ExportPlace &m_place;
    ExportChoices m_choices;
    StockEdits *m_stocks = nullptr;
    CuttingWork *m_work = nullptr;
    CutTime m_time;
    ExportQuestions *m_questions = nullptr;
    ExportRows *m_rows = nullptr;
    ExportPreview *m_preview = nullptr;
    RemarkRows *m_remarks = nullptr;
    QLabel *m_foot = nullptr;
    QCheckBox *m_opensFolder = nullptr;
    QPushButton *m_export = nullptr;
    std::optional<Finding> m_problem;
    std::vector<SectionRef> m_sections;
};

} // namespace fff::ui
