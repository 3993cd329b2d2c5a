// The questions of the Export panel: which stock, which sheet, which machine, which file. What is
// the document's is changed there at once, as a step of the history.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/fabrication/layout.h"
#include "ui/dialogs/export_choices.h"
#include "ui/dialogs/file_question.h"
#include "ui/dialogs/stock_edits.h"

#include <memory>
#include <vector>

class QLabel;

namespace fff::ui {

class ChoiceBox;
class ExportPlaceRow;
class LengthEdit;
class LinkRow;
class QuestionRow;

class ExportQuestions : public QWidget
{
    Q_OBJECT
public:
    /// files   at least one
    /// chosen  keys: the one that is chosen, and what was chosen before of other uses
    /// choices changed as a person chooses; it outlives this
    ExportQuestions(StockEdits &stocks, ExportChoices &choices, std::vector<ExportFile> files,
                    const QStringList &chosen, QWidget *parent = nullptr);

    const ExportFile &file() const { return m_file->file(); }
    /// As they are given, with what is chosen now.
    QStringList chosenFiles() const { return m_file->chosen(); }
    /// Where it goes, below which it is.
    ExportPlaceRow &place() { return *m_place; }
    void refresh();
    /// How parts lie, for what is said of offcuts; null: not known.
    void setLayout(std::shared_ptr<const Layout> layout);
    /// px, with all answers in sight.
    int leastWidth() const;

Q_SIGNALS:
    void fileChanged();
    void machineChanged();

private:
    QuestionRow *makeStock();
    QuestionRow *makeSheet();
    QuestionRow *makeMachine();
    void chooseMachine(int choice);
    void measure();
    LengthEdit *makeSide(int axis);
    void chooseSheet(int choice);

    void refreshStock();
    void refreshSheet();
    void refreshOffcuts();
    void refreshMachine();

    StockEdits &m_stocks;
    ExportChoices &m_choices;
    std::vector<QuestionRow *> m_questions;
    QuestionRow *m_sheetQuestion = nullptr, *m_machineQuestion = nullptr;
    ChoiceBox *m_machineBox = nullptr;
    LinkRow *m_measure = nullptr;
    QLabel *m_offcuts = nullptr;
    std::shared_ptr<const Layout> m_layout;
    bool m_measuresAgain = false;
    ChoiceBox *m_stockBox = nullptr; // of several
    QLabel *m_onlyStock = nullptr;   // in its place, where there is one
    QWidget *m_measured = nullptr;
    LengthEdit *m_thickness = nullptr;
    ChoiceBox *m_sheetBox = nullptr;
    QWidget *m_ownSheet = nullptr;
    LengthEdit *m_sides[2] = {nullptr, nullptr};
    FileQuestion *m_file = nullptr;
    ExportPlaceRow *m_place = nullptr;
    StockId m_ownSizeOf; // the stock for which a size of one's own was asked for
};

} // namespace fff::ui
