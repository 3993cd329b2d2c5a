// The verdicts on the model, worst first. A click selects the sections that one is about and frames
// them; a problem is marked red in the view. Problems are numbered, here and at their places there.
#pragma once

#include <QDockWidget> // first: moc stumbles over some standard headers

#include "ui/docks/check_entries.h"

#include <vector>

class QLabel;
class QScrollArea;
class QTimer;
class QToolButton;
class QVBoxLayout;

namespace fff {
class CheckList;
struct Stage;
} // namespace fff

namespace fff::ui {

class CheckRow;
class Workbench;

class ChecksDock : public QDockWidget
{
    Q_OBJECT
public:
    ChecksDock(Workbench &bench, const CheckList &list, QWidget *parent = nullptr);

    /// The next problem after the chosen one (step 1), or the one before (−1); round and round.
    void goToProblem(int step);
    /// What a badge asks for: the worst row of this subject.
    void choose(Subject subject);
    /// The row of this one, framed in the view; if there is none any more, the worst of its
    /// subject.
    void choose(const fff::Finding &finding);
    /// In the colours of the theme.
    void refreshColours();

Q_SIGNALS:
    /// For the status bar, with marks.
    void said(const QString &sentence);
    /// The stock editor, with this one, and the field of this name in the hand; empty: none.
    void stockWanted(fff::StockId stock, const QString &field);
    void stepsWanted();
    /// A link was clicked, and the hand goes on in the view.
    void viewWanted();
    /// It wants to be seen.
    void shown();
    /// The one that is looked at; nothing: none.
    void chosenChanged(const std::optional<fff::Finding> &finding);

private:
    void refresh();
    void layRowsOut();
    void refreshFooter();
    const Stage *longWork() const;
    /// The place of it that it looks at.
    void choose(int row, bool frames);
    /// A click on it: where it has several places and one is chosen, the next one.
    void click(int row);
    void forgetChoice();
    void markProblems();
    void showLook();
    const Finding *litFinding() const;
    int rowOf(int number) const; // of a problem; -1: there is none any more
    /// The link at the index was clicked.
    bool act(int row, int index);
    /// The cursor is on it: the view shows what it would make.
    void tryOut(int row, int index, bool isOver);
    void showStock(const Finding &finding, const ActionKind &action);
    void carryOut(const FindingAction &action, const Finding &finding);
    void carryOutWish();
    std::optional<Finding> focusedFinding() const;
    void returnFocus(const Finding &finding);
    /// Of all rows all places: row and place.
    std::vector<std::pair<int, int>> problems() const;
    CheckEntry &entryAt(int row) { return m_rows[static_cast<std::size_t>(row)]; }

    Workbench &m_bench;
    const CheckList &m_list;
    std::vector<CheckEntry> m_rows;
    std::vector<CheckRow *> m_widgets; // as many as rows, or more, hidden
    std::optional<Finding> m_chosen;
    QScrollArea *m_area = nullptr;
    QVBoxLayout *m_column = nullptr;
    QLabel *m_empty = nullptr;
    QWidget *m_footer = nullptr;
    QLabel *m_spinner = nullptr;
    QLabel *m_footerText = nullptr;
    QToolButton *m_stop = nullptr; // what takes long
    QTimer *m_spin = nullptr;
    int m_angle = 0; // degrees, of the spinner
    bool m_isChoosing = false;
    bool m_isTrying = false; // what a link would make is shown, and said
    /// To be done as soon as it is known what that makes of the model that is there.
    std::optional<std::pair<FindingAction, Finding>> m_wish;
};

} // namespace fff::ui
